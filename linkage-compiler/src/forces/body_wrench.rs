//! The wrench of the loads on one body.

use linkage_symbolic::{Ex, Vn};

use crate::algebra::Algebra;
use crate::forces::context::Memo;
use crate::forces::loading::Loading;
use crate::forces::multibody::Multibody;
use crate::forces::speeds::{AngularVelocities, Speeds};
use crate::forces::wrench::Wrench;
use crate::forces::{loads, masses, motion};

/// The loads on a body alone.
pub(super) fn own_wrench<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    loading: &Loading,
    body: usize,
) -> Wrench<'m> {
    let loads = loads::loads(algebra, bodies, memo, loading);
    let speeds = &loading.speeds;
    let body_loads = &loads.bodies[body];
    let mut sum = Wrench::zero(algebra.graph, &bodies.geometry);
    for load in &body_loads.forces {
        let arm = bodies.arm(body, load.point);
        let force = Wrench {
            force: load.force,
            ..Wrench::zero(algebra.graph, &bodies.geometry)
        };
        sum = sum
            + match load.mass.and_then(|mass| {
                moment_of_mass(algebra, bodies, &mut memo.turns, speeds, body, mass, arm)
            }) {
                Some(moment) => Wrench { moment, ..force },
                None => force.with_arm(arm),
            };
    }
    for &couple in &body_loads.couples {
        sum.moment = sum.moment + couple;
    }
    sum
}

/// The moment of a mass, its inertia and weight, about its body's own joint, if that is a pin of
/// the plane on the frame. A body that turns at a constant speed has only the moment of its weight.
pub(super) fn moment_of_mass<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    speeds: &Speeds,
    body: usize,
    mass: Ex<'m>,
    arm: Vn<'m>,
) -> Option<Vn<'m>> {
    if !bodies.turns_about_fixed_pin(algebra.mechanism, body) {
        return None;
    }
    let gain = motion::angular_acceleration(algebra, bodies, turns, speeds, body);
    let square = arm.square();
    if !gain.is_zero() && !square.is_fixed() {
        return None;
    }
    let weight = masses::gravity(algebra).map(|gravity| mass * gravity);
    let weighs = weight.map_or(bodies.geometry.zero_turn(algebra.graph), |weight| {
        arm.moment_of(weight)
    });
    Some(weighs - (mass * square) * gain)
}
