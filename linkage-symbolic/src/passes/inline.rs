//! Removes definitions: each unknown is replaced by the expression that it is computed from.

use crate::graph::{Graph, Node, NodeId, NodeNumbers, meaning};

/// Copies nodes of one graph into another without definitions, simplifying again: factors of a
/// link's length that cancel against the solution for that link do so here.
#[derive(Clone, Debug, Default)]
pub struct Inliner {
    /// The plain graph: its symbols all have sources.
    pub target: Graph,
    copied: NodeNumbers,
    /// The revision of the source: copies under other definitions are useless.
    revision: usize,
}

impl Inliner {
    /// The copy of `root` in the target graph. Symbols without source and definition must not
    /// occur. Under other definitions than before it is a copy of its own; equal expressions stay
    /// one node of the target.
    pub fn copy(&mut self, source: &Graph, root: NodeId) -> NodeId {
        if self.revision != source.revision() {
            self.copied = NodeNumbers::default();
            self.revision = source.revision();
        }
        self.copied.cover(source.len());
        let mut stack = vec![root];
        while let Some(&id) = stack.last() {
            if self.copied.has(id) {
                stack.pop();
                continue;
            }
            let waiting = stack.len();
            let node = source.node(id);
            for below in node.operands() {
                if !self.copied.has(below) {
                    stack.push(below);
                }
            }
            if let (Some(below), _) = meaning(source, node)
                && !self.copied.has(below)
            {
                stack.push(below);
            }
            if stack.len() > waiting {
                continue;
            }
            let copy = self.build(source, id);
            self.copied.set(id, copy.index());
            stack.pop();
        }
        self.copied.node(root)
    }

    fn build(&mut self, source: &Graph, id: NodeId) -> NodeId {
        let target = &self.target;
        let new = |x: NodeId| self.copied.node(x);
        match source.node(id) {
            Node::Constant(bits) => target.constant(f64::from_bits(bits)),
            Node::Symbol(symbol) => {
                let symbol = source.symbol(symbol);
                match (symbol.definition, symbol.source) {
                    (Some(definition), _) => new(definition),
                    (None, Some(source)) => target.source(source),
                    (None, None) => unreachable!("symbol {} has no meaning", symbol.name),
                }
            }
            Node::Unary(op, a) => target.unary(op, new(a)),
            Node::Binary(op, a, b) => target.binary(op, new(a), new(b)),
            Node::Ternary(op, a, b, c) => {
                let operands = [new(a), new(b), new(c)];
                target.store_mut().inlined_ternary(op, operands)
            }
        }
    }
}
