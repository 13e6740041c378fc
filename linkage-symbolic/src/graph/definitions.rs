//! Definitions of symbols, as a walk through the graph follows them.

use super::binding::Source;
use super::node::{Node, NodeId};
use super::shared::Graph;

/// Returns the definition of a symbol, and the source that it is loaded from. Operations have
/// neither.
pub(crate) fn meaning(graph: &Graph, node: Node) -> (Option<NodeId>, Option<Source>) {
    let Node::Symbol(symbol) = node else {
        return (None, None);
    };
    let store = graph.store();
    let symbol = store.symbol(symbol);
    (symbol.definition, symbol.source)
}
