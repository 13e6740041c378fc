//! All that is wrong is told.

use super::{FourBar, FourBarAssembly, LENGTHS, Outcome, drawn, inputs, points};
use linkage::design::{DesignError, Identification, Measured};
use linkage_random::Random;

#[test]
fn all_that_is_wrong_is_told() -> Outcome {
    let at = inputs(3);
    let read = || Measured::new("b", [[1.0, 2.0]; 3]).at_inputs(inputs(3));
    let path = FourBarAssembly::path_sweep_sets_into;
    let error = drawn()?
        .unknown(["crank", "rod", "crank"])
        .vary("rocker", 3.0, 2.0)
        .measured(
            Measured::new("c", [[1.0]])
                .at_inputs([0.0, 1.0])
                .deviations([-1.0])
                .computed_by(path),
        )
        .measured(read().computed_by(FourBarAssembly::some_sweep_sets_into))
        .run();
    let text = error.unwrap_err().to_string();
    for part in [
        "there is no parameter `rod`; the mechanism has pivot_a.x, ",
        "`crank` is listed twice",
        "the bounds of `rocker` contradict each other",
        "c: 2 inputs, where 1 are needed",
        "the standard deviation of `c` is -1: it must be positive and finite",
        "has no quantity `c`",
        "no derivatives of `b` by rocker",
        "no standard deviations are given for b, but for others",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let missing = Measured::new("b", [[f64::NAN; 2]; 3]).at_inputs(at);
    let error = drawn()?
        .unknown(LENGTHS)
        .measured(missing.computed_by(path))
        .run();
    assert!(
        error
            .unwrap_err()
            .to_string()
            .contains("all readings are missing")
    );
    let short = FourBar {
        crank: 5.0,
        coupler: 90.0,
        ..FourBar::default()
    };
    let assembly = FourBar::default().assemble()?;
    let error = Identification::new(
        FourBar {
            coupler: 30.0,
            ..short
        },
        assembly,
    )
    .unknown(LENGTHS)
    .measured(read().computed_by(path))
    .run();
    let text = error.unwrap_err().to_string();
    assert!(
        text.starts_with("the mechanism that the fit begins with does not assemble"),
        "{text}"
    );
    // Fewer readings than unknowns are no mistake: what they leave open is told.
    let one = Measured::new("b", points(&[0.3])?)
        .at_inputs([0.3])
        .deviations([0.01; 2]);
    let found = drawn()?
        .unknown(LENGTHS)
        .measured(one.computed_by(path))
        .run()?;
    assert_eq!((found.degrees_of_freedom, found.undetermined.len()), (0, 1));
    Ok(())
}

/// Bounds that are one number hold a parameter there: no mistake.
#[test]
fn numbers_of_the_case_are_told() -> Outcome {
    // The end of its crank is up to 230 mm from the other pivot, coupler and rocker together are 220 mm.
    let long = FourBar {
        crank: 90.0,
        shim: 0.0,
        pivot_a: [10.0, 8.0].into(),
        zero: 0.0,
        ..FourBar::default()
    };
    let read = Measured::new("b", [[1.0, 2.0]; 4]).at_inputs(inputs(4));
    let error = Identification::new(long, FourBar::default().assemble()?)
        .unknown(LENGTHS)
        .measured(read.computed_by(FourBarAssembly::path_sweep_sets_into))
        .run();
    assert_eq!(
        error.unwrap_err().to_string(),
        "the mechanism that the fit begins with does not assemble, or stands at a dead point, for 2 of 8 readings, \
         the first at input 3.14159; begin with dimensions that are nearer"
    );
    assert_eq!(
        DesignError::Unsettled { steps: 1000 }.to_string(),
        "no least sum of squares in 1000 evaluations, which is our limit; give bounds with `vary`, or begin nearer"
    );

    let at = inputs(12);
    let read = Measured::new("b", points(&at)?)
        .at_inputs(at)
        .deviations([0.01; 2]);
    let found = drawn()?
        .vary("crank", 50.2, 50.2)
        .unknown(["coupler", "rocker"])
        .measured(read.computed_by(FourBarAssembly::path_sweep_sets_into))
        .run()?;
    assert!((found.mechanism.crank - 50.2).abs() < 1e-12);
    assert!((found.mechanism.rocker - 100.1).abs() < 1e-6, "{found}");
    Ok(())
}

/// Readings that have nothing to do with the mechanism pull it to where it falls apart: some fits end nowhere. As the message says, bounds help.
#[test]
fn readings_of_something_else_may_have_no_best_fit() -> Outcome {
    let mut random = Random::new(1);
    let mut unsettled = 0;
    for _ in 0..60 {
        let at = inputs(12);
        let far = |[x, y]: [f64; 2], random: &mut Random| {
            [x, y].map(|x| x + random.between(-1000.0, 1000.0))
        };
        let read: Vec<[f64; 2]> = points(&at)?
            .into_iter()
            .map(|b| far(b, &mut random))
            .collect();
        let read = || {
            let read = Measured::new("b", read.iter().copied()).at_inputs(inputs(12));
            read.computed_by(FourBarAssembly::path_sweep_sets_into)
        };
        match drawn()?.unknown(LENGTHS).measured(read()).run() {
            Ok(_) => continue,
            Err(DesignError::Unsettled { steps: 1000 }) => unsettled += 1,
            Err(other) => return Err(other.into()),
        }
        let values = [50.0, 120.0, 100.0];
        let bounded = LENGTHS.iter().zip(values).fold(drawn()?, |fit, (name, x)| {
            fit.vary(name, 0.98 * x, 1.02 * x)
        });
        bounded.measured(read()).run()?;
    }
    assert!(unsettled > 0 && unsettled < 30, "{unsettled}");
    Ok(())
}
