//! What acts on each body: inertia forces and weight, applied loads, springs and dampers.

use crate::algebra::scalar;
use crate::forces::geometry;
use crate::forces::inertia;
use crate::forces::motion;
use crate::forces::wrench;
use std::rc::Rc;

use linkage_symbolic::{Ex, Vector, Vn};

use crate::algebra::Translate;
use crate::model::{Between, Element, ElementKind, Expr};

use super::Mechanics;
use super::geometry::{Turning, slides_along};
use super::wrench::Wrench;

/// By body: forces at points, and couples.
#[derive(Clone, Debug)]
pub(super) struct Loads<'m> {
    pub(super) bodies: Vec<BodyLoads<'m>>,
}

#[derive(Clone, Debug, Default)]
pub(super) struct BodyLoads<'m> {
    pub(super) forces: Vec<PointForce<'m>>,
    pub(super) couples: Vec<Vn<'m>>,
}

#[derive(Clone, Debug)]
pub(super) struct PointForce<'m> {
    pub(super) point: Vn<'m>,
    pub(super) force: Vn<'m>,
    /// Of inertia and weight: the mass that has its centre there. Its expression moves with the body.
    pub(super) mass: Option<Ex<'m>>,
}

/// The loads at the speeds that are listed.
pub(super) fn loads<'m>(mechanics: &mut Mechanics<'_, 'm>) -> Rc<Loads<'m>> {
    mechanics.case().loads.clone()
}

/// The same, found anew.
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
    match is_force || !mechanics.forces.geometry.is_plane() {
        true => geometry::vector_of(mechanics.algebra, value),
        false => Vector([mechanics.algebra.translate_number(value)]).into(),
    }
}

/// `m (g - a)` at each mass of a body, and what its turning takes.
fn inertia_and_weight<'m>(mechanics: &mut Mechanics<'_, 'm>, body: usize) -> BodyLoads<'m> {
    let mut loads = BodyLoads::default();
    let gravity = gravity(mechanics);
    for (mass, point) in masses(mechanics, body) {
        let zero = mechanics.graph().zeros(point.len());
        let gravity = gravity.unwrap_or(zero);
        // A mass times the square of a speed is one factor for all components.
        let force = match motion::factors_of_gain(mechanics) <= point.len() {
            true => mass * gravity - motion::point_momentum_gain(mechanics, mass, point),
            false => mass * (gravity - motion::point_acceleration(mechanics, point)),
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

/// The field of gravity, if there is one.
pub(super) fn gravity<'m>(mechanics: &mut Mechanics<'_, 'm>) -> Option<Vn<'m>> {
    let gravity = mechanics.algebra.mechanism.gravity.as_ref()?;
    Some(geometry::vector_of(mechanics.algebra, gravity))
}

/// A body's masses and where they are.
pub(super) fn masses<'m>(mechanics: &mut Mechanics<'_, 'm>, body: usize) -> Vec<(Ex<'m>, Vn<'m>)> {
    let masses = mechanics.algebra.mechanism.bodies[body].masses.iter();
    masses
        .map(|(mass, at)| {
            let mass = mechanics.algebra.translate_number(mass);
            (mass, geometry::vector_of(mechanics.algebra, at))
        })
        .collect()
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
    let place = match (element.kind, &element.free) {
        (ElementKind::Damper, _) => joint_speed(mechanics, joint),
        (ElementKind::Spring, None) => joint_coordinate(mechanics, joint),
        (ElementKind::Spring, Some(free)) => {
            let place = joint_coordinate(mechanics, joint);
            place - mechanics.algebra.translate_number(free)
        }
    };
    let strength = -(rate * place);
    let mut wrench = wrench::zero_wrench(mechanics);
    match mechanics.forces.geometry.directions[joint] {
        Some(guide) if acts_along_guide(mechanics, joint) => wrench.force = strength * guide,
        Some(axis) => wrench.moment = strength * axis,
        None => wrench.moment = Vector([strength]).into(),
    }
    wrench
}

/// Whether what acts in a joint acts along its guide, and not on its angle.
fn acts_along_guide(mechanics: &Mechanics<'_, '_>, joint: usize) -> bool {
    slides_along(mechanics.algebra.mechanism.joints[joint].kind)
}

/// How far a joint has turned (its body against the one that it hangs on), or slid from that one's origin.
pub(super) fn joint_coordinate<'m>(mechanics: &Mechanics<'_, 'm>, joint: usize) -> Ex<'m> {
    let declared = &mechanics.algebra.mechanism.joints[joint];
    let (body, on) = (declared.body, declared.on);
    let geometry = &mechanics.forces.geometry;
    if let Some(guide) = geometry.directions[joint].filter(|_| acts_along_guide(mechanics, joint)) {
        let point = geometry.points[joint];
        return guide.dot(on.map_or(point, |on| mechanics.arm(on, point)));
    }
    if let Turning::About(angle, _) = &geometry.turning[body] {
        return scalar::value_of(mechanics.algebra, angle);
    }
    let [own, other] = [Some(body), on]
        .map(|body| geometry.angle(mechanics.algebra, &mechanics.forces.tree, body));
    scalar::value_of(mechanics.algebra, &own.combined(&other, -1.0))
}

/// How fast that grows.
fn joint_speed<'m>(mechanics: &mut Mechanics<'_, 'm>, joint: usize) -> Ex<'m> {
    let declared = &mechanics.algebra.mechanism.joints[joint];
    let (body, on) = (Some(declared.body), declared.on);
    let relative = if acts_along_guide(mechanics, joint) {
        let point = mechanics.forces.geometry.points[joint];
        motion::in_time(mechanics, point.len(), |mechanics, by| {
            motion::velocity_of(mechanics, body, point, by)
                - motion::velocity_of(mechanics, on, point, by)
        })
    } else {
        let count = mechanics.forces.geometry.turns();
        motion::in_time(mechanics, count, |mechanics, by| {
            motion::turn(mechanics, body, by) - motion::turn(mechanics, on, by)
        })
    };
    match mechanics.forces.geometry.directions[joint] {
        Some(way) => way.dot(relative),
        None => relative.at(0),
    }
}

impl<'m> Loads<'m> {
    /// A force at a point, or a couple.
    fn add(&mut self, body: Option<usize>, point: Option<Vn<'m>>, value: Vn<'m>) {
        let Some(body) = body else { return };
        let loads = &mut self.bodies[body];
        match point {
            None => loads.couples.push(value),
            Some(point) => loads.forces.push(PointForce {
                point,
                force: value,
                mass: None,
            }),
        }
    }
}
