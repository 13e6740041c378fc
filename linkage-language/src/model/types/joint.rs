//! The table of joints: the freedoms, the sign and the names of each kind.
//!
//! Checks, forces, pictures and messages read this table, so that a new kind of joint is described here once.

use linkage_core::JointShape;

use crate::syntax::JointKind;

/// The rotations of its body that a joint allows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rotation {
    Not,
    /// About the joint's axis; in the plane that is every rotation.
    AboutAxis,
    Freely,
}

/// A row of the table.
struct Properties {
    rotation: Rotation,
    /// Whether its bodies slide along each other.
    slides: bool,
    /// The sign where its bodies turn against each other; `None` if they do not.
    turning_sign: Option<JointShape>,
    /// The sign where a point slides along a guide.
    sliding_sign: JointShape,
    /// The direction of the joint, as messages name it.
    direction_name: &'static str,
}

const AXIS: &str = "the axis of a joint";

impl JointKind {
    fn properties(self) -> Properties {
        match self {
            JointKind::Pin => Properties {
                rotation: Rotation::AboutAxis,
                slides: false,
                turning_sign: Some(JointShape::Pin),
                sliding_sign: JointShape::Slide,
                direction_name: AXIS,
            },
            JointKind::Slide => Properties {
                rotation: Rotation::Not,
                slides: true,
                turning_sign: None,
                sliding_sign: JointShape::Slide,
                direction_name: "the guide of a `slide`",
            },
            JointKind::Roller => Properties {
                rotation: Rotation::AboutAxis,
                slides: true,
                turning_sign: Some(JointShape::Pin),
                sliding_sign: JointShape::Slide,
                direction_name: "the slot of a `roller`",
            },
            JointKind::Ball => Properties {
                rotation: Rotation::Freely,
                slides: false,
                turning_sign: Some(JointShape::Ball),
                sliding_sign: JointShape::Slide,
                direction_name: AXIS,
            },
            JointKind::Cylinder => Properties {
                rotation: Rotation::AboutAxis,
                slides: true,
                turning_sign: Some(JointShape::Cylindrical),
                sliding_sign: JointShape::Cylindrical,
                direction_name: AXIS,
            },
            JointKind::Fixed => Properties {
                rotation: Rotation::Not,
                slides: false,
                turning_sign: None,
                sliding_sign: JointShape::Slide,
                direction_name: AXIS,
            },
        }
    }

    /// The rotations of its body that the joint allows.
    pub fn rotation(self) -> Rotation {
        self.properties().rotation
    }

    /// True if its bodies turn against each other.
    pub fn turns(self) -> bool {
        self.rotation() != Rotation::Not
    }

    /// True if its bodies slide along each other.
    pub fn slides(self) -> bool {
        self.properties().slides
    }

    /// True if the joint transmits every force and no moment, in the plane or in space.
    pub fn transmits_no_moment(self, is_plane: bool) -> bool {
        self.turns_in_every_way(is_plane) && !self.slides()
    }

    /// True if the joint transmits no moment, whatever its forces, in the plane or in space.
    pub fn turns_in_every_way(self, is_plane: bool) -> bool {
        match self.rotation() {
            Rotation::Not => false,
            Rotation::AboutAxis => is_plane,
            Rotation::Freely => !is_plane,
        }
    }

    /// Returns the sign for bodies that turn against each other; `None` if they do not.
    pub fn turning_sign(self) -> Option<JointShape> {
        self.properties().turning_sign
    }

    /// Returns the sign for a point that slides along a guide.
    pub fn sliding_sign(self) -> JointShape {
        self.properties().sliding_sign
    }

    /// Returns the name of the joint's direction in messages.
    pub fn direction_name(self) -> &'static str {
        self.properties().direction_name
    }
}
