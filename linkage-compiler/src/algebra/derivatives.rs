//! What is known of derivatives already.

use std::rc::Rc;

use linkage_symbolic::lookup::Map;

use linkage_symbolic::{DerivativeMemo, Ex, NodeId, SymbolId, V3};

use super::adjoint::Adjoints;
use super::dependence::Dependence;
use super::gradient::Gradient;
use super::implicit::Rates;
use super::partial::Partials;
use super::solutions::Shortcuts;

/// Derivatives found already: total ones, those of the unknowns of groups, and what the sweeps backwards left.
#[derive(Clone, Debug, Default)]
pub(super) struct Derivatives<'m> {
    pub(super) memo: DerivativeMemo,
    /// By group and variables.
    pub(super) rates: Map<(usize, Vec<SymbolId>), Rates<'m>>,
    /// By group and variable: the turns of its bodies.
    pub(super) turns: Map<(usize, SymbolId), Vec<V3<'m>>>,
    /// By group and two variables: what the first one's turns change by with the second one.
    pub(super) second_turns: Map<(usize, [SymbolId; 2]), Vec<V3<'m>>>,
    /// How many times derivatives of unknowns are given others in place of their own: bodies do not turn then as they do.
    pub(super) held: usize,
    /// The symbols that stand for components of turns.
    pub(super) turns_as_symbols: Map<NodeId, Ex<'m>>,
    /// The shortcuts that could be made use of in one of them.
    pub(super) offered: Shortcuts,
    pub(super) partials: Partials,
    pub(super) adjoints: Adjoints<'m>,
    pub(super) gradients: Map<NodeId, Rc<Gradient<'m>>>,
    pub(super) dependence: Dependence,
}
