//! What is known of derivatives already.

use linkage_symbolic::unordered::Map;

use linkage_symbolic::{DerivativeMemo, Ex, NodeId, SymbolId, V3};

use super::adjoint::Adjoints;
use super::dependence::Dependence;
use super::implicit::Rates;
use super::partial::Partials;
use super::reverse::Gradient;

/// Derivatives found already: total ones, those of the unknowns of groups, and what the sweeps backwards left.
#[derive(Clone, Debug, Default)]
pub(super) struct Derivatives<'m> {
    pub(super) memo: DerivativeMemo,
    /// By group and variables.
    pub(super) rates: Map<(usize, Vec<SymbolId>), Rates<'m>>,
    /// By group and variable: the turns of its bodies.
    pub(super) turns: Map<(usize, SymbolId), Vec<V3<'m>>>,
    /// The symbols that stand for components of turns.
    pub(super) turns_as_symbols: Map<NodeId, Ex<'m>>,
    /// Whether known products of links could be used in one of them.
    pub(super) has_products: bool,
    pub(super) partials: Partials,
    pub(super) adjoints: Adjoints<'m>,
    pub(super) gradients: Map<NodeId, Gradient<'m>>,
    pub(super) dependence: Dependence,
}
