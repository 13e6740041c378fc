//! When a table repeats after a turn, and how far it reaches beyond its ends.

use crate::{TURN, range, root};
use linkage_runtime::numeric::continuation::{End, Range, Step, Table, dead_point};
use std::f64::consts::TAU;

/// Ends of the table of a length with this square, from the input 0.
fn ends(square: impl Fn(f64) -> f64, range: Range) -> [End; 2] {
    let start = square(0.0).sqrt();
    let table = Table::build(&mut root(square), 0.0, &[start], range, false);
    table.expect("it is nowhere zero").ends()
}

const OPEN: [End; 2] = [End::Range(0.0), End::Range(TAU)];

#[test]
fn a_state_that_nearly_returns_does_not_repeat() {
    let rising = |rise: f64| move |x: f64| 4.0 + x.sin() + rise * x;
    assert_eq!(ends(rising(0.0), TURN), [End::Closed; 2]);
    // After a turn the length is larger by 1.6 times the rise.
    assert_eq!(ends(rising(1e-9), TURN), [End::Closed; 2]);
    for rise in [1e-7, 1e-5, 1e-3] {
        assert_eq!(ends(rising(rise), TURN), OPEN, "{rise}");
    }
}

#[test]
fn a_state_that_returns_once_does_not_repeat() {
    // Half a wave to the turn: back after the first one, on the other side in the second one.
    let wave = |height: f64| move |x: f64| 4.0 + height * (0.5 * x).sin();
    assert_eq!(ends(wave(1e-9), TURN), [End::Closed; 2]);
    for height in [1e-6, 1e-3, 1.0] {
        assert_eq!(ends(wave(height), TURN), OPEN, "{height}");
    }
}

#[test]
fn a_state_that_is_off_at_the_seam_alone_does_not_repeat() {
    // A hump as the first turn ends, and nowhere else.
    let hump = |height: f64| move |x: f64| 4.0 + height * (-100.0 * (x - TAU) * (x - TAU)).exp();
    assert_eq!(ends(hump(1e-9), TURN), [End::Closed; 2]);
    for height in [1e-6, 1e-3, 1.0] {
        assert_eq!(ends(hump(height), TURN), OPEN, "{height}");
    }
}

#[test]
fn what_is_shorter_than_a_turn_is_none() {
    let shorter = |share: f64| Range {
        high: TAU * (1.0 - share),
        ..TURN
    };
    let square = |x: f64| 4.0 + x.sin();
    assert_eq!(ends(square, shorter(1e-10)), [End::Closed; 2]);
    for share in [1e-8, 1e-5, 1e-2] {
        let range = shorter(share);
        let open = [End::Range(0.0), End::Range(range.high)];
        assert_eq!(ends(square, range), open, "{share}");
    }
}

#[test]
fn half_a_cell_is_served_beyond_the_ends() {
    // A straight line: the largest cells, a quarter of the range, are at both ends.
    let square = |x: f64| (10.0 + x) * (10.0 + x);
    let table = Table::build(&mut root(square), 0.5, &[10.5], range(0.0, 1.0), false).unwrap();
    let lookup = table.lookup::<1>().unwrap();
    for (x, served) in [
        (-0.126, false),
        (-0.124, true),
        (1.124, true),
        (1.126, false),
    ] {
        let mut state = [0.0];
        let floor = table.state(x, &mut state);
        let ([length], same) = lookup.state_at(x);
        assert_eq!(floor.is_finite() && state[0].is_finite(), served, "{x}");
        assert_eq!(same.is_finite() && length.is_finite(), served, "{x}");
        assert!(
            !served || (length - 10.0 - x).abs() < 1e-10,
            "{x}: {length}"
        );
    }
}

#[test]
fn a_dead_point_on_a_straight_way_is_found() {
    // A length whose square is x + y: it ends where both together are 0.
    let mut length = |x: &[f64], state: &mut [f64]| {
        let step = (x[0] + x[1] - state[0] * state[0]) / (2.0 * state[0]);
        let determinant = 2.0 * state[0];
        state[0] += step;
        Step {
            size: step.abs(),
            determinant,
        }
    };
    let mut way = |to: [f64; 2]| dead_point(&mut length, &[1.0, 3.0], &[2.0], &to);
    assert_eq!(way([2.0, 5.0]), None);
    assert_eq!(way([-3.0 + 1e-6, 3.0]), None);
    assert_eq!(way([1.0, 3.0]), None);
    for (to, share) in [
        ([-7.0, 3.0], 0.5),
        ([-3.0, -1.0], 0.5),
        ([-399.0, 3.0], 0.01),
    ] {
        let found = way(to).unwrap();
        assert!((found - share).abs() < 1e-8, "{found}, not {share}");
    }
}

#[test]
fn an_end_that_is_no_dead_point_is_none() {
    // Nothing is known beyond 1.5, where the length is as regular as before.
    let mut known = root(|x| if x < 1.5 { 4.0 + x } else { f64::NAN });
    assert_eq!(dead_point(&mut known, &[0.0], &[2.0], &[3.0]), None);
}
