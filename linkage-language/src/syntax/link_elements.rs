//! Links, slots and wheels when loops have taken their place, for pictures and descriptions of robots.

use proc_macro2::Ident;

use super::expression_tree::Expr;

/// The links, straight slots and pairs of wheels of a mechanism that is written with them.
#[derive(Debug, Default)]
pub struct LinkElements {
    pub links: Vec<RigidLink>,
    pub slots: Vec<StraightSlot>,
    pub pairs: Vec<PairOfWheels>,
}

/// A rigid link.
#[derive(Debug)]
pub struct RigidLink {
    pub name: Ident,
    /// At least two.
    pub joints: Vec<Expr>,
}

/// A straight slot with its slider.
#[derive(Debug)]
pub struct StraightSlot {
    /// The slider.
    pub name: Ident,
    /// The point in the slot.
    pub slider: Expr,
    /// A point of its line, on the link that has the slot.
    pub start: Expr,
    /// The direction of the slot in the drawing.
    pub angle: Expr,
}

/// Two wheels that turn each other.
#[derive(Debug)]
pub struct PairOfWheels {
    pub wheels: [PairedWheel; 2],
    /// The body that carries the pivots; `None` is the frame.
    pub carrier: Option<Ident>,
    /// The turns of the second wheel for one turn of the first, as seen from the carrier.
    pub ratio: Expr,
    /// True for gears, which touch; false for a belt.
    pub touch: bool,
}

/// A wheel.
#[derive(Debug)]
pub struct PairedWheel {
    /// The body that it is part of; `None` is the frame.
    pub body: Option<Ident>,
    /// The joint in which it turns on the carrier, if there is one.
    pub pivot: Option<Expr>,
    /// `None` for a wheel that is fixed.
    pub angle: Option<Expr>,
}
