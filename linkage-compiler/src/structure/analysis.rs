//! State of the structural analysis.

use linkage_symbolic::{Ex, SymbolId};

use crate::algebra::{Algebra, Nominal};
use crate::diagnostic::Reporter;
use crate::structure::group::Structure;

/// The state of the analysis.
pub(crate) struct Analysis<'a, 'm> {
    pub(crate) algebra: &'a mut Algebra<'m>,
    pub(crate) nominal: &'a Nominal,
    pub(crate) reporter: Reporter<'a>,
    pub(crate) structure: Structure<'m>,
    /// Eliminated symbols and the expressions that replace them.
    pub(crate) substitutions: linkage_symbolic::lookup::Map<SymbolId, Ex<'m>>,
    /// Components of axes that stay unknowns, all six of a body: systems are solved in its turns.
    pub(crate) kept_axes: Vec<SymbolId>,
    /// Reductions so far.
    pub(crate) steps: usize,
}
