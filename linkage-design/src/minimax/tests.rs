//! Problems whose optimum is known.

use std::vec;
use std::vec::Vec;

use super::super::limits::{Limits, Linear};
use super::{FunctionRow, Groups, Key, Minimum, SearchSettings, minimise};

fn row(nth: usize, value: f64, slopes: &[f64]) -> FunctionRow {
    FunctionRow {
        key: Key::Nth(nth),
        value,
        slopes: slopes.to_vec(),
    }
}

fn search(n: usize) -> SearchSettings {
    SearchSettings {
        reach: vec![0.5; n],
        precision: 1e-14,
        slope: 1e-6,
        tolerance: 1e-10,
        rounds: 300,
    }
}

fn within(n: usize, bound: f64) -> Limits {
    Limits {
        lower: vec![-bound; n],
        upper: vec![bound; n],
        relations: Vec::new(),
    }
}

fn solved(start: &[f64], limits: &Limits, groups: impl Fn(&[f64]) -> Groups) -> Minimum {
    let n = start.len();
    minimise(start, limits, &search(n), |x| Some(groups(x)), || false)
        .expect("a value at the start")
}

/// C. Charalambous, B. R. Bandler, "Non-linear minimax optimization as a sequence of least pth
/// optimization with finite values of p", Int. J. Systems Sci. 7 (1976), the second problem: its
/// optimum is between two of three functions, on no vertex.
fn second(x: &[f64]) -> Groups {
    let [a, b] = [x[0], x[1]];
    let e = 2.0 * (b - a).exp();
    let objective = vec![
        row(0, a * a + b.powi(4), &[2.0 * a, 4.0 * b.powi(3)]),
        row(
            1,
            (2.0 - a).powi(2) + (2.0 - b).powi(2),
            &[2.0 * a - 4.0, 2.0 * b - 4.0],
        ),
        row(2, e, &[-e, e]),
    ];
    Groups {
        objective,
        conditions: Vec::new(),
        squares: Vec::new(),
    }
}

#[test]
fn a_smooth_valley_between_two_functions() {
    for start in [[1.0, -0.1], [2.0, 2.0], [-3.0, 0.5]] {
        let found = solved(&start, &within(2, 10.0), second);
        // Bisection in 40 digits: a where both functions are equal and their gradients opposite.
        assert!(
            (found.groups.value() - 1.952_224_493_870_659).abs() < 1e-10,
            "{found:?}"
        );
        assert!(found.converged && found.rounds < 60, "{}", found.rounds);
    }
}

/// J. B. Rosen, S. Suzuki, "Construction of nonlinear programming test problems", Comm. ACM 8
/// (1965): optimum -44 at (0, 1, 2, -1).
fn rosen_suzuki(x: &[f64]) -> Groups {
    let [a, b, c, d] = [x[0], x[1], x[2], x[3]];
    let value = a * a + b * b + 2.0 * c * c + d * d - 5.0 * a - 5.0 * b - 21.0 * c + 7.0 * d;
    let slopes = [2.0 * a - 5.0, 2.0 * b - 5.0, 4.0 * c - 21.0, 2.0 * d + 7.0];
    let squares = a * a + b * b + c * c + d * d;
    let conditions = vec![
        vec![row(
            0,
            squares + a - b + c - d - 8.0,
            &[2.0 * a + 1.0, 2.0 * b - 1.0, 2.0 * c + 1.0, 2.0 * d - 1.0],
        )],
        vec![row(
            0,
            squares + b * b + d * d - a - d - 10.0,
            &[2.0 * a - 1.0, 4.0 * b, 2.0 * c, 4.0 * d - 1.0],
        )],
        vec![row(
            0,
            2.0 * a * a + b * b + c * c + 2.0 * a - b - d - 5.0,
            &[4.0 * a + 2.0, 2.0 * b - 1.0, 2.0 * c, -1.0],
        )],
    ];
    Groups {
        objective: vec![row(0, value, &slopes)],
        conditions,
        squares: Vec::new(),
    }
}

