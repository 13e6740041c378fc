//! Derivatives that were found already, by the group, variable or number that they belong to.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use linkage_symbolic::lookup::Map;
use linkage_symbolic::{DerivativeMemo, Ex, NodeId, SymbolId, V3};

use crate::algebra::solutions::Shortcuts;
use crate::algebra::systems::{Solved, System};

/// Derivatives found already: total ones, those of the unknowns of groups, and the results of
/// sweeps backwards.
#[derive(Clone, Debug, Default)]
pub(crate) struct DerivativeMemos<'m> {
    pub(crate) memo: DerivativeMemo,
    /// Derivatives of unknowns, by group and variables.
    pub(crate) rates: Map<(usize, Vec<SymbolId>), Rates<'m>>,
    /// Turns of the bodies, by group and variable.
    pub(crate) rotations: Map<(usize, SymbolId), Vec<V3<'m>>>,
    /// Changes of the first variable's turns with the second one, by group and two variables.
    pub(crate) second_rotations: Map<(usize, [SymbolId; 2]), Vec<V3<'m>>>,
    /// The number of times that derivatives of unknowns are replaced: bodies do not turn then as
    /// they do.
    pub(crate) held: usize,
    /// The symbols that stand for components of turns.
    pub(crate) rotation_symbols: Map<NodeId, Ex<'m>>,
    /// The shortcuts that could be made use of in one of them.
    pub(crate) offered: Shortcuts,
    pub(crate) partials: Partials,
    pub(crate) adjoints: Adjoints<'m>,
    pub(crate) gradients: Map<NodeId, Rc<Gradient<'m>>>,
    pub(crate) dependence: Dependence,
}

/// Derivatives of a group's unknowns by some variables, and the right-hand side that they solve.
#[derive(Clone, Debug)]
pub(crate) struct Rates<'m> {
    pub(crate) right: Vec<Ex<'m>>,
    pub(crate) rates: Vec<Ex<'m>>,
}

/// The unknowns and rates that symbols mention, as far as they have been found.
pub(crate) type Mentioned = Map<SymbolId, BTreeSet<Solved>>;

/// Partial derivatives found already.
#[derive(Clone, Debug, Default)]
pub(crate) struct Partials {
    pub(crate) memo: DerivativeMemo,
    /// Symbols that stand for unknowns of groups as variables.
    pub(crate) unknowns: Map<(usize, usize), SymbolId>,
    pub(crate) mentioned: Mentioned,
    pub(crate) acting: Acting,
}

/// The symbols without a rule: parameters and inputs.
pub(crate) type Given = Rc<BTreeSet<SymbolId>>;

/// Parameters that act on symbols and systems, as far as they have been found.
#[derive(Clone, Debug, Default)]
pub(crate) struct Acting {
    pub(crate) on_symbols: Map<SymbolId, Given>,
    pub(crate) on_systems: Map<System, Given>,
}

/// Positions in a list, by the parameters that act on the entries there.
#[derive(Clone, Debug, Default)]
pub(crate) struct ByParameter(Map<SymbolId, Vec<usize>>);

impl ByParameter {
    /// Adds a place, which is not before those added already.
    pub(crate) fn add(&mut self, position: usize, acting: &BTreeSet<SymbolId>) {
        for &symbol in acting {
            let places = self.0.entry(symbol).or_default();
            if places.last() != Some(&position) {
                places.push(position);
            }
        }
    }

    /// The places that a parameter acts on, in order.
    pub(crate) fn positions_for(&self, parameter: SymbolId) -> &[usize] {
        self.0.get(&parameter).map_or(&[], Vec::as_slice)
    }
}

/// The multipliers of the equations of one system.
#[derive(Clone, Debug)]
pub(crate) struct Multiplier<'m> {
    pub(crate) system: System,
    /// The derivatives by its results.
    pub(crate) weights: Vec<Ex<'m>>,
    pub(crate) factors: Vec<Ex<'m>>,
}

/// The results of a sweep backwards.
#[derive(Clone, Debug, Default)]
pub(crate) struct Flow<'m> {
    /// The multipliers of all systems that it visited.
    pub(crate) multipliers: Vec<Multiplier<'m>>,
    /// The places of multipliers whose equations mention a parameter: each parameter visits its
    /// own, not all of them.
    pub(crate) acting: ByParameter,
    /// The derivatives with respect to unknowns and rates at which it ended.
    pub(crate) ends: BTreeMap<Solved, Ex<'m>>,
}

/// Multipliers found already.
#[derive(Clone, Debug, Default)]
pub(crate) struct Adjoints<'m> {
    pub(crate) of_nodes: Map<NodeId, Rc<Flow<'m>>>,
    /// Sweeps from numbers, with the ends at all intermediates.
    pub(crate) flows: Map<NodeId, Rc<ThroughIntermediates<'m>>>,
    /// Sweeps from intermediates.
    pub(crate) of_intermediates: Map<Solved, Rc<Flow<'m>>>,
    /// Derivatives of intermediates, without the part through earlier ones.
    pub(crate) between: Map<(Solved, SymbolId), Ex<'m>>,
}

/// The way from a number backwards through all intermediates.
#[derive(Clone, Debug)]
pub(crate) struct ThroughIntermediates<'m> {
    /// To the first ones.
    pub(crate) flow: Flow<'m>,
    /// All of them in order, with the derivatives of the number with respect to each.
    pub(crate) intermediates: Vec<(Solved, Ex<'m>)>,
    /// The intermediates between which and those before a parameter acts.
    pub(crate) acting: ByParameter,
}

/// Derivatives of a number by the nodes at which a sweep ends: inputs, and values known before the
/// input.
#[derive(Clone, Debug)]
pub(crate) struct Gradient<'m> {
    pub(crate) ends: Vec<(Ex<'m>, Ex<'m>)>,
    /// The ends that a parameter acts on.
    pub(crate) acting: ByParameter,
}

/// Inputs that symbols depend on, under the definitions of some revision of the graph.
#[derive(Clone, Debug, Default)]
pub(crate) struct Dependence {
    pub(crate) revision: usize,
    pub(crate) inputs: Map<SymbolId, Vec<usize>>,
}
