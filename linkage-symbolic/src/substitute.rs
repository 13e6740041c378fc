//! Replacing symbols by expressions.

use std::collections::HashMap;

use crate::graph::{Graph, Node, NodeId, SymbolId};

/// The nodes `roots` with symbols replaced as `map` says, simplified anew.
pub fn substitute(graph: &Graph, roots: &[NodeId], map: &HashMap<SymbolId, NodeId>) -> Vec<NodeId> {
    let mut renewed: HashMap<NodeId, NodeId> = HashMap::new();
    for id in graph.reachable(roots) {
        let node = graph.node(id);
        let new = match node {
            Node::Symbol(symbol) => map.get(&symbol).copied().unwrap_or(id),
            _ => rebuild(graph, id, node, |x| renewed[&x]),
        };
        renewed.insert(id, new);
    }
    roots.iter().map(|root| renewed[root]).collect()
}

/// The operation `node` on new operands.
pub(crate) fn rebuild(
    graph: &Graph,
    id: NodeId,
    node: Node,
    new: impl Fn(NodeId) -> NodeId,
) -> NodeId {
    if node.operands().all(|x| new(x) == x) {
        return id;
    }
    match node {
        Node::Constant(_) | Node::Symbol(_) => id,
        Node::Unary(op, a) => graph.unary(op, new(a)),
        Node::Binary(op, a, b) => graph.binary(op, new(a), new(b)),
        Node::Ternary(op, a, b, c) => graph.ternary(op, new(a), new(b), new(c)),
    }
}
