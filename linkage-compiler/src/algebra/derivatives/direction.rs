//! Directions in which derivatives by parameters are found.

use linkage_symbolic::{Ex, SymbolId};

use crate::algebra::context::Algebra;
use crate::algebra::derivatives::by_rule::RuleCalculus;
use crate::algebra::derivatives::{adjoint, gradient, partial, preaccumulation};

/// The direction in which derivatives by parameters are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Direction {
    /// The rates of all groups by each parameter.
    #[default]
    Forward,
    /// Backwards from each number that is differentiated.
    FromResults,
    /// Backwards from the unknowns in it, with a new sweep from each intermediate before these:
    /// several results often hang on one angle.
    FromUnknowns,
    /// Backwards from each number through its whole formula.
    Gradient,
}

impl Direction {
    pub(crate) const ALL: [Self; 4] = [
        Self::Forward,
        Self::FromResults,
        Self::FromUnknowns,
        Self::Gradient,
    ];

    /// For the docs.
    pub(crate) fn doc_text(self) -> &'static str {
        match self {
            Self::Forward => "forward",
            Self::FromResults => "backwards from the results",
            Self::FromUnknowns => "backwards from the unknowns",
            Self::Gradient => "backwards through all formulas",
        }
    }
}

/// The derivative by an input, or by a parameter in any direction.
pub(crate) fn derivative<'m>(
    algebra: &mut Algebra<'m>,
    x: Ex<'m>,
    parameter: SymbolId,
    direction: Direction,
) -> Ex<'m> {
    match direction {
        Direction::Forward => algebra.slope(x, parameter),
        Direction::Gradient => gradient::gradient_by(algebra, x, parameter),
        Direction::FromResults => {
            let flow = adjoint::flow_to(algebra, x);
            let start = partial::partial(algebra, x, parameter);
            adjoint::minus_slopes(algebra, start, &flow, parameter)
        }
        Direction::FromUnknowns => preaccumulation::derivative_through(algebra, x, parameter),
    }
}
