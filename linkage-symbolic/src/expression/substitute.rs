//! Replacing symbols by expressions.

use super::ex::Ex;
use crate::graph::{Graph, Node, NodeId, SymbolId};
use crate::lookup::Map;
use crate::operation::Binary;

/// The expressions `roots` with symbols replaced as `map` says, simplified again.
pub fn substitute<'g>(roots: &[Ex<'g>], map: &Map<SymbolId, Ex<'g>>) -> Vec<Ex<'g>> {
    let Some(graph) = roots.first().map(|root| root.graph()) else {
        return Vec::new();
    };
    let ids: Vec<NodeId> = roots.iter().map(|root| root.id()).collect();
    let mut renewed: Map<NodeId, NodeId> = Map::new();
    for id in graph.reachable(&ids) {
        let node = graph.node(id);
        let new = match node {
            Node::Symbol(symbol) => map.get(&symbol).map_or(id, |new| new.id()),
            _ => rebuild(graph, id, node, |x| renewed[&x]),
        };
        renewed.insert(id, new);
    }
    ids.iter().map(|id| graph.ex(renewed[id])).collect()
}

/// The operation `node` on new operands.
pub(crate) fn rebuild(
    graph: &Graph,
    id: NodeId,
    node: Node,
    new: impl Fn(NodeId) -> NodeId,
) -> NodeId {
    let mut same = true;
    for operand in node.operands() {
        same &= new(operand) == operand;
    }
    if same {
        return id;
    }
    match node {
        Node::Constant(_) | Node::Symbol(_) => id,
        Node::Unary(op, a) => graph.unary(op, new(a)),
        Node::Binary(op, a, b) => graph.binary(op, new(a), new(b)),
        Node::Ternary(op, a, b, c) => graph.ternary(op, new(a), new(b), new(c)),
    }
}

/// Does the same, but keeps products as they are: shared multiples are not distributed over their
/// sums again.
pub(crate) fn rebuild_shared(
    graph: &Graph,
    id: NodeId,
    node: Node,
    new: impl Fn(NodeId) -> NodeId,
) -> NodeId {
    match node {
        Node::Binary(Binary::Mul, a, b) if [a, b].map(&new) != [a, b] => {
            graph.store_mut().plain_product(new(a), new(b))
        }
        _ => rebuild(graph, id, node, new),
    }
}
