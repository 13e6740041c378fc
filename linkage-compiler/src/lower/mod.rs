//! From expressions to programs: definitions removed, values shared, sliced and ordered.
//!
//! What closes the loops ([`closing`]) is made before any function is looked at.

mod closing;
mod groups;
mod missed;
mod passes;

use linkage_symbolic::inline::Inliner;
use linkage_symbolic::program::Source;
use linkage_symbolic::{Ex, Graph, NodeId};

pub(crate) use closing::closing;
pub(crate) use groups::{Found, GroupNodes, find_turning, group_nodes, groups};
pub(crate) use missed::missed;
pub(crate) use passes::{Formulas, polish};

/// Expressions without definitions, as nodes of the inliner's plain graph.
pub(crate) fn plain(inliner: &mut Inliner, all: &[Ex]) -> Vec<NodeId> {
    let copies = all.iter().map(|x| inliner.copy(x.graph(), x.id()));
    copies.collect()
}

/// The angles whose values nodes of a plain graph are computed from.
pub(crate) fn valued_angles(graph: &Graph, nodes: &[NodeId]) -> Vec<usize> {
    let symbols = graph.symbols_of(nodes).into_iter();
    let mut angles: Vec<usize> = symbols
        .filter_map(|symbol| match graph.symbol(symbol).source {
            Some(Source::Centre(angle)) => Some(angle),
            _ => None,
        })
        .collect();
    angles.sort_unstable();
    angles
}
