//! Bodies and joints with numbers, and the positions of bodies.

use linkage_language::syntax::JointKind;

use super::mass::Mass;
use super::space_vectors::{IDENTITY, Rotation, Vector, ZERO};

/// The relative motion that a joint allows, with its unit vector at the reference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Freedom {
    Slide(Vector),
    Hinge(Vector),
    /// Every rotation.
    Ball,
}

/// A moving body. Its joint's freedoms act one after the other, from the parent outwards.
#[derive(Clone, Debug)]
pub(super) struct Link {
    pub(super) name: String,
    pub(super) joint: String,
    pub(super) parent: Option<usize>,
    pub(super) freedoms: Vec<Freedom>,
    /// The origin at the reference.
    pub(super) origin: Vector,
    pub(super) mass: Mass,
}

/// A joint that closes a loop, at the reference.
#[derive(Clone, Debug)]
pub(super) struct Closure {
    pub(super) name: String,
    pub(super) kind: JointKind,
    pub(super) bodies: [Option<usize>; 2],
    pub(super) at: Vector,
    pub(super) along: Option<Vector>,
}

/// Position and rotation of a body, the latter from the reference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pose {
    pub(super) origin: Vector,
    pub(super) rotation: Rotation,
    /// The angle of a body of the plane, which counts turns.
    pub(super) angle: Option<f64>,
}

/// The pose of the frame.
pub(super) const FIXED: Pose = Pose {
    origin: ZERO,
    rotation: IDENTITY,
    angle: Some(0.0),
};

/// The pose of a body, or that of the frame.
pub(super) fn pose_of(poses: &[Pose], body: Option<usize>) -> Pose {
    body.map_or(FIXED, |index| poses[index])
}
