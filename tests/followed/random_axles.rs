//! Random axles over their whole travel against an independent solver. `LINKAGE_LONG=1` takes 1000.

use linkage_random::Random;
use nalgebra::{UnitQuaternion, Vector3};

use super::five_link_axle::FiveLinkAxle;
use super::independent::{Pose, Rods};
use super::long;

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
