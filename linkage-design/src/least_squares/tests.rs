//! Descents to minima that are known, with limits active and without.

use super::{Descent, State};
use crate::limits::{Limits, Linear};
use crate::normal::Normal;
use linkage_random::Random;
use std::vec;
use std::vec::Vec;

fn bounds(lower: &[f64], upper: &[f64]) -> Limits {
    Limits {
        lower: lower.to_vec(),
        upper: upper.to_vec(),
        relations: Vec::new(),
    }
}

fn wide(n: usize) -> Limits {
    bounds(&vec![-1e6; n], &vec![1e6; n])
}

fn descend(start: &[f64], limits: &Limits, evaluate: impl FnMut(&[f64], &mut Normal)) -> Descent {
    let (descent, state) = super::minimise(start.to_vec(), limits, 500, evaluate);
    assert_eq!(
        state,
        State::Converged,
        "after {} steps at {:?}",
        descent.count,
        descent.x
    );
    descent
}

fn rosenbrock(x: &[f64], normal: &mut Normal) {
    normal.add(10.0 * (x[1] - x[0] * x[0]), &[0, 1], &[-20.0 * x[0], 10.0]);
    normal.add(1.0 - x[0], &[0], &[-1.0]);
}

#[test]
fn rosenbrock_free_and_with_a_bound_in_the_way() {
    let found = descend(&[-1.2, 1.0], &wide(2), rosenbrock);
    assert!(found.here.sum < 1e-25, "{:e}", found.here.sum);
    assert!(
        (found.x[0] - 1.0).abs() < 1e-12 && found.count < 60,
        "{}",
        found.count
    );

    // On the bound x = 1/2 the valley's floor is y = 1/4; the sum is that of the second residual
    // alone.
    let found = descend(
        &[-1.2, 1.0],
        &bounds(&[-2.0, -2.0], &[0.5, 2.0]),
        rosenbrock,
    );
    assert_eq!(found.x[0], 0.5);
    assert!((found.x[1] - 0.25).abs() < 1e-9, "{}", found.x[1]);
    assert!((found.here.sum - 0.25).abs() < 1e-14);
}

/// Misra1a of the statistical reference data sets of NIST, with certified values.
#[test]
fn a_certified_fit() {
    let x = [
        77.6, 114.9, 141.1, 190.8, 239.9, 289.0, 332.8, 378.4, 434.8, 477.3, 536.8, 593.1, 689.1,
        760.0,
    ];
    let y = [
        10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02, 44.82, 50.76, 55.05, 61.01, 66.40, 75.47,
        81.78,
    ];
    for start in [[500.0, 1e-4], [250.0, 5e-4]] {
        let found = descend(&start, &wide(2), |b: &[f64], normal| {
            for (x, y) in x.iter().zip(y) {
                let decay = (-b[1] * x).exp();
                normal.add(
                    b[0] * (1.0 - decay) - y,
                    &[0, 1],
                    &[1.0 - decay, b[0] * x * decay],
                );
            }
        });
        assert!(
            (found.x[0] / 238.942_129_18 - 1.0).abs() < 1e-8,
            "{}",
            found.x[0]
        );
        assert!((found.x[1] / 5.501_564_318_1e-4 - 1.0).abs() < 1e-8);
        assert!((found.here.sum / 0.124_551_388_94 - 1.0).abs() < 1e-9);
    }
}

/// The Jacobian loses rank at the solution: convergence is slow, but to the right place.
#[test]
fn powells_singular_function() {
    let found = descend(&[3.0, -1.0, 0.0, 1.0], &wide(4), |x: &[f64], normal| {
        normal.add(x[0] + 10.0 * x[1], &[0, 1], &[1.0, 10.0]);
        let five = 5_f64.sqrt();
        normal.add(five * (x[2] - x[3]), &[2, 3], &[five, -five]);
        let (a, b) = (x[1] - 2.0 * x[2], x[0] - x[3]);
        normal.add(a * a, &[1, 2], &[2.0 * a, -4.0 * a]);
        let ten = 10_f64.sqrt();
        normal.add(ten * b * b, &[0, 3], &[2.0 * ten * b, -2.0 * ten * b]);
    });
    assert!(found.here.sum < 1e-24, "{:e}", found.here.sum);
}

