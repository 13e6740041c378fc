//! Springs and dampers: the forces and couples that they exert on bodies.

use linkage_symbolic::{Ex, Vector, Vn};

use crate::algebra::{Algebra, Translate, scalar};
use crate::forces::body_loads::Loads;
use crate::forces::geometry::{self, BodyTurn};
use crate::forces::motion;
use crate::forces::multibody::Multibody;
use crate::forces::speeds::{AngularVelocities, Speeds};
use crate::forces::wrench::Wrench;
use crate::model::{Between, Element, ElementKind, Mechanism};

/// A spring or damper on both of its bodies; a damper needs speeds.
pub(super) fn add_element<'m>(
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
pub(super) fn joint_speed<'m>(
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
