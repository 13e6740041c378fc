//! Tables over a full turn and over other ranges.

use crate::triads::{EyeNeedle, TwoCranks, unit};
use crate::{TURN, build, certified, survey};
use linkage_random::Random;
use linkage_runtime::FUSED;
use linkage_runtime::numeric::continuation::{Correction, End, Refusal, Table};
use std::f64::consts::TAU;

#[test]
fn a_closed_table_is_one_step_from_the_solution() {
    let table = build(EyeNeedle::MACHINE, TURN, false).unwrap();
    assert_eq!(table.ends(), [End::Closed; 2]);
    assert!(table.error() <= 1e-9, "{}", table.error());
    let mut triad = EyeNeedle::MACHINE;
    let (first, second, refused) = survey(&table, &mut triad, -20.0, 20.0);
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
        let (state, floor) = lookup.state_at(x);
        let mut checked = [0.0; 4];
        assert_eq!(
            floor,
            table.look_up::<{ linkage_runtime::FUSED }>(x, &mut checked)
        );
        assert_eq!(state, checked);
        assert_eq!(floor, table.state(x, &mut checked));
        for (a, b) in state.iter().zip(checked) {
            assert!((a - b).abs() < 1e-15);
        }
    }
}

#[test]
fn many_look_ups_are_the_same() {
    const ROWS: usize = 32;
    let table = build(EyeNeedle::MACHINE, TURN, false).unwrap();
    let lookup = table.lookup::<4>().unwrap();
    let mut random = Random::new(4);
    for vectors in 0..=4 {
        let mut x: [f64; ROWS] = std::array::from_fn(|_| random.between(-10.0, 10.0));
        (x[3], x[5]) = (f64::NAN, f64::INFINITY);
        let mut columns = [[f64::NEG_INFINITY; ROWS]; 5];
        lookup.fill::<f64, FUSED, 8, ROWS>(&x, vectors, &mut columns);
        for (row, x) in x.into_iter().enumerate() {
            let (state, floor) = lookup.state_at(x);
            let numbers = state.into_iter().chain([floor]);
            for (number, column) in numbers.zip(columns) {
                let expected = match row < 8 * vectors {
                    true => number,
                    false => f64::NEG_INFINITY,
                };
                assert!(
                    column[row].to_bits() == expected.to_bits()
                        || column[row].is_nan() && expected.is_nan()
                );
            }
        }
    }
}

#[test]
fn states_are_those_of_the_references() {
    let lookup = build(EyeNeedle::MACHINE, TURN, false).unwrap();
    let lookup = lookup.lookup::<4>().unwrap();
    let mut triad = EyeNeedle::MACHINE;
    for [x, leg, link] in EyeNeedle::PLACES {
        let (mut state, _) = lookup.state_at(x);
        triad.correct(&[x], &mut state);
        let expected = [unit(leg), unit(link)].concat();
        for (a, b) in state.iter().zip(expected) {
            assert!((a - b).abs() < 2e-15, "{x}: {a} {b}");
        }
    }
    let table = Table::build(&mut TwoCranks, 0.0, &TwoCranks::start(), TURN, false).unwrap();
    let lookup = table.lookup::<3>().unwrap();
    for [x, slide, link] in TwoCranks::PLACES {
        let (mut state, _) = lookup.state_at(x);
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
            let (mut state, floor) = lookup.state_at(x);
            assert!(certified(triad.correct(&[x], &mut state), floor), "{x}");
        }
    }
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let (state, floor) = lookup.state_at(x);
        assert!(
            floor.is_nan() && state.iter().all(|number| number.is_nan()),
            "{x}"
        );
    }
    // So far away that nothing is left of the place in the turn: any state, but no panic.
    for x in [1e18, -1e300, f64::MAX] {
        let _ = lookup.state_at(x);
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
    assert!(low == 0.0 && (at - high).abs() < 1e-11 * TAU);
    let mut triad = long;
    // To some 1e-5 of the range.
    let near = high - 3e-5 * TAU;
    let (first, second, refused) = survey(&table, &mut triad, 0.0, near);
    assert_eq!(refused, 0);
    assert!(first < 2e-9 && second < 1e-12);
    // Closer than that what is certified is right.
    let (_, second, _) = survey(&table, &mut triad, near, high);
    assert!(second < 1e-9);
    let lookup = table.lookup::<4>().unwrap();
    for beyond in [0.1, 1.0, 2.0] {
        // What is extrapolated is told by the floor.
        assert!(lookup.state_at(high + beyond).1.is_nan(), "{beyond}");
    }
    for beyond in [1e-9, 1e-6, 1e-3, 0.1, 1.0, 2.0] {
        let mut state = [0.0; 4];
        let floor = table.state(high + beyond, &mut state);
        let step = triad.correct(&[high + beyond], &mut state);
        assert!(!certified(step, floor), "{beyond}");
    }
}
