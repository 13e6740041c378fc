//! Tolerances for an allowed error.

use linkage_analysis::tolerance::{
    Addition, AllocationRule, Costs, Grade, Requirement, Sizes, ToleranceError, tolerance_factor,
};
use linkage_runtime::Parameter;

use super::eye_needle::{parameters, record};
use super::{lengths, near};

pub(crate) const ADDITIONS: [Addition; 2] = [Addition::WorstCase, Addition::Statistical];

pub(crate) fn rules() -> Vec<AllocationRule<13>> {
    let parameters = parameters();
    let sizes = Sizes::new(&parameters).and_then(|sizes| sizes.lever(8, 136.8));
    let sizes = sizes.expect("the sizes have ranges");
    let costs = |exponent: f64| Costs {
        cost: parameters.map(|p| p.tolerance.powf(exponent)),
        exponent: [exponent; 13],
    };
    vec![
        AllocationRule::EqualEffect,
        AllocationRule::EqualTolerance(sizes),
        AllocationRule::StandardFactor(sizes),
        AllocationRule::StandardGrade(sizes),
        AllocationRule::Proportional(parameters.map(|p| p.tolerance)),
        AllocationRule::LeastCost(costs(1.0)),
        AllocationRule::LeastCost(costs(2.0)),
    ]
}

/// Requirements over some positions of the cycle, by modulus and by component.
pub(crate) fn requirements(addition: Addition) -> [Requirement<13, 2>; 3] {
    let cycle = |step: usize| {
        let rows = record().into_iter().step_by(step);
        let whole = Requirement::new(0.018, addition);
        rows.fold(whole, |requirement, (_, row)| {
            requirement.position(&row).expect("it is finite")
        })
    };
    let start = record()[0].1;
    [
        cycle(10),
        cycle(10).by_component(),
        cycle(11).relative_to(&start).expect("it is finite"),
    ]
}

#[test]
fn every_result_holds_the_limit() {
    for addition in ADDITIONS {
        for requirement in requirements(addition) {
            for rule in rules() {
                let found = requirement
                    .allocate(&parameters(), &rule)
                    .expect("it is possible");
                assert!(found.error <= 0.018, "{rule:?} {}", found.error);
                assert_eq!(found.error, requirement.error_of(&found.tolerances));
                let exhausts = !matches!(rule, AllocationRule::StandardGrade(_));
                assert!(
                    !exhausts || found.error > 0.018 * (1.0 - 1e-7),
                    "{rule:?} {}",
                    found.error
                );
            }
        }
    }
}

#[test]
fn equal_effects_are_equal() {
    let requirement = Requirement::new(0.3, Addition::WorstCase).position(&[0.5, -2.0, 0.1]);
    let found = requirement.and_then(|r| r.allocate(&lengths::<3>(), &AllocationRule::EqualEffect));
    for (t, known) in found
        .expect("it is possible")
        .tolerances
        .values()
        .into_iter()
        .zip([0.2, 0.05, 1.0])
    {
        near(t, known, 1e-14);
    }
}

#[test]
fn grades_and_factors() {
    let parameters = ["a", "b"].map(|name| Parameter {
        name,
        unit: "m",
        nominal: if name == "a" { 0.05 } else { -0.3 },
        tolerance: 0.0,
    });
    let sizes = Sizes::new(&parameters).expect("two parameters");
    let requirement = Requirement::new(50e-6, Addition::WorstCase)
        .position(&[1.0, 1.0])
        .expect("finite");
    let allocate = |rule| {
        requirement
            .allocate(&parameters, &rule)
            .expect("it is possible")
    };
    // IT7 is 25 and 52 um wide, IT8 39 and 81 um.
    let grade = allocate(AllocationRule::StandardGrade(sizes));
    assert_eq!(grade.grade, Grade::it(7));
    near(grade.tolerances.values()[0], 12.5e-6, 1e-18);
    near(grade.error, 38.5e-6, 1e-18);
    let [a, b] = allocate(AllocationRule::StandardFactor(sizes))
        .tolerances
        .values();
    let factor = |size| tolerance_factor(size).expect("it has a range");
    near(a / b, factor(50.0) / factor(300.0), 1e-14);
    let [a, b] = allocate(AllocationRule::EqualTolerance(sizes))
        .tolerances
        .values();
    near(a, 25e-6, 1e-18);
    assert_eq!(a, b);
    // A coordinate is given a size of its own.
    let other = sizes.size(1, 50.0).expect("it is a length");
    let [a, b] = allocate(AllocationRule::StandardFactor(other))
        .tolerances
        .values();
    assert_eq!(a, b);
}

#[test]
fn angles_have_the_tolerance_of_their_lever() {
    let sizes = Sizes::<13>::new(&parameters()).expect("thirteen parameters");
    let [requirement, ..] = requirements(Addition::WorstCase);
    let refused = requirement.allocate(&parameters(), &AllocationRule::EqualTolerance(sizes));
    assert_eq!(
        refused.expect_err("the angle has no size").to_string(),
        "U578 is no length: say with Sizes::lever at which length it acts"
    );
    let sizes = sizes.lever(8, 100.0).expect("it exists");
    let found = requirement.allocate(&parameters(), &AllocationRule::EqualTolerance(sizes));
    let t = found.expect("it is possible").tolerances.values();
    near(t[8] * 100.0, t[0], 1e-15);
}

#[test]
fn bad_requests() {
    let at = |limit: f64| Requirement::new(limit, Addition::WorstCase).position(&[1.0, 2.0]);
    let parameters = lengths::<2>();
    let refused = |limit: f64, rule: &AllocationRule<2>| {
        let requirement = at(limit).expect("it is finite");
        requirement
            .allocate(&parameters, rule)
            .expect_err("it is wrong")
    };
    for limit in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(
            refused(limit, &AllocationRule::EqualEffect),
            ToleranceError::Limit { .. }
        ));
    }
    let sizes = Sizes::new(&parameters).expect("two parameters");
    let too_fine = refused(1e-6, &AllocationRule::StandardGrade(sizes)).to_string();
    assert_eq!(
        too_fine,
        "no standard grade keeps the error within 1.00000e-6: the finest gives 0.0009"
    );
    let costs = Costs {
        cost: [1.0, -1.0],
        exponent: [1.0, 2.0],
    };
    assert_eq!(
        refused(1.0, &AllocationRule::LeastCost(costs)).to_string(),
        "the cost of b is -1 / t^2: both numbers must be positive and finite"
    );
    let giant = sizes.size(0, 5000.0).expect("a length");
    assert_eq!(
        refused(1.0, &AllocationRule::StandardFactor(giant)).to_string(),
        "a: ISO 286 has standard tolerances up to 3150 mm, not for 5000 mm"
    );
    let nowhere = Requirement::<2, 1>::new(1.0, Addition::WorstCase);
    assert!(
        nowhere
            .allocate(&parameters, &AllocationRule::EqualEffect)
            .is_err()
    );
    let nan = Requirement::new(1.0, Addition::WorstCase).position(&[1.0, f64::NAN]);
    assert_eq!(
        nan,
        Err(ToleranceError::NotFinite {
            position: 0,
            parameter: 1
        })
    );
    let idle = Requirement::new(1.0, Addition::WorstCase)
        .position(&[0.0, 1.0])
        .expect("finite");
    let idle = idle
        .allocate(&parameters, &AllocationRule::EqualEffect)
        .expect_err("a is free");
    assert_eq!(idle, ToleranceError::NoEffect { name: "a" });
}
