//! Prepared tables of coupled groups.

mod random;
mod triads;

use linkage_runtime::numeric::coupled::{Correction, End, Range, Refusal, Step, Table};
use random::Random;
use std::f64::consts::{PI, TAU};
use triads::{EyeNeedle, TwoCranks, unit};

const TURN: Range = Range {
    low: 0.0,
    high: TAU,
    turn: true,
};

fn range(low: f64, high: f64) -> Range {
    Range {
        low,
        high,
        turn: false,
    }
}

fn build(triad: EyeNeedle, range: Range, partial: bool) -> Result<Table, Refusal> {
    let mut triad = triad;
    Table::build(&mut triad, 0.0, &EyeNeedle::start(), range, partial)
}

/// The largest first and second corrections at many inputs between `low` and `high`, and how many of them the certificate
/// of evaluators refuses.
fn survey(
    table: &Table,
    correction: &mut impl Correction,
    low: f64,
    high: f64,
) -> (f64, f64, usize) {
    let mut random = Random::new(7);
    let (mut first, mut second, mut refused) = (0.0_f64, 0.0_f64, 0);
    let mut state = vec![0.0; table.width()];
    for _ in 0..10_000 {
        let x = [random.between(low, high)];
        let floor = table.state(x[0], &mut state);
        let step = correction.correct(&x, &mut state);
        if certified(step, floor) {
            first = first.max(step.size);
            second = second.max(correction.correct(&x, &mut state).size);
        } else {
            refused += 1;
        }
    }
    (first, second, refused)
}

fn certified(step: Step, floor: f64) -> bool {
    step.size < 1e-7 && step.determinant * floor >= floor * floor
}

#[test]
fn a_closed_table_is_one_step_from_the_solution() {
    let table = build(EyeNeedle::MACHINE, TURN, false).unwrap();
    assert_eq!(table.ends(), [End::Closed; 2]);
    assert!(table.error() <= 1e-9, "{}", table.error());
    let mut triad = EyeNeedle::MACHINE;
    let (first, second, refused) = survey(&table, &mut triad, -20.0, 20.0);
    println!("{} cells, {first:e}, {second:e}", table.cells());
    assert!(first < 2e-9 && second < 5e-15, "{first:e} {second:e}");
    assert_eq!(refused, 0);
}

#[test]
fn the_look_up_of_generated_code_is_the_same() {
    let table = build(EyeNeedle::MACHINE, TURN, false).unwrap();
    assert_eq!(table.lookup::<3>(), None);
    let lookup = table.lookup::<4>().unwrap();
    let mut random = Random::new(3);
    for _ in 0..1000 {
        let x = random.between(-10.0, 10.0);
        let (state, floor) = lookup.at(x);
        let mut checked = [0.0; 4];
        assert_eq!(floor, table.state(x, &mut checked));
        for (a, b) in state.iter().zip(checked) {
            assert!((a - b).abs() < 1e-15);
        }
    }
}

#[test]
fn states_are_those_of_the_references() {
    let lookup = build(EyeNeedle::MACHINE, TURN, false).unwrap();
    let lookup = lookup.lookup::<4>().unwrap();
    let mut triad = EyeNeedle::MACHINE;
    for [x, leg, link] in EyeNeedle::PLACES {
        let (mut state, _) = lookup.at(x);
        triad.correct(&[x], &mut state);
        let expected = [unit(leg), unit(link)].concat();
        for (a, b) in state.iter().zip(expected) {
            assert!((a - b).abs() < 2e-15, "{x}: {a} {b}");
        }
    }
    let table = Table::build(&mut TwoCranks, 0.0, &TwoCranks::start(), TURN, false).unwrap();
    println!("{} cells", table.cells());
    let lookup = table.lookup::<3>().unwrap();
    for [x, slide, link] in TwoCranks::PLACES {
        let (mut state, _) = lookup.at(x);
        TwoCranks.correct(&[x], &mut state);
        let [c, s] = unit(link);
        for (a, b) in state.iter().zip([c, s, slide / 64.0]) {
            assert!((a - b).abs() < 2e-15, "{x}: {a} {b}");
        }
    }
}

#[test]
fn many_turns_and_no_numbers() {
    let table = build(EyeNeedle::MACHINE, TURN, false).unwrap();
    let lookup = table.lookup::<4>().unwrap();
    let mut triad = EyeNeedle::MACHINE;
    for turns in [1e3, -1e3, 1e6, -1e6] {
        for part in [0.0, 0.3, 0.5, 0.77] {
            let x = TAU * turns + TAU * part;
            let (mut state, floor) = lookup.at(x);
            assert!(certified(triad.correct(&[x], &mut state), floor), "{x}");
        }
    }
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let (state, floor) = lookup.at(x);
        assert!(
            floor.is_nan() && state.iter().all(|number| number.is_nan()),
            "{x}"
        );
    }
    // So far away that nothing is left of the place in the turn: any state, but no panic.
    for x in [1e18, -1e300, f64::MAX] {
        let _ = lookup.at(x);
    }
}

