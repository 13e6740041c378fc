//! Numbers that are wrong.

use linkage_analysis::tolerance::{ToleranceError, Tolerances};

use super::{lengths, ones};

fn refused(tolerances: &[f64]) -> String {
    let error = Tolerances::<3>::new(&lengths::<3>(), tolerances);
    error.expect_err("it is wrong").to_string()
}

#[test]
fn bad_tolerances_are_named() {
    let rule = "it must be finite and not negative";
    assert_eq!(
        refused(&[0.1, -0.2, 0.3]),
        format!("the tolerance of b is -0.2: {rule}")
    );
    assert_eq!(
        refused(&[0.1, 0.2, f64::NAN]),
        format!("the tolerance of c is NaN: {rule}")
    );
    assert_eq!(
        refused(&[f64::INFINITY; 3]),
        format!("the tolerance of a is inf: {rule}")
    );
}

#[test]
fn counts_must_match() {
    assert_eq!(refused(&[0.1; 2]), "2 tolerances for 3 parameters");
    assert_eq!(
        Tolerances::<4>::declared(&lengths::<3>()),
        Err(ToleranceError::Count {
            what: "parameters",
            expected: 4,
            found: 3
        })
    );
}

#[test]
fn missing_tolerances_are_listed() {
    let mut parameters = lengths::<4>();
    (parameters[1].tolerance, parameters[3].tolerance) = (0.0, 0.0);
    assert!(Tolerances::<4>::declared(&parameters).is_ok());
    let error = Tolerances::<4>::complete(&parameters).expect_err("two are missing");
    assert_eq!(error.to_string(), "no tolerance is given for b, d");
}

#[test]
fn selection() {
    let some = ones::<5>().select([3, 0]).expect("they exist");
    assert_eq!(some.parameters().map(|p| p.name), ["d", "a"]);
    let error = ones::<5>().select([5]).expect_err("it does not exist");
    assert_eq!(
        error.to_string(),
        "there is no parameter 5: there are 5, counted from 0"
    );
}
