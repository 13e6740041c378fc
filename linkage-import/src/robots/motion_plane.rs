//! The plane of a robot whose hinges are parallel.

use super::model::{ClosingJoint, Motion, Robot};
use crate::placement::{AXES, Vector, cross, dot, normals};

/// The sine of the angle between axes that count as parallel: the rounding of eight decimals.
const PARALLEL: f64 = 1e-7;

/// A plane: its two axes, and its normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Plane {
    pub(super) axes: [Vector; 2],
    pub(super) normal: Vector,
}

impl Plane {
    /// The plane of all motions, if there is one.
    pub(super) fn of_robot(robot: &Robot) -> Option<Self> {
        let joints = robot.bodies.iter().filter_map(|body| body.joint.as_ref());
        let motions: Vec<Motion> = joints.map(|joint| joint.motion).collect();
        let hinges = motions.iter().filter_map(|motion| match motion {
            Motion::Hinge(axis) => Some(*axis),
            Motion::Slide(_) | Motion::Ball | Motion::Free | Motion::Fixed => None,
        });
        let mut hinges = hinges.peekable();
        let normal = upwards(*hinges.peek()?);
        let is_parallel = |axis: Vector| {
            let across = cross(axis, normal);
            dot(across, across).sqrt() < PARALLEL
        };
        let is_in_plane = |axis: Vector| dot(axis, normal).abs() < PARALLEL;
        let of_joints = motions.iter().all(|motion| match motion {
            Motion::Hinge(axis) => is_parallel(*axis),
            Motion::Slide(axis) => is_in_plane(*axis),
            Motion::Ball | Motion::Free | Motion::Fixed => true,
        });
        let of_closures = robot.closures.iter().all(|closure| match closure.closing {
            ClosingJoint::Hinge(axis) => is_parallel(axis),
            ClosingJoint::Slide(axis) => is_in_plane(axis),
            ClosingJoint::Point | ClosingJoint::Weld => true,
        });
        (of_joints && of_closures).then(|| Self::across(normal))
    }

    /// The plane across a direction. Its axes are those of coordinates where possible.
    fn across(normal: Vector) -> Self {
        let nearest = (0..3).find(|k| 1.0 - normal[*k] < PARALLEL * PARALLEL);
        let axes = match nearest {
            Some(k) => [AXES[(k + 1) % 3], AXES[(k + 2) % 3]],
            None => normals(normal),
        };
        let normal = match nearest {
            Some(k) => AXES[k],
            None => normal,
        };
        Self { axes, normal }
    }

    /// The coordinates of a point or a direction in the plane.
    pub(super) fn coordinates(&self, point: Vector) -> [f64; 2] {
        self.axes.map(|axis| dot(axis, point))
    }

    /// True if an axis is that of positive angles.
    pub(super) fn is_positive(&self, axis: Vector) -> bool {
        dot(axis, self.normal) > 0.0
    }
}

/// The direction or its opposite, with a positive largest component.
fn upwards(axis: Vector) -> Vector {
    let size = axis.map(f64::abs);
    let largest = (0..3).max_by(|i, j| size[*i].total_cmp(&size[*j]));
    match axis[largest.unwrap_or_default()] < 0.0 {
        true => axis.map(|component| -component),
        false => axis,
    }
}
