//! The loads on each body: inertia forces and weight, applied loads, springs and dampers.

use std::rc::Rc;

use linkage_symbolic::lookup::Map;
use linkage_symbolic::{Ex, Vector, Vn};

use crate::algebra::{Translate, scalar};
use crate::forces::body_loads::{BodyLoads, Loads, PointForce};
use crate::forces::context::{Case, Mechanics};
use crate::forces::geometry::BodyTurn;
use crate::forces::wrench::Wrench;
use crate::forces::{context, geometry, inertia, masses, motion};
use crate::model::{Between, Element, ElementKind, Expr};

/// The forces at the speeds that are listed, the loads at least.
pub(super) fn case<'c, 'm>(mechanics: &'c mut Mechanics<'_, 'm>) -> &'c mut Case<'m> {
    if !mechanics
        .forces
        .memo
        .cases
        .contains_key(&mechanics.question.speeds)
    {
        let case = Case {
            loads: Rc::new(all_loads(mechanics)),
            wrenches: Map::new(),
            solved: Map::new(),
        };
        mechanics
            .forces
            .memo
            .cases
            .insert(mechanics.question.speeds.clone(), case);
    }
    let case = mechanics
        .forces
        .memo
        .cases
        .get_mut(&mechanics.question.speeds);
    case.expect("just made")
}

/// The loads at the speeds that are listed.
pub(super) fn loads<'m>(mechanics: &mut Mechanics<'_, 'm>) -> Rc<Loads<'m>> {
    case(mechanics).loads.clone()
}

/// Computes the same again.
pub(super) fn all_loads<'m>(mechanics: &mut Mechanics<'_, 'm>) -> Loads<'m> {
    let mechanism = mechanics.algebra.mechanism;
    let bodies = mechanism.bodies.len();
    let mut loads = Loads {
        bodies: (0..bodies)
            .map(|body| inertia_and_weight(mechanics, body))
            .collect(),
    };
    for load in &mechanism.loads {
        let value = load_vector(mechanics, &load.value, load.at.is_some());
        let back = -value;
        let point = load
            .at
            .as_ref()
            .map(|at| geometry::vector_of(mechanics.algebra, at));
        loads.add(load.on, point, value);
        loads.add(load.from, point, back);
    }
    for element in &mechanism.elements {
        add_element(mechanics, &mut loads, element);
    }
    loads
}

/// A force as a vector; a torque as a turn.
fn load_vector<'m>(mechanics: &mut Mechanics<'_, 'm>, value: &Expr, is_force: bool) -> Vn<'m> {
    if is_force || !mechanics.forces.bodies.geometry.is_plane() {
        geometry::vector_of(mechanics.algebra, value)
    } else {
        Vector([mechanics.algebra.translate_number(value)]).into()
    }
}

/// Returns `m (g - a)` at each mass of a body, and the couple of its rotation.
fn inertia_and_weight<'m>(mechanics: &mut Mechanics<'_, 'm>, body: usize) -> BodyLoads<'m> {
    let mut loads = BodyLoads::default();
    let gravity = masses::gravity(mechanics.algebra);
    for (mass, point) in masses::masses(mechanics.algebra, body) {
        let zero = mechanics.graph().zeros(point.len());
        let gravity = gravity.unwrap_or(zero);
        // A mass times the square of a speed is one factor for all components.
        let force = if motion::factors_of_gain(mechanics) <= point.len() {
            mass * gravity - motion::point_momentum_gain(mechanics, mass, point)
        } else {
            mass * (gravity - motion::point_acceleration(mechanics, point))
        };
        if !force.is_zero() {
            loads.forces.push(PointForce {
                point,
                force,
                mass: Some(mass),
            });
        }
    }
    if motion::moves(mechanics) {
        let couple = inertia::inertia_couple(mechanics, body);
        loads.couples.extend(couple.map(|couple| -couple));
    }
    loads
}

/// A spring or damper on both of its bodies; a damper needs speeds.
fn add_element<'m>(mechanics: &mut Mechanics<'_, 'm>, loads: &mut Loads<'m>, element: &Element) {
    match element.kind {
        ElementKind::Damper if !motion::moves(mechanics) => return,
        ElementKind::Damper | ElementKind::Spring => {}
    }
    match &element.between {
        Between::Points([from, to]) => {
            let [start, end] =
                [&from.1, &to.1].map(|at| geometry::vector_of(mechanics.algebra, at));
            let pull = pull(mechanics, element, [(from.0, start), (to.0, end)]);
            let back = -pull;
            loads.add(from.0, Some(start), pull);
            loads.add(to.0, Some(end), back);
        }
        Between::Joint(joint) => {
            let wrench = joint_element(mechanics, element, *joint);
            let joint = &mechanics.algebra.mechanism.joints[*joint];
            let back = -wrench;
            let point = geometry::vector_of(mechanics.algebra, &joint.at);
            for (body, wrench) in [(Some(joint.body), wrench), (joint.on, back)] {
                loads.add(body, Some(point), wrench.force);
                loads.add(body, None, wrench.moment);
            }
        }
    }
}

