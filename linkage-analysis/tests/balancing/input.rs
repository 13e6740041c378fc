//! Wrong numbers.

use linkage_analysis::balancing::{Balance, BalanceError};

use super::crank;

fn message<const N: usize>(made: Result<Balance<N>, BalanceError>) -> String {
    made.expect_err("it is invalid").to_string()
}

#[test]
fn there_must_be_positions_and_masses() {
    assert_eq!(
        message(Balance::<2>::new::<[f64; 2], 2>(&[], &[])),
        "nothing to balance: no positions"
    );
    assert_eq!(
        message(Balance::<0>::new(&[1.0], &[[]])),
        "nothing to balance: no masses"
    );
}

#[test]
fn each_force_has_its_effects() {
    let forces = [[1.0, 0.0]; 3];
    assert_eq!(
        message(Balance::new(&forces, &crank(4))),
        "4 rows of effects for 3 forces"
    );
    let balance = Balance::new(&forces, &crank(3)).expect("it is valid");
    assert_eq!(
        message(balance.and(&[1.0], &[], 10.0)),
        "0 rows of effects for 1 forces of quantity 1"
    );
}

#[test]
fn numbers_must_be_finite() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut forces = [[1.0, 0.0]; 5];
        forces[3][1] = bad;
        assert_eq!(
            message(Balance::new(&forces, &crank(5))),
            "position 3: the force is not finite: the mechanism cannot be assembled there or stands at a dead point"
        );
        let balance = Balance::new(&[[1.0, 0.0]; 5], &crank(5)).expect("it is valid");
        let mut effects = vec![[1.0, 2.0]; 4];
        effects[2][1] = bad;
        assert_eq!(
            message(balance.and(&[1.0; 4], &effects, 10.0)),
            "position 2 of quantity 1: the effect of mass 1 is not finite: the mechanism cannot be assembled there \
             or stands at a dead point"
        );
    }
}

#[test]
fn the_length_must_be_positive() {
    for length in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let balance = Balance::new(&[1.0], &[[1.0]]).expect("it is valid");
        assert_eq!(
            message(balance.and(&[1.0], &[[1.0]], length)),
            format!(
                "the length that moments are divided by is {length}: it must be positive and finite"
            )
        );
    }
}

#[test]
fn a_mass_without_effect_is_named() {
    let effects: Vec<_> = crank(9).iter().map(|[a, b]| [*a, [0.0, 0.0], *b]).collect();
    let balance = Balance::new(&[[1.0, 0.0]; 9], &effects).expect("it is valid");
    for solution in [balance.mean_square(), balance.peak()] {
        let error = solution.expect_err("there is a zero column");
        assert_eq!(error, BalanceError::NoEffect { effect: 1 });
        assert_eq!(
            error.to_string(),
            "mass 1 has no effect at any position: leave it out"
        );
    }
}

#[test]
fn a_mass_that_others_can_replace_is_named() {
    // The third one is a sum of the first two, whatever its unit.
    for scale in [1e-9, 1.0, 1e9] {
        let third = |[a, b]: &[[f64; 2]; 2]| [0, 1].map(|k| scale * (0.3 * a[k] - 0.7 * b[k]));
        let effects: Vec<_> = crank(9)
            .iter()
            .map(|row| [row[0], row[1], third(row), [1.0, 0.0]])
            .collect();
        let balance = Balance::new(&[[1.0, 0.0]; 9], &effects).expect("it is valid");
        for solution in [balance.mean_square(), balance.peak()] {
            let error = solution.expect_err("there are many solutions");
            assert_eq!(error, BalanceError::Dependent { effect: 2 });
            assert_eq!(
                error.to_string(),
                "the effects of mass 2 are a combination of those of the masses before it: leave one of them out"
            );
        }
    }
}

/// More masses than numbers to balance.
#[test]
fn too_few_positions() {
    let balance = Balance::new(&[1.0, 2.0], &[[1.0, 2.0, 3.0], [1.0, -1.0, 5.0]]);
    let error = balance
        .and_then(|balance| balance.peak())
        .expect_err("there are many solutions");
    assert_eq!(error, BalanceError::Dependent { effect: 2 });
}

#[test]
fn numbers_beyond_those_of_the_machine() {
    let tiny = Balance::new(&[1e300, -1e300], &[[1e-320], [3e-320]]);
    let long = Balance::new(&[1e300, 1.0], &[[1.0], [2.0]])
        .and_then(|balance| balance.and(&[1e300, 2.0], &[[1.0], [4.0]], 1e-300));
    for balance in [tiny, long] {
        let balance = balance.expect("it is valid");
        for solution in [balance.mean_square(), balance.peak()] {
            let error = solution.expect_err("it overflows");
            assert_eq!(error, BalanceError::OutOfRange);
            assert_eq!(
                error.to_string(),
                "the numbers are too large or too small to compute with"
            );
        }
    }
}
