//! What values depend on, definitions followed.

use std::collections::HashSet;

use linkage_symbolic::program::Source;
use linkage_symbolic::{NodeId, SymbolId};

use super::Algebra;

impl Algebra<'_> {
    /// All symbols that nodes are computed from.
    pub(crate) fn symbols_below(&self, nodes: &[NodeId]) -> HashSet<SymbolId> {
        let mut found: HashSet<SymbolId> = HashSet::new();
        let mut open = nodes.to_vec();
        while !open.is_empty() {
            let mut next = Vec::new();
            for symbol in self.graph.symbols_of(&open) {
                if found.insert(symbol) {
                    next.extend(self.graph.symbol(symbol).definition);
                }
            }
            open = next;
        }
        found
    }

    /// The inputs that nodes depend on, in order. Remembered for each symbol: the definitions below must be complete.
    pub(crate) fn inputs_below(&mut self, nodes: &[NodeId]) -> Vec<usize> {
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

    /// Whether something is computed from what the loops tell.
    pub(crate) fn depends_on_unknowns(&self, nodes: &[NodeId]) -> bool {
        let symbols = self.graph.symbols_of(nodes).into_iter();
        let mut sources = symbols.map(|symbol| self.graph.symbol(symbol).source);
        sources.any(|source| source.is_none())
    }

    fn inputs_of_symbol(&mut self, symbol: SymbolId) -> Vec<usize> {
        if let Some(known) = self.inputs_of.get(&symbol) {
            return known.clone();
        }
        let record = self.graph.symbol(symbol);
        let inputs = match (record.source, record.definition) {
            (Some(Source::Input(index)), _) => vec![index],
            (_, Some(definition)) => self.inputs_below(&[definition]),
            _ => return Vec::new(),
        };
        self.inputs_of.insert(symbol, inputs.clone());
        inputs
    }
}
