//! What values depend on, definitions followed.

use std::collections::BTreeSet;

use linkage_symbolic::lookup::Map;

use linkage_symbolic::program::Source;
use linkage_symbolic::{Ex, NodeId, SymbolId};

use super::Algebra;

/// Inputs that symbols depend on, under the definitions of some revision of the graph.
#[derive(Clone, Debug, Default)]
pub(super) struct Dependence {
    revision: usize,
    inputs: Map<SymbolId, Vec<usize>>,
}

impl<'m> Algebra<'m> {
    /// All symbols that nodes are computed from.
    pub(crate) fn symbols_below(&self, all: &[Ex<'m>]) -> BTreeSet<SymbolId> {
        let mut found = BTreeSet::new();
        self.add_symbols_below(all, &mut found);
        found
    }

    /// Adds all symbols that nodes are computed from; returns those that were not there, whose own were not followed again.
    pub(crate) fn add_symbols_below(
        &self,
        all: &[Ex<'m>],
        found: &mut BTreeSet<SymbolId>,
    ) -> Vec<SymbolId> {
        let mut new = Vec::new();
        let mut open: Vec<NodeId> = all.iter().map(|x| x.id()).collect();
        while !open.is_empty() {
            let mut next = Vec::new();
            for symbol in self.graph.symbols_of(&open) {
                if found.insert(symbol) {
                    new.push(symbol);
                    next.extend(self.graph.symbol(symbol).definition);
                }
            }
            open = next;
        }
        new
    }

    /// The inputs that expressions depend on, in order.
    pub(crate) fn inputs_below(&mut self, all: &[Ex<'m>]) -> Vec<usize> {
        let nodes: Vec<NodeId> = all.iter().map(|x| x.id()).collect();
        let dependence = &mut self.derivatives.dependence;
        if dependence.revision != self.graph.revision() {
            dependence.inputs.clear();
            dependence.revision = self.graph.revision();
        }
        self.inputs_of_nodes(&nodes)
    }

    fn inputs_of_nodes(&mut self, nodes: &[NodeId]) -> Vec<usize> {
        let mut inputs: Vec<usize> = self
            .graph
            .symbols_of(nodes)
            .into_iter()
            .flat_map(|symbol| self.inputs_of_symbol(symbol))
            .collect();
        inputs.sort_unstable();
        inputs.dedup();
        inputs
    }

    fn inputs_of_symbol(&mut self, symbol: SymbolId) -> Vec<usize> {
        if let Some(known) = self.derivatives.dependence.inputs.get(&symbol) {
            return known.clone();
        }
        let record = self.graph.symbol(symbol);
        let inputs = match (record.source, record.definition) {
            (Some(Source::Input(index)), _) => vec![index],
            (_, Some(definition)) => self.inputs_of_nodes(&[definition]),
            _ => return Vec::new(),
        };
        let known = &mut self.derivatives.dependence.inputs;
        known.insert(symbol, inputs.clone());
        inputs
    }
}
