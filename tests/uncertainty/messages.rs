//! What does not fit is told.

use super::{CrankRocker, Outcome, near, quantities};
use linkage::tolerance::{Distribution, MonteCarlo, ToleranceError, Tolerances, Uncertainties};

#[test]
fn what_does_not_fit_is_told() -> Outcome {
    let rods = quantities([("a", 1.0), ("b", 1.0), ("c", 1.0)]);
    let tolerances = Tolerances::<3>::new(&rods, &[0.3; 3])?;
    let uncertain = Uncertainties::new(&tolerances, Distribution::Normal);
    let told = |error: ToleranceError, text: &str| assert_eq!(error.to_string(), text);
    told(
        uncertain
            .correlations(&[(0, 1, 0.9), (0, 2, 0.9), (1, 2, 0.0)])
            .unwrap_err(),
        "the correlations of c contradict those of the parameters before it: they leave -3.26316 of its variance, and no \
         variance is negative",
    );
    told(
        uncertain.correlations(&[(0, 1, 1.1)]).unwrap_err(),
        "the correlation of a and b is 1.1: it must be between -1 and 1",
    );
    told(
        uncertain.correlations(&[(2, 2, 1.0)]).unwrap_err(),
        "a correlation of c with itself, 1",
    );
    told(
        uncertain.standard(1, -0.1).unwrap_err(),
        "the standard uncertainty of b is -0.1: it must be finite and not negative",
    );
    told(
        uncertain.degrees_of_freedom(0, 0.5).unwrap_err(),
        "a has 0.5 degrees of freedom: one at least, or infinity",
    );
    told(
        tolerances.limits(0, 0.2, -0.1).unwrap_err(),
        "the limits of a are 0.2 and -0.1: they must be finite, the lower one first",
    );
    told(
        Uncertainties::covariance(&rods, &[[1.0, 0.5, 0.0], [0.4, 1.0, 0.0], [0.0, 0.0, 1.0]])
            .unwrap_err(),
        "the covariance of a and b is 0.5, that of b and a is 0.4",
    );
    let uniform = uncertain.distribution_of(1, Distribution::Uniform)?;
    let correlated = uniform.correlations(&[(0, 1, 0.3)])?;
    let crank = CrankRocker::default();
    let seven = Tolerances::<7>::complete(CrankRocker::PARAMETERS)?;
    let seven = Uncertainties::new(&seven, Distribution::Uniform).correlations(&[(2, 3, 0.3)])?;
    let error = MonteCarlo::new(10).run_correlated(&crank, &seven, |_, [_x]: [&mut [f64]; 1]| {});
    assert_eq!(
        error.unwrap_err(),
        ToleranceError::NotNormal { name: "crank" }
    );
    // Degrees of freedom of what is correlated are not defined, and no factor is made up.
    let few = correlated.degrees_of_freedom(0, 4.0)?;
    let budget = few.budget(&[1.0, 1.0, 1.0]);
    assert!(budget.degrees_of_freedom(0).is_nan() && budget.coverage_factor(0, 0.95).is_nan());
    // But what does not contribute does not matter.
    let budget = few.budget(&[0.0, 1.0, 1.0]);
    assert!(budget.degrees_of_freedom(0).is_infinite());
    near(
        budget.coverage_factor(0, 0.95),
        1.959_963_984_540_054,
        1e-14,
    );
    Ok(())
}