#[test]
fn turning_points_are_refused_or_end_the_table() {
    let long = EyeNeedle::with_crank(120.0);
    let Err(Refusal::TurningPoint { at }) = build(long, TURN, false) else {
        panic!("{:?}", build(long, TURN, false));
    };
    let table = build(long, TURN, true).unwrap();
    let [End::Range(low), End::TurningPoint(high)] = table.ends() else {
        panic!("{:?}", table.ends());
    };
    println!("{at:.15} {low} {high:.15} {} cells", table.cells());
    assert!(low == 0.0 && (at - high).abs() < 1e-11 * TAU);
    let mut triad = long;
    // To some 1e-5 of the range.
    let near = high - 3e-5 * TAU;
    let (first, second, refused) = survey(&table, &mut triad, 0.0, near);
    println!("{first:e} {second:e} {refused}");
    assert_eq!(refused, 0);
    assert!(first < 2e-9 && second < 1e-12);
    // Closer than that what is certified is right.
    let (first, second, refused) = survey(&table, &mut triad, near, high);
    println!("{first:e} {second:e} {refused}");
    assert!(second < 1e-9);
    for beyond in [1e-9, 1e-6, 1e-3, 0.1, 1.0, 2.0] {
        let mut state = [0.0; 4];
        let floor = table.state(high + beyond, &mut state);
        let step = triad.correct(&[high + beyond], &mut state);
        assert!(!certified(step, floor), "{beyond}");
    }
}

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
    println!("{turns} {ends}");
    assert!(ends - turns < 1e-6 * turns);
    for share in [1e-2, 1e-3, 1e-4, 1e-5, 1e-6] {
        let mut triad = EyeNeedle::with_crank(turns * (1.0 - share));
        let table = Table::build(&mut triad, 0.0, &EyeNeedle::start(), TURN, false);
        let Ok(table) = table else {
            println!("{share}: {table:?}");
            continue;
        };
        let (first, second, refused) = survey(&table, &mut triad, 0.0, TAU);
        println!(
            "{share}: {} cells {first:e} {second:e} {refused}",
            table.cells()
        );
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
        println!("{low} {high}: {} cells {first:e} {second:e}", table.cells());
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
            EyeNeedle::correct(&mut { EyeNeedle::MACHINE }, &[(x[0] - zero) / unit], state)
        };
        let range = range(zero, zero + unit);
        let table = Table::build(&mut correct, zero, &EyeNeedle::start(), range, false).unwrap();
        let (first, second, refused) = survey(&table, &mut correct, zero, zero + unit);
        println!(
            "{zero} {unit}: {} cells {first:e} {second:e}",
            table.cells()
        );
        assert!(
            first < 2e-9 && second < 5e-15 && refused == 0,
            "{zero} {unit}"
        );
    }
}

#[test]
fn a_range_of_one_point() {
    for (at, turn) in [(0.0, false), (0.0, true)] {
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
            EyeNeedle::correct(&mut { EyeNeedle::MACHINE }, &[at], &mut state),
            floor
        ));
        assert!(table.state(f64::NAN, &mut state).is_nan());
    }
}

/// A length that is the square root of a function of the input.
fn root(square: impl Fn(f64) -> f64) -> impl FnMut(&[f64], &mut [f64]) -> Step {
    move |x, state| {
        let step = (square(x[0]) - state[0] * state[0]) / (2.0 * state[0]);
        let determinant = 2.0 * state[0];
        state[0] += step;
        Step {
            size: step.abs(),
            determinant,
        }
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
        println!("{:e}", (found - turning) / length);
        assert!(
            (found - turning).abs() < 1e-12 * length,
            "{found} {turning}"
        );
        let table = Table::build(&mut correct, at, &[start], range, true).unwrap();
        println!("{} cells {:?}", table.cells(), table.ends());
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
        match table {
            Ok(table) => {
                let (first, second, refused) = survey(&table, &mut correct, -1.0, 1.0);
                println!(
                    "{near}: {} cells {first:e} {second:e} {refused}",
                    table.cells()
                );
                assert!(first < 2e-9 && second < 1e-12 && refused == 0);
            }
            Err(refusal) => {
                println!("{near}: {refusal:?}");
                assert!(near < 2e-5);
            }
        }
    }
}

#[test]
fn what_is_no_solution_is_refused() {
    let nan = |_: &[f64], _: &mut [f64]| Step {
        size: f64::NAN,
        determinant: f64::NAN,
    };
    let refused = |refusal| move |result: Result<Table, Refusal>| assert_eq!(result, Err(refusal));
    let mut correct = nan;
    refused(Refusal::NotASolution)(Table::build(&mut correct, 0.0, &[1.0], TURN, false));
    let mut correct = root(|x| x);
    refused(Refusal::NotASolution)(Table::build(
        &mut correct,
        1.0,
        &[9.0],
        range(0.5, 1.0),
        false,
    ));
    refused(Refusal::NotASolution)(Table::build(
        &mut correct,
        0.0,
        &[0.0],
        range(0.0, 1.0),
        false,
    ));
    for (low, high, at) in [
        (f64::NAN, 1.0, 1.0),
        (0.5, f64::INFINITY, 1.0),
        (-f64::MAX, f64::MAX, 1.0),
        (0.5, 1.0, f64::NAN),
    ] {
        let result = Table::build(&mut correct, at, &[1.0], range(low, high), false);
        refused(Refusal::NotFinite)(result);
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
    println!("{} cells {first:e} {second:e}", table.cells());
    assert!(first < 2e-9 && second < 1e-14 && refused == 0);
    // The state is the same after a turn from here, but the equations are not.
    let at = 2.0 * (0.5 * PI - 0.5 * PI);
    let table = Table::build(&mut correct, at, &[1.5_f64.sqrt()], two, false).unwrap();
    assert_eq!(table.ends()[0], End::Range(0.0));
}
