//! The loads on each body: inertia forces and weight, applied loads, springs and dampers.

use std::rc::Rc;

use linkage_symbolic::lookup::Map;
use linkage_symbolic::{Ex, Vector, Vn};

use crate::algebra::{Algebra, Translate, scalar};
use crate::forces::body_loads::{BodyLoads, Loads, PointForce};
use crate::forces::context::{Case, Memo};
use crate::forces::geometry::{BodyTurn, Geometry};
use crate::forces::multibody::Multibody;
use crate::forces::speeds::{AngularVelocities, Speeds};
use crate::forces::wrench::Wrench;
use crate::forces::{geometry, inertia, masses, motion};
use crate::model::{Between, Element, ElementKind, Expr, Mechanism};

/// The forces at the speeds that are listed, the loads at least.
pub(super) fn case<'c, 'm>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &'c mut Memo<'m>,
    speeds: &Speeds,
) -> &'c mut Case<'m> {
    if !memo.cases.contains_key(speeds) {
        let case = Case {
            loads: Rc::new(all_loads(algebra, bodies, &mut memo.turns, speeds)),
            wrenches: Map::new(),
            solved: Map::new(),
        };
        memo.cases.insert(speeds.clone(), case);
    }
    let case = memo.cases.get_mut(speeds);
    case.expect("just made")
}

/// The loads at the speeds that are listed.
pub(super) fn loads<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    speeds: &Speeds,
) -> Rc<Loads<'m>> {
    case(algebra, bodies, memo, speeds).loads.clone()
}

/// Computes the loads at the speeds that are listed.
pub(super) fn all_loads<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    speeds: &Speeds,
) -> Loads<'m> {
    let mechanism = algebra.mechanism;
    let mut loads = Loads {
        bodies: (0..mechanism.bodies.len())
            .map(|body| inertia_and_weight(algebra, bodies, turns, speeds, body))
            .collect(),
    };
    for load in &mechanism.loads {
        let value = load_vector(algebra, &bodies.geometry, &load.value, load.at.is_some());
        let back = -value;
        let point = load.at.as_ref().map(|at| geometry::vector_of(algebra, at));
        loads.add(load.on, point, value);
        loads.add(load.from, point, back);
    }
    for element in &mechanism.elements {
        add_element(algebra, bodies, turns, speeds, &mut loads, element);
    }
    loads
}

/// A force as a vector; a torque as a turn.
fn load_vector<'m>(
    algebra: &mut Algebra<'m>,
    geometry: &Geometry<'m>,
    value: &Expr,
    is_force: bool,
) -> Vn<'m> {
    if is_force || !geometry.is_plane() {
        geometry::vector_of(algebra, value)
    } else {
        Vector([algebra.translate_number(value)]).into()
    }
}

/// Returns `m (g - a)` at each mass of a body, and the couple of its rotation.
fn inertia_and_weight<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    speeds: &Speeds,
    body: usize,
) -> BodyLoads<'m> {
    let mut loads = BodyLoads::default();
    let gravity = masses::gravity(algebra);
    for (mass, point) in masses::masses(algebra, body) {
        let zero = algebra.graph.zeros(point.len());
        let gravity = gravity.unwrap_or(zero);
        // A mass times the square of a speed is one factor for all components.
        let force = if motion::factors_of_gain(speeds) <= point.len() {
            mass * gravity - motion::point_momentum_gain(algebra, speeds, mass, point)
        } else {
            mass * (gravity - motion::point_acceleration(algebra, speeds, point))
        };
        if !force.is_zero() {
            loads.forces.push(PointForce {
                point,
                force,
                mass: Some(mass),
            });
        }
    }
    if motion::moves(speeds) {
        let couple = inertia::inertia_couple(algebra, bodies, turns, speeds, body);
        loads.couples.extend(couple.map(|couple| -couple));
    }
    loads
}

/// A spring or damper on both of its bodies; a damper needs speeds.
fn add_element<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    speeds: &Speeds,
    loads: &mut Loads<'m>,
    element: &Element,
) {
    match element.kind {
        ElementKind::Damper if !motion::moves(speeds) => return,
        ElementKind::Damper | ElementKind::Spring => {}
    }
    match &element.between {
        Between::Points([from, to]) => {
            let [start, end] = [&from.1, &to.1].map(|at| geometry::vector_of(algebra, at));
            let pull = pull(
                algebra,
                bodies,
                turns,
                speeds,
                element,
                [(from.0, start), (to.0, end)],
            );
            let back = -pull;
            loads.add(from.0, Some(start), pull);
            loads.add(to.0, Some(end), back);
        }
        Between::Joint(joint) => {
            let wrench = joint_element(algebra, bodies, turns, speeds, element, *joint);
            let joint = &algebra.mechanism.joints[*joint];
            let back = -wrench;
            let point = geometry::vector_of(algebra, &joint.at);
            for (body, wrench) in [(Some(joint.body), wrench), (joint.on, back)] {
                loads.add(body, Some(point), wrench.force);
                loads.add(body, None, wrench.moment);
            }
        }
    }
}

