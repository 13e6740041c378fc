//! Optima known by hand.

use linkage_analysis::balancing::Balance;
use linkage_runtime::Vector2;

use super::{angles, crank, near};

#[test]
fn a_rotating_unbalance_is_balanced_in_full() {
    let (force, ahead) = (420.0, 0.7_f64);
    let at = |phi: f64| Vector2::new((phi + ahead).cos(), (phi + ahead).sin()) * force;
    let forces: Vec<_> = angles(90).map(at).collect();
    let effects: Vec<_> = crank(90).iter().map(|row| row.map(Vector2::from)).collect();
    let balance = Balance::new(&forces, &effects).expect("it is valid");
    for solution in [balance.mean_square(), balance.peak()] {
        let solution = solution.expect("it is regular");
        near(solution.values[0], -force * ahead.cos(), 1e-12 * force);
        near(solution.values[1], -force * ahead.sin(), 1e-12 * force);
        near(solution.before.peak, force, 1e-12 * force);
        near(solution.before.rms, force, 1e-12 * force);
        near(solution.after.peak, 0.0, 1e-12 * force);
        near(solution.after.rms, 0.0, 1e-12 * force);
        assert!(solution.bound <= solution.after.peak);
    }
}

/// A force to and fro is the sum of two halves that turn in opposite directions; a counterweight takes one of them.
#[test]
fn a_reciprocating_force_is_halved() {
    for count in [4, 7, 360, 3600] {
        let forces: Vec<_> = angles(count).map(|phi| [500.0 * phi.cos(), 0.0]).collect();
        let balance = Balance::new(&forces, &crank(count)).expect("it is valid");
        let peak = balance.peak().expect("it is regular");
        near(peak.values[0], -250.0, 1e-6);
        near(peak.values[1], 0.0, 1e-6);
        near(peak.after.peak, 250.0, 1e-9);
        near(peak.bound, 250.0, 1e-9);
        let mean = balance.mean_square().expect("it is regular");
        near(mean.values[0], -250.0, 1e-10);
        near(mean.after.rms, 250.0, 1e-10);
        near(mean.bound, mean.after.rms, 0.0);
    }
}

/// Two unit masses that shift everything: the least peak is the radius of the smallest circle around the points.
#[test]
fn points_in_their_smallest_circle() {
    let shift = [[-1.0, 0.0], [0.0, -1.0]];
    let cases = [
        // An equilateral triangle, an obtuse one, a right one, one with points inside, three points the same.
        (
            vec![[0.0, 0.0], [2.0, 0.0], [1.0, 3_f64.sqrt()]],
            [1.0, 3_f64.sqrt() / 3.0],
            2.0 / 3_f64.sqrt(),
        ),
        (vec![[0.0, 0.0], [10.0, 0.0], [4.0, 1.0]], [5.0, 0.0], 5.0),
        (vec![[0.0, 0.0], [6.0, 0.0], [0.0, 8.0]], [3.0, 4.0], 5.0),
        (
            vec![[-1.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.3, 0.2], [0.1, -0.4]],
            [0.0, 0.0],
            1.0,
        ),
        (vec![[7.0, -2.0]; 3], [7.0, -2.0], 0.0),
    ];
    for (points, centre, radius) in cases {
        let effects = vec![shift; points.len()];
        let balance = Balance::new(&points, &effects).expect("it is valid");
        let solution = balance.peak().expect("it is regular");
        near(solution.after.peak, radius, 1e-11);
        near(solution.bound, radius, 1e-11);
        near(solution.values[0], centre[0], 1e-5);
        near(solution.values[1], centre[1], 1e-5);
    }
}

/// One mass that shifts numbers: the middle of their range by peak, their mean by mean square.
#[test]
fn numbers_have_middle_and_mean() {
    let forces = [3.0, -1.0, 9.0, 4.0, 0.0];
    let balance = Balance::new(&forces, &[[-1.0]; 5]).expect("it is valid");
    let peak = balance.peak().expect("it is regular");
    near(peak.values[0], 4.0, 1e-11);
    near(peak.after.peak, 5.0, 1e-11);
    let mean = balance.mean_square().expect("it is regular");
    near(mean.values[0], 3.0, 1e-14);
    near(mean.after.rms, (62.0_f64 / 5.0).sqrt(), 1e-14);
}

#[test]
fn nothing_is_left_of_nothing() {
    let balance = Balance::new(&[[0.0, 0.0]; 12], &crank(12)).expect("it is valid");
    for solution in [balance.mean_square(), balance.peak()] {
        let solution = solution.expect("it is regular");
        assert_eq!(solution.values, [0.0, 0.0]);
        assert_eq!(solution.after, solution.before);
        assert!(solution.after.peak == 0.0 && solution.bound == 0.0);
    }
}

/// `max |1 + z|, |z - 3| / length`, at the meeting of both lines.
#[test]
fn moments_count_after_division_by_their_length() {
    for (length, value, peak) in [(1.0, 1.0, 2.0), (3.0, 0.0, 1.0), (1e9, -1.0, 4e-9)] {
        let balance = Balance::new(&[1.0], &[[1.0]])
            .and_then(|balance| balance.and(&[-3.0], &[[1.0]], length))
            .expect("it is valid");
        let solution = balance.peak().expect("it is regular");
        near(solution.values[0], value, 1e-8);
        near(solution.after.peak, peak, 1e-8 * peak);
        let [force, moment] = [0, 1].map(|i| balance.figures_of_each(&solution.values)[i]);
        near(force.peak, (1.0 + solution.values[0]).abs(), 1e-15);
        near(moment.peak, (solution.values[0] - 3.0).abs(), 1e-15);
        near(
            solution.after.peak,
            force.peak.max(moment.peak / length),
            1e-15,
        );
    }
}

/// `(1 + z)^2 + mean of (z - 3)^2 / length^2`: a quantity counts by its mean, however many positions it has.
#[test]
fn mean_squares_of_quantities_are_added() {
    for count in [1, 40] {
        let moments = vec![-3.0; count];
        let balance = Balance::new(&[1.0], &[[1.0]])
            .and_then(|balance| balance.and(&moments, &vec![[1.0]; count], 2.0))
            .expect("it is valid");
        let solution = balance.mean_square().expect("it is regular");
        // Zero derivative: 1 + z + (z - 3) / 4 = 0.
        near(solution.values[0], -0.2, 1e-14);
        near(solution.after.rms, 0.8_f64.hypot(1.6), 1e-14);
        near(solution.before.rms, 1_f64.hypot(1.5), 1e-14);
        near(solution.after.peak, 1.6, 1e-14);
    }
}

#[test]
fn the_line_of_a_solution() {
    let balance = Balance::new(&[3.0, -1.0], &[[-1.0]; 2]).expect("it is valid");
    let solution = balance.mean_square().expect("it is regular");
    assert_eq!(solution.to_string(), "rms 2.23607 to 2, peak 3 to 2");
}
