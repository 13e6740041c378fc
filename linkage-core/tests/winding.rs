//! How angles turn over a range.
#![cfg(any(feature = "std", feature = "libm"))]

use linkage_core::Scalar;
use linkage_core::numeric::winding::{Centre, Winding, follow, uniform};
use std::f64::consts::{PI, TAU};

const RATES: [f64; 7] = [0.0, 1.0, -1.0, 2.0, -2.0, 0.5, -0.5];

fn direction(angle: f64) -> [f64; 2] {
    [3.0 * angle.cos(), 3.0 * angle.sin()]
}

/// Follows `angle` and checks that the guide leads back to it everywhere.
fn guided(lo: f64, hi: f64, reference: f64, angle: impl Fn(f64) -> f64) -> Winding {
    let estimate = angle(reference) + 0.4;
    let winding = follow(lo, hi, reference, estimate, &RATES, |x| direction(angle(x))).unwrap();
    for step in 0..=1000 {
        let x = lo + (hi - lo) * f64::from(step) / 1000.0;
        let [cos, sin] = direction(angle(x));
        let found = f64::angle_near(sin, cos, winding.centre + winding.turns * x);
        assert!(
            (found - angle(x)).abs() < 1e-9,
            "at {x}: {found}, not {}",
            angle(x)
        );
    }
    winding
}

#[test]
fn a_crank_turns_with_the_input() {
    let winding = guided(0.0, TAU, 0.5, |x| x + 0.3);
    assert_eq!(winding.turns, 1.0);
    assert!((winding.centre - 0.3).abs() < 1e-12);
    assert_eq!(guided(0.0, TAU, 0.5, |x| 1.0 - x).turns, -1.0);
}

#[test]
fn a_drag_link_turns_with_the_input() {
    let winding = guided(0.0, 2.0 * TAU, 0.5, |x| x + 0.9 * x.sin());
    assert_eq!(winding.turns, 1.0);
}

#[test]
fn a_rocker_does_not_turn() {
    let winding = guided(0.0, TAU, 0.5, |x| 2.0 + 0.8 * x.cos());
    assert_eq!(winding.turns, 0.0);
    assert!((winding.centre - 2.0).abs() < 1e-3);
}

#[test]
fn a_gear_turns_at_its_ratio() {
    assert_eq!(guided(0.0, 4.0 * TAU, 0.5, |x| 0.5 * x).turns, 0.5);
    assert_eq!(guided(0.0, 4.0 * TAU, 0.5, |x| 4.0 - 2.0 * x).turns, -2.0);
    // None of the candidates: the mean slope.
    assert!((guided(0.0, 5.0 * TAU, 0.5, |x| 1.0 - 3.5 * x).turns + 3.5).abs() < 1e-12);
}

#[test]
fn whole_turns_of_the_estimate_are_kept() {
    let estimate = 0.3 + 5.0 * TAU;
    let winding = follow(0.0, TAU, 0.0, estimate, &RATES, |x| direction(x + 0.2)).unwrap();
    assert!((winding.centre - 0.2 - 5.0 * TAU).abs() < 1e-12);
}

#[test]
fn a_range_of_many_turns_is_followed() {
    let winding = guided(-300.0 * TAU, 700.0 * TAU, 0.5, |x| x + 0.5 * x.sin());
    assert_eq!(winding.turns, 1.0);
}

#[test]
fn a_short_range_needs_no_turns() {
    assert_eq!(guided(0.0, 2.0, 0.5, |x| x + 0.3).turns, 0.0);
}

#[test]
fn a_fast_swing_is_followed_in_small_steps() {
    // Three turns within a hundredth of the range, and back.
    let angle = |x: f64| 3.0 * PI * ((x - 3.0) * 400.0).tanh() + 3.0 * PI;
    let swing = |x: f64| angle(x) - 3.0 * PI * ((x - 3.2) * 400.0).tanh();
    let found = follow(0.0, TAU, 0.5, 0.0, &RATES, |x| direction(swing(x)));
    // It strays by three turns from every line.
    assert_eq!(found, None);
    let winding = guided(0.0, TAU, 0.5, |x| 1.2 * ((x - 3.0) * 400.0).tanh());
    assert_eq!(winding.turns, 0.0);
}

#[test]
fn the_angle_is_followed_as_far_as_it_exists() {
    // Works for |x| < 2 only, with infinite slope at the ends.
    let angle = |x: f64| (0.5 * x).acos();
    let winding = follow(-3.0, 3.0, 0.0, 1.5, &RATES, |x| direction(angle(x))).unwrap();
    assert_eq!(winding.turns, 0.0);
    assert!((winding.centre - 0.5 * PI).abs() < 1e-3, "{winding:?}");
}

#[test]
fn nothing_to_follow() {
    let nowhere = |_: f64| [f64::NAN, 0.0];
    assert_eq!(follow(0.0, 1.0, 0.5, 0.0, &RATES, nowhere), None);
    assert_eq!(follow(0.0, 1.0, 0.5, 0.0, &RATES, |_| [0.0, 0.0]), None);
    assert_eq!(follow(0.0, f64::NAN, 0.5, 0.0, &RATES, direction), None);
    let point = follow(1.0, 1.0, 1.0, 0.0, &RATES, direction).unwrap();
    assert_eq!(point.turns, 0.0);
    assert!((point.centre - 1.0).abs() < 1e-15);
}

