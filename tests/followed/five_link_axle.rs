//! A wheel carrier on five rods with ball joints, by the travel of the wheel: eight unknowns remain.

use super::independent::{Pose, Rods};
use super::{close, long, number, numbers, read};
use linkage::{AssemblyError, ClosestApproach, CoupledCause, Missed, Unlisted};
use linkage_interpreted::interpreted;
use linkage_random::Random;
use nalgebra::{UnitQuaternion, Vector3};

interpreted! {
    /// The wheel is at `p`; its carrier has the directions `x`, `y` and `z`.
    pub struct FiveLinkAxle {
        unit mm;
        param l1 = 287.31515797117283314mm;
        param l2 = 256.75864152935534645mm;
        param l3 = 318.62987932709637832mm;
        param l4 = 451.60823730308551581mm;
        param l5 = 376.15422369023054744mm;
        param inner1 = (110mm, 420mm, 430mm);
        param inner2 = (-85mm, 435mm, 440mm);
        param inner3 = (265mm, 480mm, 265mm);
        param inner4 = (-60mm, 255mm, 215mm);
        param inner5 = (-190mm, 316mm, 258mm);
        param outer1 = (15mm, -70mm, 135mm);
        param outer2 = (-30mm, -75mm, 140mm);
        param outer3 = (40mm, -60mm, -105mm);
        param outer4 = (-25mm, -55mm, -120mm);
        param outer5 = (-150mm, -70mm, -58mm);
        input travel = 0mm in -80mm..80mm;
        unknown p = (0mm, 760mm, 320mm);
        unknown x = (1, 0, 0);
        unknown y = (0, 1, 0);
        let z = cross(x, y);
        loop norm(x) = 1;
        loop norm(y) = 1;
        loop dot(x, y) = 0;
        loop p.z = 320mm + travel;
        loop distance(p + outer1.x * x + outer1.y * y + outer1.z * z, inner1) = l1;
        loop distance(p + outer2.x * x + outer2.y * y + outer2.z * z, inner2) = l2;
        loop distance(p + outer3.x * x + outer3.y * y + outer3.z * z, inner3) = l3;
        loop distance(p + outer4.x * x + outer4.y * y + outer4.z * z, inner4) = l4;
        loop distance(p + outer5.x * x + outer5.y * y + outer5.z * z, inner5) = l5;
        let spindle = unit(0.0035 * x + y + 0.0175 * z);
    }

    impl FiveLinkAxle {
        pub fn wheel(travel) -> Wheel { p, x, y, spindle }
        pub fn motion(travel) -> Motion { v: velocity(p), a: acceleration(p), turn: velocity(spindle) }
        pub fn adjustment(travel) -> Adjustment { p: sensitivity(p, [l1, l2, l3, l4, l5]), m: margin() }
    }
}

fn references() -> Vec<serde_json::Value> {
    read(include_str!("five_link_axle.json"))
}

#[test]
fn the_wheel_is_where_it_was_computed_with_80_digits() {
    let axle = FiveLinkAxle::default().assemble().expect("it assembles");
    let method = FiveLinkAxle::structure().groups[1].method;
    // Three loops of degree 2, five of degree 4, as `y` and `z` are written.
    assert_eq!(
        method,
        "followed from the estimates; up to 8192 complex solutions (by degrees) not listed; prepared table over the input, one Newton \
         step, certificate"
    );
    let references = references();
    assert_eq!(references.len(), 17);
    for known in references {
        let z = number(&known["z"]);
        let wheel = axle.wheel(z);
        let found: [f64; 3] = wheel.p.into();
        for (found, known) in found.into_iter().zip(numbers::<3>(&known["p"])) {
            close(found, known, 760.0, 1e-14);
        }
        let found: [f64; 3] = wheel.spindle.into();
        for (found, known) in found.into_iter().zip(numbers::<3>(&known["spindle"])) {
            close(found, known, 1.0, 1e-14);
        }
    }
}

