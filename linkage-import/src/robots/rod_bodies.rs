//! Bodies between two balls, which are distances.

use super::model::{ClosingJoint, Motion, Robot};
use crate::placement::{Vector, difference, length};

/// A rod between two balls, which has no body: the distance of two points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rod {
    /// The body that is replaced.
    pub(super) body: usize,
    pub(super) closure: usize,
    /// The bodies that it joins, with the point on each.
    pub(super) ends: [(usize, Vector); 2],
    pub(super) length: f64,
}

/// Bodies that hang on a ball and are held by one other ball.
pub(super) fn rods(robot: &Robot) -> Vec<Rod> {
    let mut rods: Vec<Rod> = Vec::new();
    for (body, of_body) in robot.bodies.iter().enumerate() {
        let Some(joint) = of_body
            .joint
            .as_ref()
            .filter(|joint| joint.motion == Motion::Ball)
        else {
            continue;
        };
        let mut others = robot.bodies.iter().filter_map(|other| other.joint.as_ref());
        let carries = others.any(|other| other.parent == body);
        let closures = robot.closures.iter().enumerate();
        let mut on_body = closures.filter(|(_, closure)| closure.bodies.contains(&body));
        let (Some((number, closure)), None) = (on_body.next(), on_body.next()) else {
            continue;
        };
        let ends_on_rod = |other: usize| rods.iter().any(|rod| rod.body == other);
        let near = usize::from(closure.bodies[1] == body);
        let other = closure.bodies[1 - near];
        if carries || closure.closing != ClosingJoint::Point || ends_on_rod(other) || other == body
        {
            continue;
        }
        rods.push(Rod {
            body,
            closure: number,
            ends: [(joint.parent, joint.at), (other, closure.at[1 - near])],
            length: length(difference(closure.at[near], joint.at)),
        });
    }
    rods
}
