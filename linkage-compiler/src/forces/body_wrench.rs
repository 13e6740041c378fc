//! The wrench of the loads on one body.

use linkage_symbolic::{Ex, Vn};

use crate::forces::context::Mechanics;
use crate::forces::wrench::Wrench;
use crate::forces::{context, loads, masses, motion};
use crate::model::Rotation;

/// The loads on a body alone.
pub(super) fn own_wrench<'m>(mechanics: &mut Mechanics<'_, 'm>, body: usize) -> Wrench<'m> {
    let loads = loads::loads(mechanics);
    let body_loads = &loads.bodies[body];
    let mut sum = context::zero_wrench(mechanics);
    for load in &body_loads.forces {
        let arm = mechanics.arm(body, load.point);
        let force = Wrench {
            force: load.force,
            ..context::zero_wrench(mechanics)
        };
        sum = sum
            + match load
                .mass
                .and_then(|mass| moment_of_mass(mechanics, body, mass, arm))
            {
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
    mechanics: &mut Mechanics<'_, 'm>,
    body: usize,
    mass: Ex<'m>,
    arm: Vn<'m>,
) -> Option<Vn<'m>> {
    let mechanism = mechanics.algebra.mechanism;
    let joint = &mechanism.joints[mechanism.bodies[body].joint];
    let origin = mechanics.forces.bodies.geometry.origins[body];
    let rests = joint.on.is_none() && origin.iter().all(|x| x.is_fixed());
    let is_pin = joint.kind.rotation() == Rotation::AboutAxis && !joint.kind.slides();
    if !mechanics.forces.bodies.geometry.is_plane() || !is_pin || !rests {
        return None;
    }
    let gain = motion::angular_acceleration(mechanics, body);
    let square = arm.square();
    if !gain.is_zero() && !square.is_fixed() {
        return None;
    }
    let weight = masses::gravity(mechanics.algebra).map(|gravity| mass * gravity);
    let weighs = weight.map_or(mechanics.zero_turn(), |weight| arm.moment_of(weight));
    Some(weighs - (mass * square) * gain)
}
