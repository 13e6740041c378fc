//! Links, slots and wheels as pictures show them.

use super::expression::Expr;

/// The links, straight slots and pairs of wheels of a mechanism that is written with joints and links.
#[derive(Clone, Debug, Default)]
pub struct LinkElements {
    pub links: Vec<RigidLink>,
    pub slots: Vec<StraightSlot>,
    pub pairs: Vec<PairOfWheels>,
}

/// A rigid link.
#[derive(Clone, Debug)]
pub struct RigidLink {
    pub name: String,
    /// Points: at least two.
    pub joints: Vec<Expr>,
}

/// A straight slot in the plane.
#[derive(Clone, Debug)]
pub struct StraightSlot {
    pub name: String,
    /// The point in the slot.
    pub slider: Expr,
    /// A point of its line, on the link that has the slot.
    pub start: Expr,
    /// A unit vector along the slot, which turns with that link.
    pub direction: Expr,
}

/// Two wheels of the plane that turn each other.
#[derive(Clone, Debug)]
pub struct PairOfWheels {
    pub wheels: [PairedWheel; 2],
    /// True for gears, which touch; false for a belt.
    pub touch: bool,
}

/// A wheel that turns about a point.
#[derive(Clone, Debug)]
pub struct PairedWheel {
    pub centre: Expr,
    /// A unit vector that turns with it; `None` for a wheel that is fixed.
    pub direction: Option<Expr>,
}

impl LinkElements {
    /// Adds the links, slots and wheels of another mechanism.
    pub fn append(&mut self, other: Self) {
        self.links.extend(other.links);
        self.slots.extend(other.slots);
        self.pairs.extend(other.pairs);
    }
}
