//! The quantities that functions ask for.

use linkage_symbolic::{Ex, Vn};

use crate::algebra::{Algebra, Translate, Value};
use crate::forces::context::{Forces, Question};
use crate::forces::geometry::Geometry;
use crate::forces::multibody::Multibody;
use crate::forces::speeds::{AngularVelocities, Speeds};
use crate::forces::{
    driving, dynamics, friction, geometry, inertia, losses, masses, motion, reactions, springs,
};
use crate::model::{Between, Element, ElementKind, MechanicalQuantity as Quantity};

/// The value of a quantity in a function.
pub(crate) fn quantity<'m>(
    algebra: &mut Algebra<'m>,
    forces: &mut Forces<'m>,
    question: &Question,
    quantity: &Quantity,
) -> Value<'m> {
    let Forces { bodies, memo } = forces;
    let bodies = &*bodies;
    let Question {
        speeds,
        with_reactions,
    } = question;
    match quantity {
        Quantity::Reaction(joint) => {
            let loading = friction::loading(algebra, bodies, memo, speeds);
            let reaction = reactions::reaction(algebra, bodies, memo, &loading, *joint);
            reaction.force.into()
        }
        Quantity::Moment(joint) => {
            let loading = friction::loading(algebra, bodies, memo, speeds);
            turn_value(reactions::reaction(algebra, bodies, memo, &loading, *joint).moment)
        }
        Quantity::Drive(input) => {
            let loading = friction::loading(algebra, bodies, memo, speeds);
            driving::drive(algebra, bodies, memo, &loading, *with_reactions, *input).into()
        }
        Quantity::Power => {
            let loading = friction::loading(algebra, bodies, memo, speeds);
            driving::power(algebra, bodies, memo, &loading, *with_reactions).into()
        }
        Quantity::FrictionPower => losses::friction_power(algebra, bodies, memo, speeds).into(),
        Quantity::Efficiency => {
            losses::efficiency(algebra, bodies, memo, speeds, *with_reactions).into()
        }
        Quantity::KineticEnergy => kinetic_energy(algebra, bodies, &mut memo.turns, speeds).into(),
        Quantity::PotentialEnergy => potential_energy(algebra, bodies).into(),
        Quantity::ShakingForce => shaking_force(algebra, &bodies.geometry, speeds).into(),
        Quantity::ShakingMoment(about) => {
            let about = match about {
                Some(about) => geometry::vector_of(algebra, about),
                None => bodies.geometry.zero_vector(algebra.graph),
            };
            turn_value(shaking_moment(
                algebra,
                bodies,
                &mut memo.turns,
                speeds,
                about,
            ))
        }
        Quantity::Inertia(inputs) => dynamics::inertia(algebra, bodies, memo, *inputs).into(),
        Quantity::MassMatrix(inputs) => {
            let mut row = |&a: &usize| {
                let entries = inputs.iter();
                let entries = entries.map(|&b| dynamics::inertia(algebra, bodies, memo, [a, b]));
                Value::Array(entries.map(Value::from).collect())
            };
            Value::Array(inputs.iter().map(&mut row).collect())
        }
        Quantity::Bias(input) => dynamics::bias(algebra, bodies, memo, speeds, *input).into(),
        Quantity::GeneralisedForce(input) => {
            dynamics::generalised_force(algebra, bodies, memo, speeds, *input).into()
        }
        Quantity::DrivenAcceleration(input) => {
            dynamics::driven_acceleration(algebra, bodies, memo, speeds, *input).into()
        }
    }
}

/// `1/2 (sum m v^2 + sum w . I w)`
fn kinetic_energy<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    speeds: &Speeds,
) -> Ex<'m> {
    let mut twice = algebra.zero();
    for body in 0..algebra.mechanism.bodies.len() {
        for (mass, point) in masses::masses(algebra, body) {
            twice += mass * motion::point_velocity(algebra, speeds, point).square();
        }
        twice += inertia::twice_turning_energy(algebra, bodies, turns, speeds, body);
    }
    0.5 * twice
}

/// The potential energy of weights, zero at the origin, and of springs, zero without force:
/// `1/2 sum c (l - l_0)^2 - sum m g . p`.
fn potential_energy<'m>(algebra: &mut Algebra<'m>, bodies: &Multibody<'m>) -> Ex<'m> {
    let mut sum = algebra.zero();
    if let Some(gravity) = masses::gravity(algebra) {
        for body in 0..algebra.mechanism.bodies.len() {
            for (mass, point) in masses::masses(algebra, body) {
                sum -= mass * gravity.dot(point);
            }
        }
    }
    for element in &algebra.mechanism.elements {
        sum += match element.kind {
            ElementKind::Damper => algebra.zero(),
            ElementKind::Spring => spring_energy(algebra, bodies, element),
        };
    }
    sum
}

/// `1/2 c (l - l_0)^2`
fn spring_energy<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    spring: &Element,
) -> Ex<'m> {
    let length = match &spring.between {
        Between::Joint(joint) => springs::joint_coordinate(algebra, bodies, *joint),
        Between::Points([from, to]) => {
            let [start, end] = [&from.1, &to.1].map(|at| geometry::vector_of(algebra, at));
            (end - start).length()
        }
    };
    let free = match &spring.free {
        Some(free) => algebra.translate_number(free),
        None => algebra.zero(),
    };
    let stiffness = algebra.translate_number(&spring.value);
    0.5 * (stiffness * (length - free).square())
}

/// `-sum m a`
fn shaking_force<'m>(
    algebra: &mut Algebra<'m>,
    geometry: &Geometry<'m>,
    speeds: &Speeds,
) -> Vn<'m> {
    let mut sum = geometry.zero_vector(algebra.graph);
    for body in 0..algebra.mechanism.bodies.len() {
        for (mass, point) in masses::masses(algebra, body) {
            sum = sum - mass * motion::point_acceleration(algebra, speeds, point);
        }
    }
    sum
}

/// Minus the rate of the moment of momentum about a fixed point: `-sum (p - o) x m a`, and the
/// couples of the bodies' rotations.
fn shaking_moment<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    speeds: &Speeds,
    about: Vn<'m>,
) -> Vn<'m> {
    let mut sum = bodies.geometry.zero_turn(algebra.graph);
    for body in 0..algebra.mechanism.bodies.len() {
        for (mass, point) in masses::masses(algebra, body) {
            let force = mass * motion::point_acceleration(algebra, speeds, point);
            sum = sum - (point - about).moment_of(force);
        }
        if let Some(couple) = inertia::inertia_couple(algebra, bodies, turns, speeds, body) {
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