/// A sum within a relation: by hand, the nearest point of the line to the origin.
#[test]
fn relations_hold_at_every_step() {
    let mut limits = wide(2);
    limits.relations.push(Linear {
        terms: vec![(0, 3.0), (1, 4.0)],
        most: -25.0,
        equality: false,
    });
    let mut places = Vec::new();
    let start = limits.nearest(&[10.0, 10.0]).expect("there is room");
    let found = descend(&start, &limits, |x: &[f64], normal| {
        places.push(x.to_vec());
        normal.add(x[0], &[0], &[1.0]);
        normal.add(x[1], &[1], &[1.0]);
    });
    assert!(
        (found.x[0] + 3.0).abs() < 1e-12 && (found.x[1] + 4.0).abs() < 1e-12,
        "{:?}",
        found.x
    );
    assert!(places.iter().all(|x| limits.hold(x)));
}

/// A nonlinear condition: the least circle that reaches a hyperbola, from inside and from outside
/// of the allowed region.
#[test]
fn conditions_are_met_at_the_end() {
    for start in [[3.0, 2.0], [0.1, 0.4]] {
        let found = descend(
            &start,
            &bounds(&[0.0, 0.0], &[9.0, 9.0]),
            |x: &[f64], normal| {
                normal.add(x[0], &[0], &[1.0]);
                normal.add(x[1], &[1], &[1.0]);
                normal
                    .conditions
                    .push((x[0] * x[1] - 1.0, vec![x[1], x[0]]));
            },
        );
        assert!(
            (found.x[0] - 1.0).abs() < 1e-6 && (found.x[1] - 1.0).abs() < 1e-6,
            "{:?}",
            found.x
        );
        assert!(found.here.conditions[0].0 > -1e-9);
    }
}

/// A step to a point without a value of the function is shortened: the root of a logarithm, from
/// far on the good side.
#[test]
fn steps_stay_where_there_are_values() {
    let found = descend(&[30.0], &wide(1), |x: &[f64], normal| {
        normal.add(x[0].ln(), &[0], &[1.0 / x[0]])
    });
    assert!((found.x[0] - 1.0).abs() < 1e-12);
}

/// Random sums of squares with bounds: at the end, the gradient pushes out of the bounds that are
/// active and is zero elsewhere.
#[test]
fn ends_meet_the_conditions_of_a_minimum() {
    let mut random = Random::new(7);
    let mut active = 0;
    for _ in 0..300 {
        let (n, m) = (2 + random.below(5), 2 + random.below(12));
        let factors: Vec<f64> = (0..n * m).map(|_| random.between(-1.0, 1.0)).collect();
        let targets: Vec<f64> = (0..m).map(|_| random.between(-2.0, 2.0)).collect();
        let limits = bounds(&vec![-0.5; n], &vec![0.5; n]);
        let start: Vec<f64> = (0..n).map(|_| random.between(-0.5, 0.5)).collect();
        let places: Vec<usize> = (0..n).collect();
        let found = descend(&start, &limits, |x: &[f64], normal| {
            for (row, target) in factors.chunks(n).zip(&targets) {
                let inner: f64 = row.iter().zip(x).map(|(a, x)| a * x).sum();
                let slopes: Vec<f64> = row.iter().map(|a| a * (1.0 + 0.3 * inner.cos())).collect();
                normal.add(inner + 0.3 * inner.sin() - target, &places, &slopes);
            }
        });
        for (x, slope) in found.x.iter().zip(&found.here.gradient) {
            let push = match x {
                -0.5 => slope.min(0.0),
                0.5 => slope.max(0.0),
                _ => *slope,
            };
            active += usize::from(x.abs() == 0.5);
            assert!(push.abs() < 1e-5, "{push} at {x}");
        }
    }
    assert!(active > 300, "{active}");
}