#[test]
fn derivatives_are_those_computed_with_80_digits() {
    let axle = FiveLinkAxle::default().assemble().expect("it assembles");
    for known in references() {
        let z = number(&known["z"]);
        let (wheel, motion) = (axle.wheel(z), axle.motion(z));
        for (k, name) in ["x", "y"].into_iter().enumerate() {
            close(motion.v[k], number(&known["d_dz"][name]), 1.0, 1e-13);
            close(
                motion.a[k],
                number(&known["d2_dz2"][name]),
                1.0 / 80.0,
                1e-12,
            );
        }
        let (s, turn) = (wheel.spindle, motion.turn);
        let toe = (turn.x * s.y - s.x * turn.y) / (s.x * s.x + s.y * s.y);
        close(toe, number(&known["d_dz"]["toe"]), 1e-3, 1e-12);
    }
}

#[test]
fn sensitivities_are_those_computed_with_80_digits() {
    let axle = FiveLinkAxle::default().assemble().expect("it assembles");
    for known in references() {
        let found = axle.adjustment(number(&known["z"]));
        for rod in 0..5 {
            let known = &known["sensitivity"][format!("L{}", rod + 1)];
            close(found.p[rod].x, number(&known["x"]), 1.0, 1e-12);
            close(found.p[rod].y, number(&known["y"]), 1.0, 1e-12);
            close(found.p[rod].z, 0.0, 1.0, 1e-15);
        }
    }
}

#[test]
fn rough_estimates_lead_to_the_assembly_of_a_larger_axle_too() {
    let own = FiveLinkAxle::default();
    let larger = FiveLinkAxle {
        l1: own.l1 + 1.5,
        l2: own.l2 - 1.0,
        l3: own.l3 + 0.7,
        l4: own.l4 - 1.2,
        l5: own.l5 + 2.0,
        ..own
    };
    let direct = larger.assemble().expect("it assembles");
    let from = own.assemble().expect("it assembles");
    let followed = larger.assemble_from(&from).expect("it is followed");
    for travel in [-80.0, -31.0, 0.0, 55.5, 80.0] {
        let [a, b] = [&direct, &followed].map(|axle| axle.wheel(travel).p);
        assert!((a - b).norm() < 1e-11, "{a} {b}");
        assert!((a - from.wheel(travel).p).norm() > 0.5);
    }
    assert_eq!(larger.assemblies().expect("one is found").len(), 1);
}

#[test]
fn what_needs_all_solutions_says_that_they_are_not_listed() {
    let error = FiveLinkAxle::default().circuits().expect_err("not listed");
    let AssemblyError::Coupled(error) = error else {
        panic!("{error}")
    };
    assert_eq!(error.cause, CoupledCause::NotListed(Unlisted::Followed));
}

#[test]
fn a_rod_that_is_too_short_is_told_with_what_misses_where_loops_come_nearest_to_closing() {
    let own = FiveLinkAxle::default();
    let short = FiveLinkAxle { l1: 87.0, ..own };
    let error = short.assemble().expect_err("out of reach");
    let text = error.to_string();
    let AssemblyError::Coupled(error) = error else {
        panic!("{text}")
    };
    let CoupledCause::NotReached {
        closest_approach: ClosestApproach::Misses(missed),
        ..
    } = error.cause
    else {
        panic!("{text}")
    };
    for told in [
        "FiveLinkAxle: loops 1, 2, 3, 5, 6, 7, 8 and 9 (p, x, y; 8 loops in space) cannot be reached from its estimates",
        "; where its loops come nearest to closing from there, loop 5 misses by 32.57",
        " mm, loop 6 by -25.2",
        "and 2 more by less: there the links do not reach each other",
    ] {
        assert!(text.contains(told), "{text}");
    }
    let (lengths, plain): (Vec<&Missed>, Vec<&Missed>) =
        missed.iter().partition(|own| own.number >= 5);
    assert!(lengths.iter().all(|own| own.unit == "mm"), "{text}");
    assert!(plain.iter().all(|own| own.unit.is_empty()), "{text}");
    // Where the wheel is with the longer rod, this one alone misses.
    let alone = own.l1 - short.l1;
    let squares = lengths.iter().map(|own| own.by * own.by);
    assert!(squares.sum::<f64>() < 0.1 * alone * alone, "{text}");
}

