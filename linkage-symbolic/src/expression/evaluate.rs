//! Graphs on plain numbers.

use super::ex::Ex;
use crate::graph::{Node, NodeId, Source, SymbolId, meaning};
use crate::lookup::Map;

/// Evaluates expressions, following definitions. Symbols that have neither source nor definition
/// are NaN.
pub fn evaluate(roots: &[Ex], load: impl Fn(Source) -> f64) -> Vec<f64> {
    evaluate_given(roots, load, |_| None)
}

/// Evaluates expressions with values for some symbols, whatever their definitions say.
pub fn evaluate_given(
    roots: &[Ex],
    load: impl Fn(Source) -> f64,
    given: impl Fn(SymbolId) -> Option<f64>,
) -> Vec<f64> {
    let Some(graph) = roots.first().map(|root| root.graph()) else {
        return Vec::new();
    };
    let mut memo: Map<NodeId, f64> = Map::new();
    let mut stack: Vec<NodeId> = roots.iter().map(|root| root.id()).collect();
    while let Some(&id) = stack.last() {
        if memo.contains_key(&id) {
            stack.pop();
            continue;
        }
        let node = graph.node(id);
        let known = match node {
            Node::Symbol(symbol) => given(symbol),
            _ => None,
        };
        if let Some(value) = known {
            memo.insert(id, value);
            stack.pop();
            continue;
        }
        let meaning = meaning(graph, node);
        let waiting = stack.len();
        let below = node.operands().chain(meaning.0);
        stack.extend(below.filter(|x| !memo.contains_key(x)));
        if stack.len() > waiting {
            continue;
        }
        let value = match node {
            Node::Constant(bits) => f64::from_bits(bits),
            Node::Symbol(_) => match meaning {
                (Some(definition), _) => memo[&definition],
                (None, Some(source)) => load(source),
                (None, None) => f64::NAN,
            },
            Node::Unary(op, a) => op.apply([memo[&a]]),
            Node::Binary(op, a, b) => op.apply([memo[&a], memo[&b]]),
            Node::Ternary(op, a, b, c) => op.apply([memo[&a], memo[&b], memo[&c]]),
        };
        memo.insert(id, value);
        stack.pop();
    }
    roots.iter().map(|root| memo[&root.id()]).collect()
}
