//! Symbols and inputs that values depend on, through all definitions.

use std::collections::BTreeSet;

use linkage_symbolic::program::Source;
use linkage_symbolic::{Ex, Graph, NodeId, SymbolId};

use crate::algebra::memo::Dependence;

/// All symbols that nodes are computed from.
pub(crate) fn symbols_below(graph: &Graph, all: &[Ex]) -> BTreeSet<SymbolId> {
    let mut found = BTreeSet::new();
    add_symbols_below(graph, all, &mut found);
    found
}

/// Adds all symbols that nodes are computed from; returns those that were not there, whose own were
/// not followed again.
pub(crate) fn add_symbols_below(
    graph: &Graph,
    all: &[Ex],
    found: &mut BTreeSet<SymbolId>,
) -> Vec<SymbolId> {
    let mut new = Vec::new();
    let mut open: Vec<NodeId> = all.iter().map(|x| x.id()).collect();
    while !open.is_empty() {
        let mut next = Vec::new();
        for symbol in graph.symbols_of(&open) {
            if found.insert(symbol) {
                new.push(symbol);
                next.extend(graph.symbol(symbol).definition);
            }
        }
        open = next;
    }
    new
}

/// The inputs that expressions depend on, in order.
pub(crate) fn inputs_below(graph: &Graph, dependence: &mut Dependence, all: &[Ex]) -> Vec<usize> {
    let nodes: Vec<NodeId> = all.iter().map(|x| x.id()).collect();
    if dependence.revision != graph.revision() {
        dependence.inputs.clear();
        dependence.revision = graph.revision();
    }
    inputs_of_nodes(graph, dependence, &nodes)
}

fn inputs_of_nodes(graph: &Graph, dependence: &mut Dependence, nodes: &[NodeId]) -> Vec<usize> {
    let mut inputs: Vec<usize> = graph
        .symbols_of(nodes)
        .into_iter()
        .flat_map(|symbol| inputs_of_symbol(graph, dependence, symbol))
        .collect();
    inputs.sort_unstable();
    inputs.dedup();
    inputs
}

fn inputs_of_symbol(graph: &Graph, dependence: &mut Dependence, symbol: SymbolId) -> Vec<usize> {
    if let Some(known) = dependence.inputs.get(&symbol) {
        return known.clone();
    }
    let record = graph.symbol(symbol);
    let inputs = match (record.source, record.definition) {
        (Some(Source::Input(index)), _) => vec![index],
        (_, Some(definition)) => inputs_of_nodes(graph, dependence, &[definition]),
        _ => return Vec::new(),
    };
    dependence.inputs.insert(symbol, inputs.clone());
    inputs
}
