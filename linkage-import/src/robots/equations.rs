//! The equations of a robot's loops, and their derivatives with respect to the joints.

use super::chain::{Chain, Pose};
use super::model::{ClosingJoint, Closure};
use super::rod_bodies::Rod;
use crate::placement::{AXES, Vector, cross, difference, dot, length, normals, sum, unit};

/// An equation: its error, and the changes by all coordinates.
#[derive(Clone, Debug)]
pub(super) struct Equation {
    /// The closure that it belongs to.
    pub(super) closure: usize,
    pub(super) error: f64,
    pub(super) changes: Vec<f64>,
}

impl Chain<'_> {
    /// All equations at a position, lengths as parts of the size.
    pub(super) fn rows(&self, pose: &Pose) -> Vec<Equation> {
        let mut rows = Vec::new();
        for (number, closure) in self.robot.closures.iter().enumerate() {
            match self.rods.iter().find(|rod| rod.closure == number) {
                Some(rod) => rows.push(self.rod_row(pose, rod)),
                None => self.closure_rows(pose, number, closure, &mut rows),
            }
        }
        rows
    }

    fn rod_row(&self, pose: &Pose, rod: &Rod) -> Equation {
        let [a, b] = rod.ends;
        let [at_a, at_b] = [a, b].map(|(body, at)| pose.bodies[body].point(at));
        let apart = difference(at_a, at_b);
        let along = unit(apart).unwrap_or(AXES[0]);
        let changes = self.coordinates.iter().map(|coordinate| {
            let part = |body, at| {
                let velocity = self.velocity(pose, coordinate, body, at);
                velocity.map_or(0.0, |[velocity, _]| dot(velocity, along))
            };
            (part(a.0, at_a) - part(b.0, at_b)) / self.size
        });
        Equation {
            closure: rod.closure,
            error: (length(apart) - rod.length) / self.size,
            changes: self.combined(pose, changes.collect()),
        }
    }

    /// Adds the changes of joints that follow others to those of their leaders.
    fn combined(&self, pose: &Pose, mut changes: Vec<f64>) -> Vec<f64> {
        for (index, coordinate) in self.coordinates.iter().enumerate() {
            if self.is_independent(coordinate) {
                continue;
            }
            let (leader, slope) = self.led_by(pose, coordinate.body);
            let change = std::mem::take(&mut changes[index]);
            let led_by = self.coordinates.iter().position(|c| c.body == leader);
            if let Some(leader) = led_by {
                changes[leader] += slope * change;
            }
        }
        changes
    }

    fn closure_rows(
        &self,
        pose: &Pose,
        number: usize,
        closure: &Closure,
        rows: &mut Vec<Equation>,
    ) {
        let [a, b] = closure.bodies;
        let at_a = pose.bodies[a].point(closure.at[0]);
        let at_b = pose.bodies[b].point(closure.at[1]);
        let apart = difference(at_a, at_b);
        let mut shift = |direction: Vector| {
            let changes = self.coordinates.iter().map(|coordinate| {
                let part = |body| {
                    let velocity = self.velocity(pose, coordinate, body, at_a);
                    velocity.map_or(0.0, |[velocity, _]| dot(velocity, direction))
                };
                (part(a) - part(b)) / self.size
            });
            rows.push(Equation {
                closure: number,
                error: dot(apart, direction) / self.size,
                changes: self.combined(pose, changes.collect()),
            });
        };
        match (closure.closing, self.plane) {
            (ClosingJoint::Slide(axis), Some(plane)) => {
                shift(pose.bodies[b].direction(cross(plane.normal, axis)));
            }
            (ClosingJoint::Slide(axis), None) => normals(axis)
                .into_iter()
                .for_each(|normal| shift(pose.bodies[b].direction(normal))),
            (_, Some(plane)) => plane.axes.into_iter().for_each(shift),
            (_, None) => {
                let carrier = &pose.bodies[self.common_carrier(closure)];
                AXES.into_iter()
                    .for_each(|axis| shift(carrier.direction(axis)));
            }
        }
        for (axis, error) in self.turns(pose, closure) {
            let changes = self.coordinates.iter().map(|coordinate| {
                let part = |body| {
                    let velocity = self.velocity(pose, coordinate, body, at_a);
                    velocity.map_or(0.0, |[_, turn]| dot(turn, axis))
                };
                part(a) - part(b)
            });
            rows.push(Equation {
                closure: number,
                error,
                changes: self.combined(pose, changes.collect()),
            });
        }
    }

    /// The directions about which a closure turns nothing, with its error about each.
    fn turns(&self, pose: &Pose, closure: &Closure) -> Vec<(Vector, f64)> {
        let [a, b] = closure.bodies.map(|body| pose.bodies[body]);
        let relative = a.then(&b.inverse());
        let error = |axis: Vector| {
            // Half of the antisymmetric part.
            let sum = AXES.iter().fold([0.0; 3], |total, near| {
                sum(total, cross(*near, relative.direction(*near)))
            });
            0.5 * dot(sum, axis)
        };
        match (closure.closing, self.plane) {
            (ClosingJoint::Point, _) | (ClosingJoint::Hinge(_), Some(_)) => Vec::new(),
            (ClosingJoint::Hinge(axis), None) => {
                let along = a.direction(axis);
                normals(axis)
                    .map(|normal| {
                        let normal = b.direction(normal);
                        (cross(along, normal), dot(along, normal))
                    })
                    .to_vec()
            }
            (ClosingJoint::Slide(_) | ClosingJoint::Weld, Some(plane)) => {
                vec![(plane.normal, error(plane.normal))]
            }
            (ClosingJoint::Slide(_) | ClosingJoint::Weld, None) => {
                AXES.map(|axis| (axis, error(axis))).to_vec()
            }
        }
    }
}