#[test]
fn conditions_hold_at_the_optimum() {
    let found = solved(&[0.0; 4], &within(4, 10.0), rosen_suzuki);
    assert!(
        (found.groups.value() + 44.0).abs() < 1e-8,
        "{}",
        found.groups.value()
    );
    for (x, known) in found.x.iter().zip([0.0, 1.0, 2.0, -1.0]) {
        assert!((x - known).abs() < 1e-5, "{:?}", found.x);
    }
    assert!(found.converged && found.groups.excess() < 1e-9 && found.rounds < 60);
}

#[test]
fn bounds_and_relations_hold_at_the_optimum() {
    let mut limits = within(4, 10.0);
    limits.upper[2] = 1.5;
    limits.relations.push(Linear {
        terms: vec![(0, 1.0), (3, 1.0)],
        most: -0.5,
        equality: true,
    });
    let found = solved(&[0.0, 0.0, 0.0, -0.5], &limits, rosen_suzuki);
    assert!(found.converged && found.groups.excess() < 1e-9);
    assert_eq!(found.x[2], 1.5);
    assert!((found.x[0] + found.x[3] + 0.5).abs() < 1e-12);
    // No step along the relation and the bound, that keeps the conditions, leads below.
    let best = found.groups.value();
    for i in 0..400 {
        let angle = 0.157 * f64::from(i);
        let [u, v] = [angle.cos(), angle.sin()].map(|part| 1e-3 * part);
        let other = [found.x[0] + u, found.x[1] + v, 1.5, found.x[3] - u];
        let groups = rosen_suzuki(&other);
        assert!(
            groups.excess() > 0.0 || groups.value() >= best - 1e-9,
            "{angle}"
        );
    }
}

/// The line nearest to the exponential function from 0 to 1. Its largest errors are at both ends
/// and where both are parallel, a place that moves with the line: the envelope theorem.
fn line(x: &[f64]) -> Groups {
    let [level, slope] = [x[0], x[1]];
    let places = [0.0, 1.0, slope.max(1.0).min(1f64.exp()).ln()];
    let error = |t: f64| level + slope * t - t.exp();
    let rows = places.into_iter().flat_map(|t| {
        let key = Key::At(t);
        [1.0, -1.0].map(|sign| FunctionRow {
            key,
            value: sign * error(t),
            slopes: vec![sign, sign * t],
        })
    });
    Groups {
        objective: rows.collect(),
        conditions: Vec::new(),
        squares: Vec::new(),
    }
}

#[test]
fn a_best_approximation_by_its_moving_extremes() {
    let found = solved(&[0.0, 1.1], &within(2, 5.0), line);
    let slope = 1f64.exp() - 1.0;
    let level = 0.5 * (1f64.exp() - slope * slope.ln());
    assert!((found.x[1] - slope).abs() < 1e-9 && (found.x[0] - level).abs() < 1e-9);
    assert!((found.groups.value() - (1.0 - level)).abs() < 1e-12);
    assert!(found.rounds < 15);
}

/// The condition is many boxes away: a condition that the box keeps from holding needs no higher
/// price, by which the objective would not be seen any more.
#[test]
fn a_condition_far_away_hides_no_objective() {
    let groups = |x: &[f64]| {
        let [a, b] = [x[0] - 7.0, x[1] - 1.0];
        let along = x[0] * x[0] + 0.1 * x[1];
        Groups {
            objective: vec![row(0, a * a + b * b, &[2.0 * a, 2.0 * b])],
            conditions: vec![vec![row(0, 30.0 - along, &[-2.0 * x[0], -0.1])]],
            squares: Vec::new(),
        }
    };
    let found = solved(&[0.1, -3.0], &within(2, 50.0), groups);
    assert!(found.converged && found.rounds < 60, "{found:?}");
    assert!(
        (found.x[0] - 7.0).abs() < 1e-5 && (found.x[1] - 1.0).abs() < 1e-5,
        "{found:?}"
    );
}

