//! Joints with friction: their surfaces, and the force or couple that follows.

use linkage_symbolic::{Ex, Vector, Vn};

use crate::algebra::{Algebra, Translate};
use crate::forces::body_loads::Loads;
use crate::forces::multibody::Multibody;
use crate::forces::speeds::{AngularVelocities, Speeds};
use crate::forces::springs;
use crate::forces::wrench::Wrench;
use crate::model::{Contact, Friction};

/// The contact forces of a joint's surfaces, as parts of its reaction: the force of a pin, the
/// normal force of a guide, or those at both ends of a block, `N / 2 + M / l` and `N / 2 - M / l`.
pub(super) fn surface_forces<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    friction: &Friction,
    reaction: Wrench<'m>,
) -> Vec<Vn<'m>> {
    let force = reaction.force;
    let (Contact::Guide(length), Some(guide)) = (
        &friction.contact,
        bodies.geometry.directions[friction.joint],
    ) else {
        return vec![force];
    };
    let normal = guide.moment_of(force).at(0);
    let Some(length) = length else {
        return vec![Vector([normal]).into()];
    };
    let couple = reaction.moment.at(0) / algebra.translate_number(length);
    let half = 0.5 * normal;
    [half + couple, half - couple]
        .map(|end| Vector([end]).into())
        .to_vec()
}

/// The friction of a joint for each unit of contact force: a force, or a couple in a pin.
pub(super) fn rate_of_friction<'m>(algebra: &mut Algebra<'m>, friction: &Friction) -> Ex<'m> {
    let coefficient = algebra.translate_number(&friction.coefficient);
    match &friction.contact {
        Contact::Pin(radius) => coefficient * algebra.translate_number(radius),
        Contact::Guide(_) => coefficient,
    }
}

/// Adds the friction of a joint to both of its bodies, against a positive speed.
pub(super) fn add_friction<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    loads: &mut Loads<'m>,
    friction: &Friction,
    contact_force: Ex<'m>,
) {
    let size = rate_of_friction(algebra, friction) * contact_force;
    let joint = &algebra.mechanism.joints[friction.joint];
    let (point, on_body) = match (
        &friction.contact,
        bodies.geometry.directions[friction.joint],
    ) {
        (Contact::Guide(_), Some(guide)) => (
            Some(bodies.geometry.points[friction.joint]),
            -(size * guide),
        ),
        (Contact::Guide(_), None) | (Contact::Pin(_), _) => (None, Vector([-size]).into()),
    };
    loads.add(Some(joint.body), point, on_body);
    loads.add(joint.on, point, -on_body);
}

/// The sign of the speed at which a joint's body turns or slides on the other, 0 at rest.
pub(super) fn sense<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    speeds: &Speeds,
    friction: &Friction,
) -> Ex<'m> {
    let speed = springs::joint_speed(algebra, bodies, turns, speeds, friction.joint);
    let [minus, zero, one] = [-1.0, 0.0, 1.0].map(|value| speed.number(value));
    speed.select((-speed).select(zero, one), minus)
}
