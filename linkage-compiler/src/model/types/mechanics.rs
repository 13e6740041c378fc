//! Bodies, joints and loads.

use super::expression::Expr;
use crate::diagnostic::OriginId;
use crate::syntax::{JointKind, vocabulary};

/// A rigid member that moves, in declaration order; the frame has no number.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    pub(crate) name: String,
    /// The joint that it is attached by; the joint's point is the body's origin.
    pub(crate) joint: usize,
    /// An angle; in space a frame, the vector along a slender rod, or the angle about the joint's
    /// axis. `None`: it turns with the body that it is attached to.
    pub(crate) turns: Option<Expr>,
    /// Masses and where they are.
    pub(crate) masses: Vec<(Expr, Expr)>,
    /// Moments of inertia about the centre of mass, or about a point.
    pub(crate) inertias: Vec<(Inertia, Option<Expr>)>,
    pub(crate) origin: OriginId,
}

#[derive(Clone, Debug)]
pub(crate) enum Inertia {
    Scalar(Expr),
    /// In the axes of the body's frame: rows of a symmetric matrix.
    Tensor(Box<[[Expr; 3]; 3]>),
}

#[derive(Clone, Debug)]
pub(crate) struct Joint {
    /// `None` for a joint that nobody can ask for.
    pub(crate) name: Option<String>,
    pub(crate) kind: JointKind,
    pub(crate) body: usize,
    /// `None`: the frame.
    pub(crate) on: Option<usize>,
    pub(crate) at: Expr,
    /// The guide of a slide, the axis of a pin or a cylinder in space.
    pub(crate) direction: Option<Expr>,
    pub(crate) origin: OriginId,
}

impl JointKind {
    /// Returns true if its bodies turn relative to each other.
    pub(crate) fn turns(self) -> bool {
        match self {
            JointKind::Pin | JointKind::Ball | JointKind::Cylinder => true,
            JointKind::Slide | JointKind::Fixed => false,
        }
    }

    /// Returns true if its bodies slide along each other.
    pub(crate) fn slides(self) -> bool {
        match self {
            JointKind::Slide | JointKind::Cylinder => true,
            JointKind::Pin | JointKind::Ball | JointKind::Fixed => false,
        }
    }
}

/// A force at a point or a torque on a body, the opposite on another; `None` is the frame.
#[derive(Clone, Debug)]
pub(crate) struct Load {
    pub(crate) value: Expr,
    pub(crate) on: Option<usize>,
    pub(crate) from: Option<usize>,
    /// `None` for a torque.
    pub(crate) at: Option<Expr>,
}

/// A spring or a damper.
#[derive(Clone, Debug)]
pub(crate) struct Element {
    pub(crate) kind: ElementKind,
    pub(crate) value: Expr,
    pub(crate) between: Between,
    pub(crate) free: Option<Expr>,
    pub(crate) origin: OriginId,
}

vocabulary! {
    /// A passive element between two bodies.
    pub(crate) enum ElementKind {
        Spring = "spring",
        Damper = "damper",
    }
}

#[derive(Clone, Debug)]
pub(crate) enum Between {
    /// Bodies (`None` is the frame) and points on them.
    Points([(Option<usize>, Expr); 2]),
    Joint(usize),
}
