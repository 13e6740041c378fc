//! The quantities that functions ask for.

use linkage_symbolic::{Ex, Vn};

use crate::algebra::{Translate, Value};
use crate::forces::context::Mechanics;
use crate::forces::speeds::By;
use crate::forces::system::Unknown;
use crate::forces::wrench::Wrench;
use crate::forces::{assemble, equilibrium, freedom, geometry, inertia, loads, masses, motion};
use crate::model::{Between, Element, ElementKind, MechanicalQuantity as Quantity, Rotation};

pub(crate) fn quantity<'m>(mechanics: &mut Mechanics<'_, 'm>, quantity: &Quantity) -> Value<'m> {
    match quantity {
        Quantity::Reaction(joint) => reaction(mechanics, *joint).force.into(),
        Quantity::Moment(joint) => turn_value(reaction(mechanics, *joint).moment),
        Quantity::Drive(input) => drive(mechanics, *input).into(),
        Quantity::Power => power(mechanics).into(),
        Quantity::KineticEnergy => kinetic_energy(mechanics).into(),
        Quantity::PotentialEnergy => potential_energy(mechanics).into(),
        Quantity::ShakingForce => shaking_force(mechanics).into(),
        Quantity::ShakingMoment(about) => {
            let about = match about {
                Some(about) => geometry::vector_of(mechanics.algebra, about),
                None => mechanics.zero_vector(),
            };
            turn_value(shaking_moment(mechanics, about))
        }
    }
}

/// The force and moment that a joint transmits to its body, without the part of a drive in its
/// motion.
fn reaction<'m>(mechanics: &mut Mechanics<'_, 'm>, joint: usize) -> Wrench<'m> {
    if mechanics.forces.bodies.tree.closing.contains(&joint) {
        return equilibrium::closing_wrench(mechanics, joint, &[]);
    }
    let declared = &mechanics.algebra.mechanism.joints[joint];
    let (body, kind) = (declared.body, declared.kind);
    let mut reaction = -equilibrium::wrench(mechanics, body, &[], &[]);
    let Some(direction) = mechanics.forces.bodies.geometry.directions[joint] else {
        return reaction;
    };
    // Where nothing drives it, equilibrium leaves nothing along the guide or about the axis.
    if kind.slides() && is_driven(mechanics, body, true) {
        reaction.force = reaction.force.across(direction);
    }
    if kind.rotation() == Rotation::AboutAxis && is_driven(mechanics, body, false) {
        reaction.moment = reaction.moment.across(direction);
    }
    reaction
}

fn is_driven(mechanics: &mut Mechanics<'_, '_>, body: usize, slides: bool) -> bool {
    let system = assemble::system(mechanics);
    let mut driven = system.driven.iter();
    driven.any(|way| way.body == body && way.slides == slides)
}

/// The torque or force of a drive.
fn drive<'m>(mechanics: &mut Mechanics<'_, 'm>, input: usize) -> Ex<'m> {
    if mechanics.question.with_reactions {
        drive_of_joints(mechanics, input)
    } else {
        drive_of_loads(mechanics, input)
    }
}

/// The force or torque that holds the driven joints against everything beyond them. It costs little
/// if reactions are computed anyway.
fn drive_of_joints<'m>(mechanics: &mut Mechanics<'_, 'm>, input: usize) -> Ex<'m> {
    let system = assemble::system(mechanics);
    let mut sum = mechanics.algebra.zero();
    for way in &system.driven {
        let rate = freedom::relative_rate(mechanics, way, By::Input(input));
        if !rate.is_zero() {
            sum -= rate * equilibrium::wrench(mechanics, way.body, &[], &[]).along(way);
        }
    }
    // Gears that run on a driven shaft load it.
    for (index, unknown) in system.unknowns.iter().enumerate() {
        let Unknown::Tie(tie) = unknown else { continue };
        let rate = freedom::tie_rate(mechanics, tie, input);
        if !rate.is_zero() {
            sum += rate * equilibrium::solved(mechanics, index);
        }
    }
    sum
}