#[test]
fn beyond_the_range_there_is_nothing_and_within_it_no_jump() {
    let axle = FiveLinkAxle::default().assemble().expect("it assembles");
    assert!(axle.wheel(120.0).p.x.is_nan());
    let mut before = axle.wheel(-80.0);
    for k in 1..=16_000 {
        let wheel = axle.wheel(-80.0 + 0.01 * f64::from(k));
        assert!((wheel.p - before.p).norm() < 0.02);
        assert!((wheel.spindle - before.spindle).norm() < 1e-4);
        before = wheel;
    }
}

// Random axles over their whole travel against an independent solver. `LINKAGE_LONG=1` takes 1000.

/// How far both solvers may be apart, in radians.
const APART: f64 = 1e-9;
/// Ranges end beside a dead point; a larger part of the determinant at the reference is away from it.
const DEAD: f64 = 0.1;

#[test]
fn random_axles_travel_as_an_independent_solver_says() {
    let own = FiveLinkAxle::default();
    let mut random = Random::new(3);
    let count = if long() { 1000 } else { 3 };
    let (mut served, mut ended, mut otherwise) = (0, 0, Vec::new());
    for number in 0..count {
        let mut near = |place: Vector3<f64>| place.map(|own| own + random.between(-30.0, 30.0));
        let [inner1, inner2, inner3, inner4, inner5] =
            [own.inner1, own.inner2, own.inner3, own.inner4, own.inner5].map(&mut near);
        let [outer1, outer2, outer3, outer4, outer5] =
            [own.outer1, own.outer2, own.outer3, own.outer4, own.outer5].map(&mut near);
        let rods = Rods {
            on_body: vec![outer1, outer2, outer3, outer4, outer5],
            on_ground: vec![inner1, inner2, inner3, inner4, inner5],
        };
        let estimate = Pose {
            p: Vector3::new(0.0, 760.0, 320.0),
            turn: UnitQuaternion::identity(),
        };
        let mut planted = estimate.moved(&mut random, 5.0, 0.01);
        planted.p.z = 320.0;
        let [l1, l2, l3, l4, l5, height] = rods.lengths(&planted);
        let axle = FiveLinkAxle {
            l1,
            l2,
            l3,
            l4,
            l5,
            inner1,
            inner2,
            inner3,
            inner4,
            inner5,
            outer1,
            outer2,
            outer3,
            outer4,
            outer5,
        };
        let travels = (-8..=8).map(|k| 10.0 * f64::from(k));
        let there = |travel: f64| rods.go(&planted, &[l1, l2, l3, l4, l5, height + travel], 1.0);
        match axle.assemble() {
            Ok(axle) => {
                served += 1;
                for travel in travels {
                    let wheel = axle.wheel(travel);
                    let away = there(travel).map(|pose| pose.away(wheel.p, wheel.x, wheel.y));
                    match away {
                        Ok(away) if away < APART => {}
                        other => otherwise.push(format!("{number} at {travel}: {other:?}")),
                    }
                }
            }
            Err(error) => {
                // Somewhere in the range it is hardly held, or not at all.
                let hold = |pose: &Pose| (rods.hold(pose) / rods.hold(&planted)).abs();
                let least = travels.map(|travel| there(travel).map_or(0.0, |pose| hold(&pose)));
                let least = least.fold(1.0, f64::min);
                match least < DEAD {
                    true => ended += 1,
                    false => otherwise.push(format!("{number}: {error}, {least} is left")),
                }
            }
        }
    }
    println!(
        "{served} axles served, {ended} refused with a dead point in the range, otherwise {otherwise:#?}"
    );
    assert_eq!(otherwise, [""; 0]);
}