/// A kink that its row does not contain: no step leads on, but the first-order conditions do not
/// hold as they are given.
#[test]
fn where_slopes_promise_more_nothing_has_converged() {
    let groups = |x: &[f64]| Groups {
        objective: vec![row(0, x[0].abs(), &[1.0])],
        conditions: Vec::new(),
        squares: Vec::new(),
    };
    let found = solved(&[1.0], &within(1, 10.0), groups);
    assert!(found.groups.value() < 1e-3 && !found.converged, "{found:?}");
}

#[test]
fn what_cannot_hold_is_as_near_as_can_be() {
    let groups = |x: &[f64]| Groups {
        objective: vec![row(0, x[1], &[0.0, 1.0])],
        conditions: vec![vec![row(0, 3.0 - x[0], &[-1.0, 0.0])]],
        squares: Vec::new(),
    };
    let found = solved(&[0.0, 0.0], &within(2, 1.0), groups);
    assert!(found.converged);
    assert!((found.groups.excess() - 2.0).abs() < 1e-12 && found.x[0] == 1.0);
}

#[test]
fn places_without_a_value_are_avoided() {
    // The value ends where the root does, right at the optimum's side.
    let groups = |x: &[f64]| {
        let root = (x[0] - 1.0).sqrt();
        (x[0] > 1.0).then(|| Groups {
            objective: vec![row(0, x[0] - 1.2 * root, &[1.0 - 0.6 / root])],
            conditions: Vec::new(),
            squares: Vec::new(),
        })
    };
    let found = minimise(&[4.0], &within(1, 10.0), &search(1), groups, || false).expect("a value");
    assert!((found.x[0] - 1.36).abs() < 1e-6 && found.converged);
    assert!(minimise(&[0.5], &within(1, 10.0), &search(1), groups, || false).is_none());
}

/// Rosenbrock's function as the sum of two squares: its known curvature leads to its zero, and with
/// a condition to where the line of equal sums touches it.
#[test]
fn squares_bend_as_is_known() {
    let squares = |x: &[f64]| {
        vec![
            row(0, 1.0 - x[0], &[-1.0, 0.0]),
            row(1, 10.0 * (x[1] - x[0] * x[0]), &[-20.0 * x[0], 10.0]),
        ]
    };
    let groups = |x: &[f64], known: bool| {
        let rows = squares(x);
        let value = rows.iter().map(|row| row.value * row.value).sum();
        let slope = |j: usize| rows.iter().map(|row| 2.0 * row.value * row.slopes[j]).sum();
        let slopes: [f64; 2] = core::array::from_fn(slope);
        Groups {
            objective: vec![row(0, value, &slopes)],
            conditions: Vec::new(),
            squares: if known { rows } else { Vec::new() },
        }
    };
    let limits = within(2, 5.0);
    let found = solved(&[-1.2, 1.0], &limits, |x| groups(x, true));
    assert!(found.converged && found.groups.value() < 1e-12, "{found:?}");
    let gathered = solved(&[-1.2, 1.0], &limits, |x| groups(x, false));
    assert!(
        found.rounds < gathered.rounds,
        "{} {}",
        found.rounds,
        gathered.rounds
    );

    // Below a line that leaves the zero out.
    let bounded = |x: &[f64]| Groups {
        conditions: vec![vec![row(0, x[0] + x[1] - 1.0, &[1.0, 1.0])]],
        ..groups(x, true)
    };
    let found = solved(&[-1.2, 1.0], &limits, bounded);
    assert!(found.converged && (found.x[0] + found.x[1] - 1.0).abs() < 1e-8);
    let along = |t: f64| groups(&[t, 1.0 - t], true).value();
    let near = [along(found.x[0] - 1e-4), along(found.x[0] + 1e-4)];
    assert!(near.iter().all(|value| *value > found.groups.value()));
}