/// The force of a spring or damper on the point where it begins.
fn pull<'m>(
    mechanics: &mut Mechanics<'_, 'm>,
    element: &Element,
    ends: [(Option<usize>, Vn<'m>); 2],
) -> Vn<'m> {
    let rate = mechanics.algebra.translate_number(&element.value);
    let between = ends[1].1 - ends[0].1;
    let factor = match (element.kind, &element.free) {
        (ElementKind::Damper, _) => {
            // rate (d . d') / d^2
            let [start, end] = ends.map(|(body, point)| {
                motion::in_time(mechanics, between.len(), |mechanics, by| {
                    motion::velocity_of(mechanics, body, point, by)
                })
            });
            let (along, square) = (between.dot(end - start), between.square());
            rate * along / square
        }
        (ElementKind::Spring, None) => rate,
        (ElementKind::Spring, Some(free)) => {
            // rate (1 - free / length)
            let free = mechanics.algebra.translate_number(free);
            let length = between.length();
            rate * (length - free) / length
        }
    };
    factor * between
}

/// The force or couple of a spring or damper in a joint on the joint's body.
fn joint_element<'m>(
    mechanics: &mut Mechanics<'_, 'm>,
    element: &Element,
    joint: usize,
) -> Wrench<'m> {
    let rate = mechanics.algebra.translate_number(&element.value);
    let coordinate = match (element.kind, &element.free) {
        (ElementKind::Damper, _) => joint_speed(mechanics, joint),
        (ElementKind::Spring, None) => joint_coordinate(mechanics, joint),
        (ElementKind::Spring, Some(free)) => {
            let coordinate = joint_coordinate(mechanics, joint);
            coordinate - mechanics.algebra.translate_number(free)
        }
    };
    let strength = -(rate * coordinate);
    let mut wrench = context::zero_wrench(mechanics);
    match mechanics.forces.bodies.geometry.directions[joint] {
        Some(guide) if acts_along_guide(mechanics, joint) => wrench.force = strength * guide,
        Some(axis) => wrench.moment = strength * axis,
        None => wrench.moment = Vector([strength]).into(),
    }
    wrench
}

/// True if an element in a joint acts along the guide, and not on the angle.
fn acts_along_guide(mechanics: &Mechanics<'_, '_>, joint: usize) -> bool {
    mechanics.algebra.mechanism.joints[joint].kind.slides()
}

/// The angle by which a joint has turned (its body relative to the parent), or the distance from
/// the parent's origin.
pub(super) fn joint_coordinate<'m>(mechanics: &Mechanics<'_, 'm>, joint: usize) -> Ex<'m> {
    let declared = &mechanics.algebra.mechanism.joints[joint];
    let (body, on) = (declared.body, declared.on);
    let geometry = &mechanics.forces.bodies.geometry;
    if let Some(guide) = geometry.directions[joint].filter(|_| acts_along_guide(mechanics, joint)) {
        let point = geometry.points[joint];
        return guide.dot(on.map_or(point, |on| mechanics.arm(on, point)));
    }
    if let BodyTurn::About(angle, _) = &geometry.turning[body] {
        return scalar::value_of(mechanics.algebra, angle);
    }
    let [angle, other] = [Some(body), on]
        .map(|body| geometry.angle(mechanics.algebra, &mechanics.forces.bodies.tree, body));
    scalar::value_of(mechanics.algebra, &angle.combined(&other, -1.0))
}

/// The rate of that coordinate.
fn joint_speed<'m>(mechanics: &mut Mechanics<'_, 'm>, joint: usize) -> Ex<'m> {
    let declared = &mechanics.algebra.mechanism.joints[joint];
    let (body, on) = (Some(declared.body), declared.on);
    let relative = if acts_along_guide(mechanics, joint) {
        let point = mechanics.forces.bodies.geometry.points[joint];
        motion::in_time(mechanics, point.len(), |mechanics, by| {
            motion::velocity_of(mechanics, body, point, by)
                - motion::velocity_of(mechanics, on, point, by)
        })
    } else {
        let count = mechanics.forces.bodies.geometry.turns();
        motion::in_time(mechanics, count, |mechanics, by| {
            motion::turn(mechanics, body, by) - motion::turn(mechanics, on, by)
        })
    };
    match mechanics.forces.bodies.geometry.directions[joint] {
        Some(way) => way.dot(relative),
        None => relative.at(0),
    }
}
