//! Equations of solved groups, in the form that their derivatives need.

use linkage_symbolic::{Ex, NodeId, SymbolId, V2, V3};

use crate::algebra::bodies::Scheme;
use crate::algebra::rules::RotatingFrame;

/// A vector that turns with an unknown: its derivative by that is the unknown's column of the
/// Jacobian.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Link<'m> {
    /// `z u`
    pub(crate) vector: V2<'m>,
    pub(crate) z: V2<'m>,
    pub(crate) unit: V2<'m>,
    /// The square of its length.
    pub(crate) square: Ex<'m>,
    /// `vector x column` of the other unknown.
    pub(crate) across: Ex<'m>,
}

impl<'m> Link<'m> {
    /// Its derivative where its unknown is held.
    pub(crate) fn stretched(&self, slope: V2<'m>) -> V2<'m> {
        slope.turned(self.unit)
    }
}

/// A rod in space between a known point and one that the unknown of its group moves: the equation
/// says that its length is given.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rod<'m> {
    /// `known` and a vector that the unknown moves.
    pub(crate) vector: V3<'m>,
    pub(crate) known: V3<'m>,
    pub(crate) length: Ex<'m>,
    /// The derivative of its end by the unknown, and the vectors that this is made of.
    pub(crate) slope: V3<'m>,
    pub(crate) arms: [V3<'m>; 2],
    /// The scalar product of the rod and the vector that the unknown turns, 0 for one that it only
    /// moves.
    pub(crate) across: Ex<'m>,
}

/// An equation as it was written.
#[derive(Clone, Debug)]
pub(crate) struct WrittenRow<'m> {
    pub(crate) row: Ex<'m>,
    /// The links, if the row is about the length of a link, or about the difference of two squares.
    pub(crate) links: Option<Links<'m>>,
}

/// Half of the error of the first square of a distance, less the same of another one, over the
/// first length.
#[derive(Clone, Debug)]
pub(crate) struct Links<'m> {
    pub(crate) first: Distance<'m>,
    pub(crate) less: Option<Distance<'m>>,
}

/// A vector and the length that it should have.
#[derive(Clone, Debug)]
pub(crate) struct Distance<'m> {
    pub(crate) vector: V3<'m>,
    pub(crate) length: Ex<'m>,
    pub(crate) carried: Option<ArmOnBody<'m>>,
}

/// The part of a vector that a body carries.
#[derive(Clone, Debug)]
pub(crate) struct ArmOnBody<'m> {
    pub(crate) body: usize,
    pub(crate) arm: V3<'m>,
    pub(crate) rest: V3<'m>,
    /// The dimensions that the coordinates of the arm are made of.
    pub(crate) dimensions: Vec<SymbolId>,
}

/// One term of a group's equations.
#[derive(Clone, Debug)]
pub(crate) struct Term<'m> {
    /// One for each equation.
    pub(crate) coefficient: Vec<Ex<'m>>,
    pub(crate) factor: Ex<'m>,
}

/// The equations of a solved group, as its derivatives need them.
#[derive(Clone, Debug)]
pub(crate) struct Solution<'m> {
    pub(crate) terms: Vec<Term<'m>>,
    /// The equations as they were written, for groups whose derivatives are found from these; no
    /// rows for others.
    pub(crate) rows: Vec<WrittenRow<'m>>,
    /// Columns: the derivatives of the equations by each unknown.
    pub(crate) jacobian: Vec<Vec<Ex<'m>>>,
    pub(crate) determinant: Ex<'m>,
    /// For a coupled group; closed forms have one or two equations.
    pub(crate) elimination: Option<Elimination<'m>>,
    /// The links that turn with the first and the second of two unknowns. Their terms stand first.
    pub(crate) links: [Option<Link<'m>>; 2],
    /// For an equation that says how long a rod is.
    pub(crate) rod: Option<Rod<'m>>,
}

/// The steps that bring a group's Jacobian down to its core.
#[derive(Clone, Debug)]
pub(crate) struct Elimination<'m> {
    /// One for each equation of the core.
    pub(crate) rows: Vec<CoreRow<'m>>,
    /// Scaled, by row and unknown.
    pub(crate) matrix: Vec<Vec<Ex<'m>>>,
    /// An unknown is its scaled value times this: 1 for an angle, a length for a slide.
    pub(crate) units: Vec<Ex<'m>>,
    /// In the order of the columns after those of the core.
    pub(crate) privates: Vec<PrivateColumn<'m>>,
    /// The way to solve the matrix, if it is too large for cofactors.
    pub(crate) scheme: Option<Scheme<'m>>,
}

/// An equation of the core: a combination of the rows of one loop.
#[derive(Clone, Debug)]
pub(crate) struct CoreRow<'m> {
    /// The loop's first row.
    pub(crate) first: usize,
    /// One factor for each of its rows, or for one of them.
    pub(crate) factors: Vec<Ex<'m>>,
}

/// The column of a private unknown: two rows.
#[derive(Clone, Debug)]
pub(crate) struct PrivateColumn<'m> {
    pub(crate) first: usize,
    /// The square of its length.
    pub(crate) square: Ex<'m>,
}

/// A loop `z u + slide * guide + known = 0`, the guide on a link that turns.
#[derive(Clone, Debug)]
pub(crate) struct ViaSlider<'m> {
    /// The angle of `u`, and whether it turns against that.
    pub(crate) angle: usize,
    pub(crate) sense: f64,
    pub(crate) z: V2<'m>,
    /// The slide times the guide's length.
    pub(crate) slide: Ex<'m>,
    pub(crate) known: V2<'m>,
    pub(crate) link_frame: RotatingFrame<'m>,
    pub(crate) carried: AngleSum,
}

/// The angles that a vector turns with.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct AngleSum {
    pub(crate) angles: Vec<AnglePair>,
    /// A bit for each that it turns against.
    pub(crate) backward: usize,
}

/// An angle by the nodes of its cosine and sine.
pub(crate) type AnglePair = (NodeId, NodeId);
