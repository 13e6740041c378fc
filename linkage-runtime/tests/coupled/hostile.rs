//! Tables that are hard to make, or cannot be made.

use crate::triads::EyeNeedle;
use crate::{TURN, build, certified, range, root, survey};
use linkage_runtime::numeric::continuation::{Correction, End, Range, Refusal, Step, Table};
use std::f64::consts::TAU;

#[test]
fn narrow_places_are_passed() {
    // Between these cranks one can just turn all the way.
    let (mut turns, mut ends) = (100.0, 120.0);
    for _ in 0..45 {
        let crank = 0.5 * (turns + ends);
        match build(EyeNeedle::with_crank(crank), TURN, false) {
            Ok(_) => turns = crank,
            Err(_) => ends = crank,
        }
    }
    assert!(ends - turns < 1e-12 * turns);
    for share in [1e-2, 1e-3, 1e-4, 1e-5, 1e-6] {
        let mut triad = EyeNeedle::with_crank(turns * (1.0 - share));
        let table = Table::build(&mut triad, 0.0, &EyeNeedle::start(), TURN, false).unwrap();
        let (first, second, refused) = survey(&table, &mut triad, 0.0, TAU);
        assert!(first < 2e-9 && second < 1e-12 && refused == 0, "{share}");
        assert!(table.cells() < 100, "{share}");
    }
}

#[test]
fn open_ranges_of_any_length_and_direction() {
    for (low, high) in [
        (-0.4, 0.9),
        (0.0, 1e-6),
        (0.0, 1e-12),
        (-3.0, 8.0),
        (2.0, -1.0),
        (1.0, 0.5),
    ] {
        let table = build(EyeNeedle::MACHINE, range(low, high), false).unwrap();
        let (low, high) = (low.min(high).min(0.0), low.max(high));
        assert_eq!(table.ends(), [End::Range(low), End::Range(high)]);
        let mut triad = EyeNeedle::MACHINE;
        let (first, second, refused) = survey(&table, &mut triad, low, high);
        assert!(
            first < 2e-9 && second < 5e-15 && refused == 0,
            "{low} {high}"
        );
        // Beyond the ends: right, or refused.
        let length = high - low;
        let (_, second, _) = survey(&table, &mut triad, low - length, high + length);
        assert!(second < 1e-13, "{low} {high}: {second:e}");
        let mut state = [0.0; 4];
        for x in [
            low - 2.0 * length,
            high + 2.0 * length,
            f64::NAN,
            f64::INFINITY,
        ] {
            assert!(table.state(x, &mut state).is_nan());
        }
        // Rounding beyond the end does not count.
        assert!(!table.state(high + 1e-15, &mut state).is_nan());
    }
}

#[test]
fn slides_of_any_scale_and_place() {
    for (zero, unit) in [
        (0.0, 1e-6),
        (0.0, 1e6),
        (1e3, 1e-3),
        (-5e8, 1e5),
        (0.0, 1e-150),
        (0.0, 1e150),
    ] {
        let mut correct = |x: &[f64], state: &mut [f64]| {
            { EyeNeedle::MACHINE }.correct(&[(x[0] - zero) / unit], state)
        };
        let range = range(zero, zero + unit);
        let table = Table::build(&mut correct, zero, &EyeNeedle::start(), range, false).unwrap();
        let (first, second, refused) = survey(&table, &mut correct, zero, zero + unit);
        assert!(
            first < 2e-9 && second < 5e-15 && refused == 0,
            "{zero} {unit}"
        );
    }
}

#[test]
fn a_range_of_one_point() {
    let at = 0.0;
    for turn in [false, true] {
        let one = Range {
            low: at,
            high: at,
            turn,
        };
        let table = build(EyeNeedle::MACHINE, one, false).unwrap();
        assert_eq!(table.ends(), [End::Range(at); 2]);
        let mut state = [0.0; 4];
        let floor = table.state(at, &mut state);
        assert!(certified(
            { EyeNeedle::MACHINE }.correct(&[at], &mut state),
            floor
        ));
        assert!(table.state(f64::NAN, &mut state).is_nan());
    }
}