#[test]
fn without_candidates_the_mean_slope_is_taken() {
    let winding = follow(0.0, 3.0 * TAU, 0.0, 0.0, &[], direction).unwrap();
    assert!((winding.turns - 1.0).abs() < 1e-12);
}

#[test]
fn an_angle_that_nearly_strays_by_half_a_turn_is_refused() {
    let swing = |share: f64| {
        follow(0.0, TAU, 0.0, 0.0, &[0.0], |x| {
            direction(share * PI * x.sin())
        })
    };
    assert!(swing(0.94).is_some_and(|winding| winding.turns == 0.0));
    assert_eq!(swing(0.96), None);
}

#[test]
fn a_slow_guide_is_taken_up_to_its_comfort() {
    // Half of the range is what a crank strays from an angle that stands still.
    assert_eq!(guided(0.0, 1.59 * PI, 0.5, |x| x).turns, 0.0);
    assert_eq!(guided(0.0, 1.61 * PI, 0.5, |x| x).turns, 1.0);
}

#[test]
fn ranges_of_too_many_turns_are_not_walked() {
    let turns = |radians: f64| follow(0.0, radians, 0.0, 0.0, &[0.0, 1.0, -2.0], direction);
    // The fastest candidate turns twice as far.
    assert!(turns(8191.0).is_some_and(|winding| winding.turns == 1.0));
    assert_eq!(turns(8193.0), None);
}

/// Middles of several motions add up as long as the angle at the start keeps a tenth of its half turn.
#[test]
fn middles_of_several_inputs_add_up_or_are_shared() {
    let centre = |middles: [f64; 2]| {
        let mut centre = Centre::new(0.7);
        for (middle, (turns, x)) in middles.into_iter().zip([(1.0, 0.4), (-0.5, 3.0)]) {
            let along = Winding {
                centre: 0.7 + middle * PI - turns * x,
                turns,
            };
            centre.add(along, x);
        }
        centre.value() + 1.0 * 0.4 - 0.5 * 3.0 - 0.7
    };
    for (middles, sum) in [
        ([0.1, 0.2], 0.3),
        ([0.44, 0.45], 0.89),
        ([-0.44, -0.45], -0.89),
        ([0.45, 0.46], 0.455),
        ([-0.6, -0.5], -0.55),
        ([0.6, -0.5], 0.1),
    ] {
        assert!((centre(middles) - sum * PI).abs() < 1e-14, "{middles:?}");
    }
}

/// An angle half a quarter turn ahead of the sum of vectors is what following it finds, at any number of turns.
#[test]
fn the_longest_of_several_vectors_gives_the_turns() {
    let vectors = [[3.0, -4.0], [0.0, 12.0], [0.0, 0.0], [-4.0, 0.0]];
    let turns = [Some([0.0, 0.0]), Some([1.0, -2.5]), Some([7.0, 7.0]), None];
    let sum = |[x, y]: [f64; 2], other: f64| {
        let (sin, cos) = (x - 2.5 * y).sin_cos();
        [
            3.0 - 12.0 * sin - 4.0 * other.cos(),
            -4.0 + 12.0 * cos - 4.0 * other.sin(),
        ]
    };
    for (whole, start) in [(0.0, [0.3, 0.9]), (5.0, [-7.0, 2.0]), (-3.0, [0.0, 40.0])] {
        let angle = |x: [f64; 2], guide: f64| {
            let [cos, sin] = sum(x, 11.0 * x[0]);
            f64::angle_near(sin, cos, guide) + PI / 4.0
        };
        let here = angle(start, whole * TAU);
        let (centre, turns) = uniform(&vectors, &turns, &start, here).unwrap();
        assert_eq!(turns, [1.0, -2.5]);
        let mut last = here;
        for step in 0..=4000 {
            let part = f64::from(step) / 4000.0;
            let x = [start[0] + 20.0 * part, start[1] - 30.0 * part];
            let guide = centre + turns[0] * x[0] + turns[1] * x[1];
            last = angle(x, last - PI / 4.0);
            assert!((last - guide).abs() < PI, "{last} beside {guide}");
        }
    }
}

/// 0.95 pi is the most that an angle may stray; nothing decides where vectors are no numbers, vanish, or turn in an unknown way.
#[test]
fn vectors_that_do_not_decide() {
    let most = (0.45 * PI).sin();
    let of = |vectors: &[[f64; 2]]| {
        let turns = [Some([0.0]), Some([1.0])];
        uniform(vectors, &turns[..vectors.len()], &[0.0], 0.1)
    };
    for (beside, decides) in [(most - 1e-12, true), (most + 1e-12, false)] {
        assert_eq!(of(&[[0.0, 1.0], [beside, 0.0]]).is_some(), decides);
        assert_eq!(of(&[[0.0, beside], [1.0, 0.0]]).is_some(), decides);
    }
    assert_eq!(of(&[]), None);
    assert_eq!(of(&[[0.0, 0.0]]), None);
    assert_eq!(of(&[[f64::NAN, 0.0]]), None);
    assert_eq!(of(&[[1.0, 0.0], [f64::NAN, 0.0]]), None);
    assert_eq!(of(&[[f64::INFINITY, 0.0], [1.0, 0.0]]), None);
    assert_eq!(uniform(&[[1.0, 0.0]], &[None::<[f64; 0]>], &[], 0.0), None);
    let (centre, _) = of(&[[0.0, 1.0]]).unwrap();
    assert_eq!(centre, PI / 2.0);
}
