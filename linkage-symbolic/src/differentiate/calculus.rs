//! Derivatives of graph nodes.

use super::chain_rule::chain_rule;
use crate::expression::Ex;
use crate::graph::{Graph, Node, NodeId, SymbolId};
use crate::lookup::Map;

/// Derivatives already known: of a node, by a symbol.
pub type DerivativeMemo = Map<(NodeId, SymbolId), NodeId>;

/// Derivatives of symbols: parameters and inputs are independent, and the solution of a loop
/// follows the implicit function theorem.
pub trait Calculus<'g> {
    /// The graph that derivatives are built in.
    fn graph(&self) -> &'g Graph;
    /// Derivatives already known under these rules.
    fn memo(&mut self) -> &mut DerivativeMemo;
    /// The derivative of an operation, if it is known otherwise than by the chain rule.
    fn known_derivative(&mut self, _node: NodeId, _variable: SymbolId) -> Option<NodeId> {
        None
    }
    /// The derivative of one symbol by another.
    fn symbol_derivative(&mut self, symbol: SymbolId, variable: SymbolId) -> NodeId;
}

/// The derivative of `root` by `variable`.
pub fn differentiate<'g, C: Calculus<'g> + ?Sized>(
    calculus: &mut C,
    root: NodeId,
    variable: SymbolId,
) -> NodeId {
    let graph = calculus.graph();
    let mut stack = vec![root];
    while let Some(&id) = stack.last() {
        if calculus.memo().contains_key(&(id, variable)) {
            stack.pop();
            continue;
        }
        if let Some(known) = calculus.known_derivative(id, variable) {
            calculus.memo().insert((id, variable), known);
            stack.pop();
            continue;
        }
        let node = graph.node(id);
        let waiting = stack.len();
        let known = graph.known_slope(id);
        let mut wait_for = |operand: NodeId| {
            if !calculus.memo().contains_key(&(operand, variable)) {
                stack.push(operand);
            }
        };
        match known {
            Some((argument, _)) => wait_for(argument),
            None => {
                for operand in node.operands() {
                    wait_for(operand);
                }
            }
        }
        if stack.len() > waiting {
            continue;
        }
        if let Some((argument, slope)) = known {
            let rate = calculus.memo()[&(argument, variable)];
            let derivative = graph.mul(slope, rate);
            calculus.memo().insert((id, variable), derivative);
            stack.pop();
            continue;
        }
        let derivative = match node {
            Node::Constant(_) => graph.zero(),
            Node::Symbol(symbol) if symbol == variable => graph.one(),
            Node::Symbol(symbol) => calculus.symbol_derivative(symbol, variable),
            Node::Unary(..) | Node::Binary(..) | Node::Ternary(..) => {
                let memo = calculus.memo();
                let rates = node.operands().map(|x| graph.ex(memo[&(x, variable)]));
                let rates: Vec<Ex> = rates.collect();
                chain_rule(graph.ex(id), &rates).id()
            }
        };
        calculus.memo().insert((id, variable), derivative);
        stack.pop();
    }
    calculus.memo()[&(root, variable)]
}