#[test]
fn turning_points_are_located() {
    for (at, turning, length) in [
        (0.0, 0.7, 1.0),
        (0.3, 1e-3, 10.0),
        (2.0, -3.0, 1e3),
        (0.0, 1e5, 1e6),
    ] {
        let side = if turning > at { 1.0 } else { -1.0 };
        let mut correct = root(|x| (turning - x) * side / length);
        let start = ((turning - at) * side / length).sqrt();
        let range = range(at - length, at + length);
        let end = Table::build(&mut correct, at, &[start], range, false);
        let Err(Refusal::TurningPoint { at: found }) = end else {
            panic!("{end:?}");
        };
        assert!(
            (found - turning).abs() < 1e-12 * length,
            "{found} {turning}"
        );
        let table = Table::build(&mut correct, at, &[start], range, true).unwrap();
        assert!(table.ends().contains(&End::TurningPoint(found)));
    }
}

#[test]
fn a_narrow_strip_is_no_crossing() {
    // The two square roots come this near to each other, but never meet.
    for near in [1e-2, 1e-3, 1e-4, 1e-5, 1e-7] {
        let mut correct = root(|x| x * x + near * near);
        let table = Table::build(
            &mut correct,
            -0.937,
            &[f64::hypot(0.937, near)],
            range(-1.0, 1.0),
            false,
        );
        // Nearer than the shortest cells can resolve it is refused.
        if near < 2e-5 {
            assert!(matches!(table, Err(Refusal::NotConverging { .. })));
        } else {
            let (first, second, refused) = survey(&table.unwrap(), &mut correct, -1.0, 1.0);
            assert!(first < 2e-9 && second < 1e-12 && refused == 0);
        }
    }
}

#[test]
fn what_is_no_solution_is_refused() {
    let mut nan = |_: &[f64], _: &mut [f64]| Step {
        size: f64::NAN,
        determinant: f64::NAN,
    };
    let none = Table::build(&mut nan, 0.0, &[1.0], TURN, false);
    assert_eq!(none, Err(Refusal::NotASolution));
    let mut correct = root(|x| x);
    for (at, state) in [(1.0, 9.0), (0.0, 0.0)] {
        let none = Table::build(&mut correct, at, &[state], range(0.0, 1.0), false);
        assert_eq!(none, Err(Refusal::NotASolution));
    }
    for (low, high, at) in [
        (f64::NAN, 1.0, 1.0),
        (0.5, f64::INFINITY, 1.0),
        (-f64::MAX, f64::MAX, 1.0),
        (0.5, 1.0, f64::NAN),
    ] {
        let none = Table::build(&mut correct, at, &[1.0], range(low, high), false);
        assert_eq!(none, Err(Refusal::NotFinite));
    }
    // Solutions that jump about and ones that are noise.
    let mut jump = root(|x| if x > 0.3 { 2.0 } else { 1.0 });
    let result = Table::build(&mut jump, 0.0, &[1.0], range(0.0, 1.0), false);
    assert!(
        matches!(result, Err(Refusal::NotConverging { at }) if (at - 0.3).abs() < 1e-4),
        "{result:?}"
    );
    let mut noise = root(|x| 1.0 + 1e-3 * (x * 1e9).sin());
    let result = Table::build(&mut noise, 0.0, &[1.0], range(0.0, 1.0), false);
    assert!(
        matches!(result, Err(Refusal::NotConverging { .. })),
        "{result:?}"
    );
}

#[test]
fn a_state_that_returns_after_two_turns_only() {
    let mut correct = root(|x| 1.5 + (0.5 * x).sin());
    let two = Range {
        low: 0.0,
        high: 2.0 * TAU,
        turn: true,
    };
    let table = Table::build(
        &mut correct,
        0.3,
        &[(1.5 + 0.15_f64.sin()).sqrt()],
        two,
        false,
    )
    .unwrap();
    assert_eq!(table.ends(), [End::Range(0.0), End::Range(2.0 * TAU)]);
    let (first, second, refused) = survey(&table, &mut correct, 0.0, 2.0 * TAU);
    assert!(first < 2e-9 && second < 1e-14 && refused == 0);
    // The state is the same after a turn from here, but the equations are not.
    let table = Table::build(&mut correct, 0.0, &[1.5_f64.sqrt()], two, false).unwrap();
    assert_eq!(table.ends()[0], End::Range(0.0));
}
