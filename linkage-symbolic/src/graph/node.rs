//! Nodes and symbols of the graph.

use super::binding::{Binding, Source};
use crate::operation::{Binary, Ternary, Unary};

/// Index of a node; children have smaller indices than their parents.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct NodeId(pub(crate) u32);

/// Index of a symbol.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct SymbolId(pub(crate) u32);

impl NodeId {
    /// Position in the arena.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

impl SymbolId {
    /// Position in the list of symbols.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// One operation. Constants are kept by their bits so that nodes can be hashed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// A number's bits.
    Constant(u64),
    /// A leaf.
    Symbol(SymbolId),
    /// An operation of one operand.
    Unary(Unary, NodeId),
    /// An operation of two operands.
    Binary(Binary, NodeId, NodeId),
    /// An operation of three operands.
    Ternary(Ternary, NodeId, NodeId, NodeId),
}

impl Node {
    /// The operands, in order.
    pub fn operands(&self) -> impl Iterator<Item = NodeId> + use<> {
        let list = match *self {
            Node::Constant(_) | Node::Symbol(_) => [None; 3],
            Node::Unary(_, a) => [Some(a), None, None],
            Node::Binary(_, a, b) => [Some(a), Some(b), None],
            Node::Ternary(_, a, b, c) => [Some(a), Some(b), Some(c)],
        };
        list.into_iter().flatten()
    }
}

/// A leaf of the graph.
#[derive(Clone, Debug)]
pub struct Symbol {
    /// For dumps and messages.
    pub name: String,
    /// The source that a program loads its value from; `None` for a symbol that lives by its
    /// definition.
    pub source: Option<Source>,
    /// Its definition, once known.
    pub definition: Option<NodeId>,
    /// When its value is known.
    pub binding: Binding,
}