/// The work of the loads per motion of the input, with the opposite sign:
/// `-(sum F . p' + sum M . w)`.
fn drive_of_loads<'m>(mechanics: &mut Mechanics<'_, 'm>, input: usize) -> Ex<'m> {
    let input = By::Input(input);
    let loads = loads::loads(mechanics);
    let mut work = mechanics.algebra.zero();
    for (body, body_loads) in loads.bodies.iter().enumerate() {
        for load in &body_loads.forces {
            let moved = match load.mass {
                Some(_) => motion::moved(mechanics, load.point, input),
                None => motion::velocity_of(mechanics, Some(body), load.point, input),
            };
            work += load.force.dot(moved);
        }
        for couple in &body_loads.couples {
            work += couple.dot(motion::turn(mechanics, Some(body), input));
        }
    }
    -work
}

/// `sum Q w`
fn power<'m>(mechanics: &mut Mechanics<'_, 'm>) -> Ex<'m> {
    let zero = mechanics.algebra.zero();
    (0..motion::drives(mechanics)).fold(zero, |sum, input| match motion::speed(mechanics, input) {
        None => sum,
        Some(speed) => sum + drive(mechanics, input) * speed,
    })
}

/// `1/2 (sum m v^2 + sum w . I w)`
fn kinetic_energy<'m>(mechanics: &mut Mechanics<'_, 'm>) -> Ex<'m> {
    let mut twice = mechanics.algebra.zero();
    for body in 0..mechanics.algebra.mechanism.bodies.len() {
        for (mass, point) in masses::masses(mechanics.algebra, body) {
            twice += mass * motion::point_velocity(mechanics, point).square();
        }
        twice += inertia::twice_turning_energy(mechanics, body);
    }
    0.5 * twice
}

/// The potential energy of weights, zero at the origin, and of springs, zero without force:
/// `1/2 sum c (l - l_0)^2 - sum m g . p`.
fn potential_energy<'m>(mechanics: &mut Mechanics<'_, 'm>) -> Ex<'m> {
    let mut sum = mechanics.algebra.zero();
    if let Some(gravity) = masses::gravity(mechanics.algebra) {
        for body in 0..mechanics.algebra.mechanism.bodies.len() {
            for (mass, point) in masses::masses(mechanics.algebra, body) {
                sum -= mass * gravity.dot(point);
            }
        }
    }
    for element in &mechanics.algebra.mechanism.elements {
        sum += match element.kind {
            ElementKind::Damper => mechanics.algebra.zero(),
            ElementKind::Spring => spring_energy(mechanics, element),
        };
    }
    sum
}

/// `1/2 c (l - l_0)^2`
fn spring_energy<'m>(mechanics: &mut Mechanics<'_, 'm>, spring: &Element) -> Ex<'m> {
    let length = match &spring.between {
        Between::Joint(joint) => loads::joint_coordinate(mechanics, *joint),
        Between::Points([from, to]) => {
            let [start, end] =
                [&from.1, &to.1].map(|at| geometry::vector_of(mechanics.algebra, at));
            (end - start).length()
        }
    };
    let free = match &spring.free {
        Some(free) => mechanics.algebra.translate_number(free),
        None => mechanics.algebra.zero(),
    };
    let stiffness = mechanics.algebra.translate_number(&spring.value);
    0.5 * (stiffness * (length - free).square())
}

/// `-sum m a`
fn shaking_force<'m>(mechanics: &mut Mechanics<'_, 'm>) -> Vn<'m> {
    let mut sum = mechanics.zero_vector();
    for body in 0..mechanics.algebra.mechanism.bodies.len() {
        for (mass, point) in masses::masses(mechanics.algebra, body) {
            sum = sum - mass * motion::point_acceleration(mechanics, point);
        }
    }
    sum
}

/// Minus the rate of the moment of momentum about a fixed point: `-sum (p - o) x m a`, and the
/// couples of the bodies' rotations.
fn shaking_moment<'m>(mechanics: &mut Mechanics<'_, 'm>, about: Vn<'m>) -> Vn<'m> {
    let mut sum = mechanics.zero_turn();
    for body in 0..mechanics.algebra.mechanism.bodies.len() {
        for (mass, point) in masses::masses(mechanics.algebra, body) {
            let force = mass * motion::point_acceleration(mechanics, point);
            sum = sum - (point - about).moment_of(force);
        }
        if let Some(couple) = inertia::inertia_couple(mechanics, body) {
            sum = sum - couple;
        }
    }
    sum
}

/// A scalar in the plane.
fn turn_value(turn: Vn) -> Value {
    match turn.in_space() {
        Some(_) => turn.into(),
        None => turn.at(0).into(),
    }
}
