//! Coupled groups: loops that are solved together, with private unknowns and a core.

use linkage_symbolic::{Ex, SymbolId, V2, V3};

use crate::structure::elements::{Rotor, SpaceLink};

/// The greatest number of core unknowns whose assemblies are listed, a work that grows without
/// bound: of more, one is followed from its estimates.
const MOST_LISTED: usize = 6;

/// A coupled group.
#[derive(Clone, Debug)]
pub(crate) struct Coupled<'m> {
    /// `RR-RR-PR`, or a general word.
    pub(crate) kind: String,
    pub(crate) class: u8,
    pub(crate) order: u8,
    pub(crate) blocks: Vec<Block<'m>>,
    pub(crate) core: Vec<Core>,
}

impl Coupled<'_> {
    /// True if its assemblies can be too many to be listed, and its matrix too large for cofactors.
    pub(crate) fn is_large(&self) -> bool {
        self.core.len() > MOST_LISTED
    }
}

/// One loop of a coupled group.
#[derive(Clone, Debug)]
pub(crate) struct Block<'m> {
    /// Each row is 0.
    pub(crate) rows: Vec<Ex<'m>>,
    /// The rows without the private unknown.
    pub(crate) rest: Vec<Ex<'m>>,
    pub(crate) private: Option<Private<'m>>,
    /// The rows as polynomials.
    pub(crate) terms: Vec<Product<'m>>,
    /// A link in space, if the row is about the square of its vector.
    pub(crate) distance: Option<SpaceLink<'m>>,
    /// The factors of a row in space that is their scalar product, or its negative, except for
    /// known terms.
    pub(crate) product: Option<[V3<'m>; 2]>,
    /// True if it is about numbers, as those of directions are.
    pub(crate) number: bool,
    /// True if the loop is written between lengths, which a scalar loop need not be.
    pub(crate) between_lengths: bool,
}

impl Block<'_> {
    /// True if its rows are lengths: the dimension of a scalar loop is unknown.
    pub(crate) fn is_length(&self) -> bool {
        !self.number && (self.rows.len() > 1 || self.distance.is_some())
    }
}

/// A product of unknowns with one coefficient for each row.
#[derive(Clone, Debug)]
pub(crate) struct Product<'m> {
    pub(crate) coefficient: Vec<Ex<'m>>,
    /// Symbols and their exponents, which are not 0.
    pub(crate) powers: Vec<(SymbolId, u8)>,
}

/// The unknown that a loop of two rows contains alone.
#[derive(Clone, Debug)]
pub(crate) enum Private<'m> {
    /// A link of fixed length.
    Rotor(Rotor<'m>),
    /// A slide; the guide may turn with unknowns of the core.
    Slide { slide: SymbolId, guide: V2<'m> },
}

/// An unknown of the core.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Core {
    Angle(usize),
    /// A slide or a component of a point.
    Length {
        symbol: SymbolId,
        /// True if it is a number and no length: a component of a direction.
        number: bool,
        /// 0 or 1 if both components of a point are in the core.
        component: Option<usize>,
    },
}
