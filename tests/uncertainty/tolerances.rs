//! Accuracy analysis of generated mechanisms.

use super::{CrankRocker, Outcome, near, quantities};
use linkage::tolerance::{
    Addition, AllocationRule, Distribution, MonteCarlo, Requirement, ToleranceError, Tolerances,
    Uncertainties, largest,
};
use linkage::{Dimensions, Vector2, mechanism};
use std::f64::consts::TAU;

mechanism! {
    struct Ratio {
        input phi = 0deg;
        let psi = 2 * phi;
    }
    impl Ratio {
        fn angle(phi) -> RatioAngle { psi }
    }
}

#[test]
fn dimensions_as_numbers() {
    let mechanism = CrankRocker::default();
    let values = mechanism.values();
    assert_eq!(values[..6], [140.0, 5.0, 50.0, 120.0, 100.0, 70.0]);
    assert_eq!(CrankRocker::from_values(&values), mechanism);
    let mut longer = values;
    longer[CrankRocker::INDEX_PIVOT_Y] = 6.0;
    assert_eq!(CrankRocker::from_values(&longer).pivot.y, 6.0);
    let names = <CrankRocker as Dimensions<7>>::PARAMETERS
        .iter()
        .map(|p| p.name);
    assert!(names.eq([
        "pivot.x", "pivot.y", "crank", "coupler", "rocker", "arm", "lift"
    ]));
    assert_eq!(Ratio::from_values(&[]).values(), [0.0; 0]);
}

/// The worst errors are those of mechanisms that have them.
#[test]
fn the_worst_mechanism() -> Outcome {
    let nominal = CrankRocker::default();
    let linkage = nominal.assemble()?;
    let tolerances = Tolerances::complete(CrankRocker::PARAMETERS)?;
    for degrees in (0..360).step_by(15) {
        let phi = f64::from(degrees).to_radians();
        let effects = tolerances.effects(&linkage.accuracy(phi).e);
        let (vector, signs) = effects.worst_vector();
        let mut values = nominal.values();
        for ((value, sign), tolerance) in values.iter_mut().zip(signs).zip(tolerances.values()) {
            *value += sign * tolerance;
        }
        let worst = CrankRocker::from_values(&values).assemble()?;
        let error = worst.path(phi).tracer - linkage.path(phi).tracer;
        assert!((error.x - vector[0]).hypot(error.y - vector[1]) < 1e-3 * error.norm());
        assert!((error.norm() / effects.worst_modulus() - 1.0).abs() < 1e-3);
    }
    Ok(())
}

#[test]
fn some_parameters_only() -> Outcome {
    let linkage = CrankRocker::default().assemble()?;
    let all = Tolerances::<7>::complete(CrankRocker::PARAMETERS)?;
    let rods = all.select([CrankRocker::INDEX_COUPLER, CrankRocker::INDEX_ROCKER])?;
    let accuracy = linkage.accuracy(1.0);
    let of_all = all.effects(&accuracy.e);
    let of_rods = rods.effects(&accuracy.by_rods);
    assert_eq!(of_all.effects()[3..5], of_rods.effects()[..]);
    Ok(())
}

#[test]
fn samples_agree_with_the_linear_analysis() -> Outcome {
    let mechanism = CrankRocker::default();
    let linkage = mechanism.assemble()?;
    let tolerances = Tolerances::complete(CrankRocker::PARAMETERS)?;
    for (phi, distribution) in [
        (0.3, Distribution::Normal),
        (2.0, Distribution::Uniform),
        (4.5, Distribution::Triangular),
    ] {
        let samples = MonteCarlo::new(100_000)
            .seed(3)
            .distribution(distribution)
            .run(&mechanism, &tolerances, |mechanisms, [x, y]| {
                let rows = linkage.path_sweep_sets(mechanisms, &[phi]);
                let [px, py] = rows.tracer();
                x.copy_from_slice(px);
                y.copy_from_slice(py);
            })?;
        let effects = tolerances.effects(&linkage.accuracy(phi).e);
        for agreement in samples.agreement(&effects, linkage.path(phi).tracer.into()) {
            assert!(agreement.within(0.002), "{distribution:?}\n{agreement}");
        }
        assert_eq!(samples.missing(), 0);
    }
    Ok(())
}