/// The force of a spring or damper on the point where it begins.
fn pull<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    speeds: &Speeds,
    element: &Element,
    ends: [(Option<usize>, Vn<'m>); 2],
) -> Vn<'m> {
    let rate = algebra.translate_number(&element.value);
    let between = ends[1].1 - ends[0].1;
    let factor = match (element.kind, &element.free) {
        (ElementKind::Damper, _) => {
            // rate (d . d') / d^2
            let [start, end] = ends.map(|(body, point)| {
                motion::in_time(algebra, speeds, between.len(), |algebra, by| {
                    motion::velocity_of(algebra, bodies, turns, body, point, by)
                })
            });
            let (along, square) = (between.dot(end - start), between.square());
            rate * along / square
        }
        (ElementKind::Spring, None) => rate,
        (ElementKind::Spring, Some(free)) => {
            // rate (1 - free / length)
            let free = algebra.translate_number(free);
            let length = between.length();
            rate * (length - free) / length
        }
    };
    factor * between
}

/// The force or couple of a spring or damper in a joint on the joint's body.
fn joint_element<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    speeds: &Speeds,
    element: &Element,
    joint: usize,
) -> Wrench<'m> {
    let rate = algebra.translate_number(&element.value);
    let coordinate = match (element.kind, &element.free) {
        (ElementKind::Damper, _) => joint_speed(algebra, bodies, turns, speeds, joint),
        (ElementKind::Spring, None) => joint_coordinate(algebra, bodies, joint),
        (ElementKind::Spring, Some(free)) => {
            let coordinate = joint_coordinate(algebra, bodies, joint);
            coordinate - algebra.translate_number(free)
        }
    };
    let strength = -(rate * coordinate);
    let mut wrench = Wrench::zero(algebra.graph, &bodies.geometry);
    match bodies.geometry.directions[joint] {
        Some(guide) if acts_along_guide(algebra.mechanism, joint) => {
            wrench.force = strength * guide
        }
        Some(axis) => wrench.moment = strength * axis,
        None => wrench.moment = Vector([strength]).into(),
    }
    wrench
}

/// True if an element in a joint acts along the guide, and not on the angle.
fn acts_along_guide(mechanism: &Mechanism, joint: usize) -> bool {
    mechanism.joints[joint].kind.slides()
}

/// The angle by which a joint has turned (its body relative to the parent), or the distance from
/// the parent's origin.
pub(super) fn joint_coordinate<'m>(
    algebra: &Algebra<'m>,
    bodies: &Multibody<'m>,
    joint: usize,
) -> Ex<'m> {
    let declared = &algebra.mechanism.joints[joint];
    let (body, on) = (declared.body, declared.on);
    let geometry = &bodies.geometry;
    if let Some(guide) =
        geometry.directions[joint].filter(|_| acts_along_guide(algebra.mechanism, joint))
    {
        let point = geometry.points[joint];
        return guide.dot(on.map_or(point, |on| bodies.arm(on, point)));
    }
    if let BodyTurn::About(angle, _) = &geometry.turning[body] {
        return scalar::value_of(&algebra.names, angle);
    }
    let [angle, other] = [Some(body), on].map(|body| geometry.angle(algebra, &bodies.tree, body));
    scalar::value_of(&algebra.names, &angle.combined(&other, -1.0))
}

/// The rate of that coordinate.
fn joint_speed<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    speeds: &Speeds,
    joint: usize,
) -> Ex<'m> {
    let declared = &algebra.mechanism.joints[joint];
    let (body, on) = (Some(declared.body), declared.on);
    let relative = if acts_along_guide(algebra.mechanism, joint) {
        let point = bodies.geometry.points[joint];
        motion::in_time(algebra, speeds, point.len(), |algebra, by| {
            motion::velocity_of(algebra, bodies, turns, body, point, by)
                - motion::velocity_of(algebra, bodies, turns, on, point, by)
        })
    } else {
        let count = bodies.geometry.turns();
        motion::in_time(algebra, speeds, count, |algebra, by| {
            motion::turn(algebra, bodies, turns, body, by)
                - motion::turn(algebra, bodies, turns, on, by)
        })
    };
    match bodies.geometry.directions[joint] {
        Some(way) => way.dot(relative),
        None => relative.at(0),
    }
}
