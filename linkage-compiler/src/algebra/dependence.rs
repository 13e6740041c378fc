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

/// All symbols that nodes are computed from.
pub(crate) fn symbols_below<'m>(algebra: &Algebra<'m>, all: &[Ex<'m>]) -> BTreeSet<SymbolId> {
    let mut found = BTreeSet::new();
    add_symbols_below(algebra, all, &mut found);
    found
}

/// Adds all symbols that nodes are computed from; returns those that were not there, whose own were not followed again.
pub(crate) fn add_symbols_below<'m>(
    algebra: &Algebra<'m>,
    all: &[Ex<'m>],
    found: &mut BTreeSet<SymbolId>,
) -> Vec<SymbolId> {
    let mut new = Vec::new();
    let mut open: Vec<NodeId> = all.iter().map(|x| x.id()).collect();
    while !open.is_empty() {
        let mut next = Vec::new();
        for symbol in algebra.graph.symbols_of(&open) {
            if found.insert(symbol) {
                new.push(symbol);
                next.extend(algebra.graph.symbol(symbol).definition);
            }
        }
        open = next;
    }
    new
}

/// The inputs that expressions depend on, in order.
pub(crate) fn inputs_below<'m>(algebra: &mut Algebra<'m>, all: &[Ex<'m>]) -> Vec<usize> {
    let nodes: Vec<NodeId> = all.iter().map(|x| x.id()).collect();
    let dependence = &mut algebra.derivatives.dependence;
    if dependence.revision != algebra.graph.revision() {
        dependence.inputs.clear();
        dependence.revision = algebra.graph.revision();
    }
    inputs_of_nodes(algebra, &nodes)
}

fn inputs_of_nodes(algebra: &mut Algebra<'_>, nodes: &[NodeId]) -> Vec<usize> {
    let mut inputs: Vec<usize> = algebra
        .graph
        .symbols_of(nodes)
        .into_iter()
        .flat_map(|symbol| inputs_of_symbol(algebra, symbol))
        .collect();
    inputs.sort_unstable();
    inputs.dedup();
    inputs
}

fn inputs_of_symbol(algebra: &mut Algebra<'_>, symbol: SymbolId) -> Vec<usize> {
    if let Some(known) = algebra.derivatives.dependence.inputs.get(&symbol) {
        return known.clone();
    }
    let record = algebra.graph.symbol(symbol);
    let inputs = match (record.source, record.definition) {
        (Some(Source::Input(index)), _) => vec![index],
        (_, Some(definition)) => inputs_of_nodes(algebra, &[definition]),
        _ => return Vec::new(),
    };
    let known = &mut algebra.derivatives.dependence.inputs;
    known.insert(symbol, inputs.clone());
    inputs
}
