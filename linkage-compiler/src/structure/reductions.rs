//! Results of the reductions: unknowns that are expressions of others, and those that must stay.

use linkage_symbolic::lookup::Map;
use linkage_symbolic::{Ex, SymbolId};

use crate::structure::group::Explicit;

/// Eliminated symbols and the expressions that replace them.
pub(crate) type Substitutions<'m> = Map<SymbolId, Ex<'m>>;

/// Results of all reductions so far.
#[derive(Debug, Default)]
pub(crate) struct Reductions<'m> {
    /// The eliminated symbols in the order of their elimination.
    pub(crate) explicit: Vec<Explicit<'m>>,
    /// The same by symbol.
    pub(crate) substitutions: Substitutions<'m>,
    /// Components of axes that stay unknowns, all six of a body: systems are solved in its turns.
    pub(crate) kept_axes: Vec<SymbolId>,
}

impl Reductions<'_> {
    /// Takes the last reductions back.
    pub(crate) fn truncate(&mut self, explicit: usize, kept_axes: usize) {
        for undone in self.explicit.drain(explicit..) {
            self.substitutions.remove(&undone.symbol);
        }
        self.kept_axes.truncate(kept_axes);
    }
}