/// Mechanisms that come apart are counted.
#[test]
fn samples_that_do_not_assemble() -> Outcome {
    let mechanism = CrankRocker::default();
    let linkage = mechanism.assemble()?;
    // At 0 degrees the rods must span 140 - 50 mm; now they hardly do.
    let tight = CrankRocker {
        coupler: 120.0,
        rocker: 210.0,
        ..mechanism
    };
    let tolerances = Tolerances::<7>::new(CrankRocker::PARAMETERS, &[1.0; 7])?;
    let samples = MonteCarlo::new(10_000).run(&tight, &tolerances, |mechanisms, [x]| {
        x.copy_from_slice(linkage.path_sweep_sets(mechanisms, &[0.0]).tracer()[0]);
    })?;
    assert!(
        samples.missing() > 1000 && samples.missing() < 9000,
        "{}",
        samples.missing()
    );
    Ok(())
}

#[test]
fn tolerances_for_the_whole_cycle() -> Outcome {
    let linkage = CrankRocker::default().assemble()?;
    let cycle = || (0..72).map(|i| linkage.accuracy(TAU * f64::from(i) / 72.0).e);
    for addition in [Addition::WorstCase, Addition::Statistical] {
        let requirement = Requirement::new(0.05, addition).over(cycle())?;
        let found = requirement.allocate(CrankRocker::PARAMETERS, &AllocationRule::EqualEffect)?;
        let error = |phi: f64| {
            let effects = found.tolerances.effects(&linkage.accuracy(phi).e);
            match addition {
                Addition::WorstCase => effects.worst_modulus(),
                Addition::Statistical => effects.root_sum_square_modulus(),
            }
        };
        // Between the positions it may be a little more.
        let worst = largest(0.0..TAU, 720, error)?;
        assert!(
            worst.value < 0.05 * 1.01 && worst.value > 0.05 * 0.999,
            "{}",
            worst.value
        );
    }
    Ok(())
}

/// Printed, and as sizes of grades, the dimensions are those of the mechanism, not those of the declaration.
#[test]
fn tolerances_of_other_dimensions_than_declared() -> Outcome {
    let mechanism = CrankRocker {
        arm: 85.5,
        pivot: Vector2::new(143.0, -4.0),
        ..CrankRocker::default()
    };
    let linkage = mechanism.assemble()?;
    let parameters = mechanism.parameters();
    let requirement =
        Requirement::new(0.05, Addition::WorstCase).position(&linkage.accuracy(1.0).e)?;
    let found = requirement.allocate(&parameters, &AllocationRule::Proportional([0.25; 7]))?;
    for (parameter, value) in found.tolerances.parameters().iter().zip(mechanism.values()) {
        assert_eq!(parameter.nominal, value, "{}", parameter.name);
    }
    let printed = found.tolerances.to_string();
    let lines: Vec<&str> = printed.lines().collect();
    assert!(lines[0].starts_with("pivot.x = 143 +- "), "{printed}");
    assert!(lines[1].starts_with("pivot.y = -4 +- "), "{printed}");
    assert!(lines[5].starts_with("arm = 85.5 +- "), "{printed}");
    // The tolerances of the declaration stay.
    let declared = CrankRocker::PARAMETERS
        .iter()
        .map(|parameter| parameter.tolerance);
    assert!(
        parameters
            .iter()
            .map(|parameter| parameter.tolerance)
            .eq(declared)
    );
    Ok(())
}

/// The rocker's angle does not depend on the arm.
#[test]
fn a_parameter_without_effect() -> Outcome {
    let linkage = CrankRocker::default().assemble()?;
    let requirement =
        Requirement::new(1e-3, Addition::WorstCase).position(&linkage.swing(1.0).e)?;
    let refused = requirement.allocate(CrankRocker::PARAMETERS, &AllocationRule::EqualEffect);
    assert_eq!(refused, Err(ToleranceError::NoEffect { name: "arm" }));
    Ok(())
}

// What does not fit is told.

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
