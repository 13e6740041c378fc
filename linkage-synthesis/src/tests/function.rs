//! Function generation: planted four-bars come back, every solution closes.

use super::super::*;
use core::f64::consts::{PI, TAU};
use linkage_random::Random;
use std::string::ToString;
use std::vec::Vec;

/// A four-bar and pairs of turns on one branch of it.
fn planted<const N: usize>(random: &mut Random) -> (FunctionFourBar, [Pair; N]) {
    loop {
        let four_bar = FunctionFourBar {
            crank: random.between(0.2, 0.9),
            coupler: random.between(0.6, 1.5),
            rocker: random.between(0.4, 1.2),
            input_start: random.between(-PI, PI),
            output_start: random.between(-PI, PI),
        };
        let mut input = 0.0;
        let pairs = [(); N].map(|()| {
            input += random.between(0.2, 0.6);
            let angle = four_bar.input_start + input;
            let pin = [four_bar.crank * angle.cos(), four_bar.crank * angle.sin()];
            let (x, y) = (pin[0] - 1.0, pin[1]);
            let (
                distance,
                FunctionFourBar {
                    coupler, rocker, ..
                },
            ) = (x.hypot(y), four_bar);
            let cosine = (distance * distance + rocker * rocker - coupler * coupler)
                / (2.0 * distance * rocker);
            Pair::new(input, y.atan2(x) + cosine.acos() - four_bar.output_start)
        });
        // Out of reach the arc cosine is not a number.
        if pairs.iter().all(|pair| pair.output.is_finite()) {
            return (four_bar, pairs);
        }
    }
}

fn same_angle(a: f64, b: f64) -> bool {
    let turns = (a - b) / TAU;
    (turns - turns.round()).abs() < 1e-7
}

fn is_among(known: &FunctionFourBar, found: &Functions) -> bool {
    found.four_bars.iter().any(|four_bar| {
        let lengths = [
            four_bar.crank - known.crank,
            four_bar.coupler - known.coupler,
            four_bar.rocker - known.rocker,
        ];
        lengths.iter().all(|difference| difference.abs() < 1e-6)
            && same_angle(four_bar.input_start, known.input_start)
            && same_angle(four_bar.output_start, known.output_start)
    })
}

fn closes(found: &Functions, pairs: &[Pair]) {
    for four_bar in &found.four_bars {
        let sizes = [1.0, four_bar.crank, four_bar.coupler, four_bar.rocker];
        let size = sizes.into_iter().fold(0.0, f64::max);
        for pair in pairs {
            let (_, error) = four_bar.pose(pair);
            assert!(error.abs() < 1e-10 * size, "{error} {four_bar:?}");
        }
    }
}

#[test]
fn five_pairs_with_both_starts_free() {
    let mut random = Random::new(3);
    let mut counts = [0; 4];
    for _ in 0..60 {
        let (known, pairs) = planted::<5>(&mut random);
        let found = Functions::of_five(&pairs).unwrap();
        assert!(
            found.certified && found.four_bars.len() + found.complex == 3,
            "{found:?}"
        );
        assert!(is_among(&known, &found), "{known:?} {found:?}");
        closes(&found, &pairs);
        counts[found.four_bars.len()] += 1;
    }
    assert!(
        counts[1] > 0 && counts[3] > 0 && counts[0] + counts[2] == 0,
        "{counts:?}"
    );
}

#[test]
fn four_pairs_with_one_start_given() {
    let mut random = Random::new(4);
    for _ in 0..60 {
        let (known, pairs) = planted::<4>(&mut random);
        for start in [
            GivenStart::Input(known.input_start),
            GivenStart::Output(known.output_start),
        ] {
            let found = Functions::of_four(&pairs, start).unwrap();
            assert!(found.certified && found.four_bars.len() + found.complex == 2);
            assert!(is_among(&known, &found), "{known:?} {found:?}");
            closes(&found, &pairs);
        }
    }
}

#[test]
fn three_pairs_with_both_starts_given() {
    let mut random = Random::new(5);
    for _ in 0..60 {
        let (known, pairs) = planted::<3>(&mut random);
        let found = Functions::of_three(&pairs, known.input_start, known.output_start).unwrap();
        assert!(is_among(&known, &found), "{known:?} {found:?}");
        closes(&found, &pairs);
    }
}

#[test]
fn passage_of_planted_pairs() {
    let mut random = Random::new(6);
    for _ in 0..60 {
        let (known, pairs) = planted::<5>(&mut random);
        let passage = known.passage(&pairs);
        assert!(
            passage.one_branch(0) && passage.in_order,
            "{known:?} {passage:?}"
        );
    }
}

#[test]
fn pairs_that_depend_on_each_other_are_refused() {
    // A parallelogram of any lengths turns both links alike.
    let alike: [Pair; 5] = core::array::from_fn(|i| Pair::new(0.3 * i as f64, 0.3 * i as f64));
    let refused = Functions::of_five(&alike).unwrap_err();
    assert!(matches!(refused, Unsolved::Dependent { .. }), "{refused}");
    let [a, b, c, d, _] = alike;
    let refused = Functions::of_four(&[a, b, a, d], GivenStart::Input(0.0)).unwrap_err();
    assert_eq!(refused, Unsolved::Equal { indices: [0, 2] });
    let far = Pair::new(f64::INFINITY, 0.0);
    let refused = Functions::of_three(&[a, far, c], 0.0, 0.0).unwrap_err();
    assert_eq!(refused, Unsolved::NotFinite { index: 1 });
    let messages: Vec<_> = [refused].iter().map(ToString::to_string).collect();
    assert_eq!(messages, ["condition 1 has a number that is not finite"]);
}
