//! Unknown frames in the plane and in space: the unknowns that they consist of.

use crate::model::types::{FRAME_PARTS, PLANE_PARTS, Type};
use crate::syntax::UnknownItem;

/// The axis that is the product of the others if it makes no difference which one is.
const USUALLY_DERIVED: usize = 1;

/// The kind of an unknown frame.
#[derive(Clone, Copy, PartialEq)]
pub(in crate::model) enum FrameKind {
    Plane,
    /// The axis that is the product of the others: 0, 1 or 2.
    Space {
        derived: usize,
    },
}

impl FrameKind {
    pub(in crate::model) fn of_item(item: &UnknownItem) -> Self {
        match item.frame_arguments() {
            Some(2) => FrameKind::Plane,
            _ => FrameKind::Space {
                derived: USUALLY_DERIVED,
            },
        }
    }

    /// Returns the number of unknowns that it consists of.
    pub(in crate::model) fn unknowns(self) -> usize {
        self.parts().len()
    }

    /// Its parts that are unknowns: the origin, and an angle or two axes.
    pub(in crate::model) fn parts(self) -> Vec<usize> {
        match self {
            FrameKind::Plane => vec![0, 3],
            FrameKind::Space { derived } => vec![0, 1 + (derived + 1) % 3, 1 + (derived + 2) % 3],
        }
    }

    pub(in crate::model) fn ty(self) -> Type {
        match self {
            FrameKind::Plane => Type::PlaneFrame,
            FrameKind::Space { .. } => Type::Frame,
        }
    }

    pub(in crate::model) fn names(self) -> [&'static str; 4] {
        match self {
            FrameKind::Plane => PLANE_PARTS,
            FrameKind::Space { .. } => FRAME_PARTS,
        }
    }
}
