//! Mechanisms within a mechanism, and their locations.

use std::ops::Range;

use super::expression::{BinaryOp, Expr, ExprKind};
use super::function_words::Function;
use super::name::Name;

/// A mechanism within this one. Its items are among the items of the same kind, with names that
/// begin with its own.
#[derive(Clone, Debug)]
pub struct MechanismPart {
    pub name: String,
    /// The mechanism that it is, as it is called.
    pub mechanism: String,
    /// The derived quantities that its inputs are here.
    pub inputs: Vec<usize>,
    /// Its parameters here: parameters, or derived quantities for those that are given.
    pub parameters: Vec<Name>,
    /// Its unknowns.
    pub unknowns: Range<usize>,
    /// The parts within it, with the mechanisms that they are.
    pub inner: Vec<(String, String)>,
}

/// The location of a part in the mechanism around it.
#[derive(Clone, Debug)]
pub struct Placed {
    /// The part's name, those of the parts around it in front.
    pub path: String,
    /// The derived quantity that its origin is, or its frame in space.
    pub at: Option<Expr>,
    /// The derived quantity that is the angle of its x axis in the plane.
    pub turned: Option<Expr>,
    /// Its loops, those of parts within it among them.
    pub loops: Range<usize>,
}

/// A part without parts, or one within a part: the ranges of its own derived quantities, loops and
/// unknowns.
#[derive(Clone, Debug)]
pub struct Leaf {
    pub lets: Range<usize>,
    pub loops: Range<usize>,
    pub unknowns: Range<usize>,
}

impl Placed {
    /// Returns the point of the part that this expression is in the mechanism around it. The
    /// inverse of `PartFrame::seen_point`.
    pub fn point_behind<'e>(&self, seen: &'e Expr) -> Option<&'e Expr> {
        let turned_back = |turned: &'e Expr| match (&self.turned, &turned.kind) {
            (None, _) => Some(turned),
            (Some(angle), ExprKind::Call(Function::Rotate, arguments)) => {
                (arguments[1] == *angle).then(|| &arguments[0])
            }
            (Some(_), _) => None,
        };
        match (&self.at, &seen.kind) {
            (None, _) => self.turned.as_ref().and_then(|_| turned_back(seen)),
            (Some(at), ExprKind::Call(Function::PointIn, arguments)) => {
                (arguments[0] == *at).then(|| &arguments[1])
            }
            (Some(at), ExprKind::Binary(BinaryOp::Add, origin, turned)) if **origin == *at => {
                turned_back(turned)
            }
            (Some(_), _) => None,
        }
    }
}
