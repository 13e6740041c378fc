//! Bodies, joints and loads.

use super::expression::Expr;
use crate::diagnostic::OriginId;
use crate::syntax::{JointKind, vocabulary};

/// A rigid member that moves, in declaration order; the frame has no number.
#[derive(Clone, Debug)]
pub struct Body {
    pub name: String,
    /// The joint that it is attached by; the joint's point is the body's origin.
    pub joint: usize,
    /// An angle; in space a frame, the vector along a slender rod, or the angle about the joint's
    /// axis. `None`: it turns with the body that it is attached to.
    pub turns: Option<Expr>,
    /// Masses and where they are.
    pub masses: Vec<(Expr, Expr)>,
    /// Moments of inertia about the centre of mass, or about a point.
    pub inertias: Vec<(Inertia, Option<Expr>)>,
    pub origin: OriginId,
}

#[derive(Clone, Debug)]
pub enum Inertia {
    Scalar(Expr),
    /// In the axes of the body's frame: rows of a symmetric matrix.
    Tensor(Box<[[Expr; 3]; 3]>),
}

#[derive(Clone, Debug)]
pub struct Joint {
    /// `None` for a joint that nobody can ask for.
    pub name: Option<String>,
    pub kind: JointKind,
    pub body: usize,
    /// `None`: the frame.
    pub on: Option<usize>,
    pub at: Expr,
    /// The guide of a slide, the axis of a pin or a cylinder in space.
    pub direction: Option<Expr>,
    pub origin: OriginId,
}

/// A force at a point or a torque on a body, the opposite on another; `None` is the frame.
#[derive(Clone, Debug)]
pub struct Load {
    pub value: Expr,
    pub on: Option<usize>,
    pub from: Option<usize>,
    /// `None` for a torque.
    pub at: Option<Expr>,
}

/// Dry friction in a pin or a slide of the plane.
#[derive(Clone, Debug)]
pub struct Friction {
    pub coefficient: Expr,
    pub joint: usize,
    pub contact: Contact,
    pub origin: OriginId,
}

/// The surfaces that touch in a joint with friction.
#[derive(Clone, Debug)]
pub enum Contact {
    /// The surface of a pin, with its radius.
    Pin(Expr),
    /// The guide of a slide, with the length of the block if its moment counts.
    Guide(Option<Expr>),
}

/// A spring or a damper.
#[derive(Clone, Debug)]
pub struct Element {
    pub kind: ElementKind,
    pub value: Expr,
    pub between: Between,
    pub free: Option<Expr>,
    pub origin: OriginId,
}

vocabulary! {
    /// A passive element between two bodies.
    pub enum ElementKind {
        /// A force or torque that grows with a length or angle.
        Spring = "spring",
        /// A force or torque that grows with a speed.
        Damper = "damper",
    }
}

#[derive(Clone, Debug)]
pub enum Between {
    /// Bodies (`None` is the frame) and points on them.
    Points([(Option<usize>, Expr); 2]),
    Joint(usize),
}
