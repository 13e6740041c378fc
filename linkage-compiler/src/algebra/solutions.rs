//! Solved groups: the equations of each, and the rules by which symbols are differentiated.

use std::collections::BTreeSet;

use linkage_symbolic::SymbolId;
use linkage_symbolic::lookup::Map;

use crate::algebra::equations::{Solution, ViaSlider};
use crate::algebra::rules::DerivativeRule;
use crate::algebra::systems::Solved;

/// Shortcuts that derivatives may take: these change the number of operations and no value.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Shortcuts {
    /// Products that are known of links.
    pub(crate) products: bool,
    /// The turns of bodies: vectors on a body turn with it.
    pub(crate) turns: bool,
}

/// The groups that are solved, and the rules of their symbols.
#[derive(Clone, Debug, Default)]
pub(crate) struct Solutions<'m> {
    rules: Map<SymbolId, DerivativeRule<'m>>,
    /// The equations of each group.
    pub(crate) groups: Vec<Solution<'m>>,
    /// Loops with a guide on a link that turns, in order.
    pub(crate) via_sliders: Vec<ViaSlider<'m>>,
    /// The shortcuts that derivatives take.
    pub(crate) shortcuts: Shortcuts,
    /// The places between parameters and the results of a function that all paths of some groups
    /// lead through.
    pub(crate) intermediates: BTreeSet<Solved>,
}

impl<'m> Solutions<'m> {
    /// Says how a symbol is differentiated.
    pub(crate) fn set_rule(&mut self, symbol: SymbolId, rule: DerivativeRule<'m>) {
        self.rules.insert(symbol, rule);
    }

    /// Returns the rule by which a symbol is differentiated; `None` for inputs and parameters.
    pub(crate) fn rule(&self, symbol: SymbolId) -> Option<&DerivativeRule<'m>> {
        self.rules.get(&symbol)
    }
}
