//! The quantities that functions ask for.

use linkage_symbolic::{Ex, Vn};

use crate::algebra::{Algebra, Translate, Value};
use crate::forces::context::{Forces, Memo, Question};
use crate::forces::geometry::Geometry;
use crate::forces::multibody::Multibody;
use crate::forces::speeds::{AngularVelocities, By, Speeds};
use crate::forces::system::{System, Unknown};
use crate::forces::wrench::Wrench;
use crate::forces::{
    assemble, dynamics, equilibrium, freedom, geometry, inertia, loads, masses, motion, springs,
    virtual_work,
};
use crate::model::{Between, Element, ElementKind, MechanicalQuantity as Quantity, Rotation};

/// The value of a quantity in a function.
pub(crate) fn quantity<'m>(
    algebra: &mut Algebra<'m>,
    forces: &mut Forces<'m>,
    question: &Question,
    quantity: &Quantity,
) -> Value<'m> {
    let Forces { bodies, memo } = forces;
    let bodies = &*bodies;
    let speeds = &question.speeds;
    match quantity {
        Quantity::Reaction(joint) => reaction(algebra, bodies, memo, speeds, *joint).force.into(),
        Quantity::Moment(joint) => {
            turn_value(reaction(algebra, bodies, memo, speeds, *joint).moment)
        }
        Quantity::Drive(input) => drive(algebra, bodies, memo, question, *input).into(),
        Quantity::Power => power(algebra, bodies, memo, question).into(),
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

/// The force and moment that a joint transmits to its body, without the part of a drive in its
/// motion.
fn reaction<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    speeds: &Speeds,
    joint: usize,
) -> Wrench<'m> {
    if bodies.tree.closing.contains(&joint) {
        return equilibrium::closing_wrench(algebra, bodies, memo, speeds, joint, &[]);
    }
    let declared = &algebra.mechanism.joints[joint];
    let (body, kind) = (declared.body, declared.kind);
    let mut reaction = -equilibrium::wrench(algebra, bodies, memo, speeds, body, &[], &[]);
    let Some(direction) = bodies.geometry.directions[joint] else {
        return reaction;
    };
    let system = assemble::system(algebra, bodies, memo);
    // Where nothing drives it, equilibrium leaves nothing along the guide or about the axis.
    if kind.slides() && is_driven(&system, body, true) {
        reaction.force = reaction.force.across(direction);
    }
    // A roller of the plane has a direction, too, and no moment at all.
    let has_axis = kind.rotation() == Rotation::AboutAxis && !bodies.geometry.is_plane();
    if has_axis && is_driven(&system, body, false) {
        reaction.moment = reaction.moment.across(direction);
    }
    reaction
}

fn is_driven(system: &System, body: usize, slides: bool) -> bool {
    let mut driven = system.driven.iter();
    driven.any(|way| way.body == body && way.slides == slides)
}

/// The torque or force of a drive.
fn drive<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    question: &Question,
    input: usize,
) -> Ex<'m> {
    if question.with_reactions {
        drive_of_joints(algebra, bodies, memo, &question.speeds, input)
    } else {
        let loads = loads::loads(algebra, bodies, memo, &question.speeds);
        -virtual_work::work(algebra, bodies, &mut memo.turns, &loads, input)
    }
}

/// The force or torque that holds the driven joints against everything beyond them. It costs little
/// if reactions are computed anyway.
fn drive_of_joints<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    speeds: &Speeds,
    input: usize,
) -> Ex<'m> {
    let system = assemble::system(algebra, bodies, memo);
    let mut sum = algebra.zero();
    for way in &system.driven {
        let rate = freedom::relative_rate(algebra, bodies, &mut memo.turns, way, By::Input(input));
        if !rate.is_zero() {
            sum -= rate
                * equilibrium::wrench(algebra, bodies, memo, speeds, way.body, &[], &[]).along(way);
        }
    }
    // Gears that run on a driven shaft load it.
    for (index, unknown) in system.unknowns.iter().enumerate() {
        let Unknown::Tie(tie) = unknown else { continue };
        let rate = freedom::tie_rate(algebra, bodies, &mut memo.turns, tie, input);
        if !rate.is_zero() {
            sum += rate * equilibrium::solved(algebra, bodies, memo, speeds, index);
        }
    }
    sum
}

/// `sum Q w`
fn power<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    question: &Question,
) -> Ex<'m> {
    let zero = algebra.zero();
    (0..algebra.mechanism.inputs.len()).fold(zero, |sum, input| {
        match motion::speed(algebra, &question.speeds, input) {
            None => sum,
            Some(speed) => sum + drive(algebra, bodies, memo, question, input) * speed,
        }
    })
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
