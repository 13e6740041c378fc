//! Plain graphs: expressions whose definitions are inlined.

use linkage_symbolic::inline::Inliner;
use linkage_symbolic::program::Source;
use linkage_symbolic::{Ex, Graph, NodeId};

use crate::algebra::Algebra;
use crate::solve::Formulation;

/// Expressions without definitions, as nodes of the inliner's plain graph.
pub(crate) fn plain(inliner: &mut Inliner, expressions: &[Ex]) -> Vec<NodeId> {
    let copies = expressions.iter().map(|x| inliner.copy(x.graph(), x.id()));
    copies.collect()
}

/// A plain graph that begins with the solved groups.
///
/// All graphs of a mechanism begin like this: sums that functions have in common are then ordered
/// alike in each of them.
pub(crate) fn solved_groups(algebra: &Algebra, formulation: &Formulation) -> Inliner {
    let mut inliner = Inliner::default();
    let closed = formulation.groups.iter().flat_map(|group| {
        let unknowns = group.group.unknowns.iter();
        let numbers = unknowns.flat_map(|&unknown| algebra.names.numbers_of(unknown));
        numbers.chain([group.closed.gap]).collect::<Vec<_>>()
    });
    plain(&mut inliner, &closed.collect::<Vec<_>>());
    inliner
}

/// The angles whose values are used in nodes of a plain graph, sorted.
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
