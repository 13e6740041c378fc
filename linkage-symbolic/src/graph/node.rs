//! Nodes and symbols of the graph.

use std::hash::{Hash, Hasher};

use super::binding::{Binding, Source};
use crate::operands::Operands;
use crate::operation::{Binary, Ternary, Unary};

/// Index of a node; children have smaller indices than their parents.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct NodeId(pub(crate) u32);

/// Index of a symbol.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
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
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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

// Words as hashes take them: the derived code takes two calls more for each of many look-ups.
impl Hash for NodeId {
    fn hash<H: Hasher>(&self, state: &mut H) {
        state.write_u64(self.0 as u64);
    }
}

impl Hash for SymbolId {
    fn hash<H: Hasher>(&self, state: &mut H) {
        state.write_u64(self.0 as u64);
    }
}

impl Hash for Node {
    /// Two words instead of one for each part: the graph looks up every operation that is made.
    fn hash<H: Hasher>(&self, state: &mut H) {
        let (first, second) = match *self {
            Self::Constant(bits) => (0, bits),
            Self::Symbol(symbol) => (1, symbol.0 as u64),
            Self::Unary(op, a) => (2 | (op as u64) << 8, a.0 as u64),
            Self::Binary(op, a, b) => (3 | (op as u64) << 8, (a.0 as u64) << 32 | b.0 as u64),
            Self::Ternary(op, a, b, c) => {
                let first = 4 | (op as u64) << 8 | (a.0 as u64) << 32;
                (first, (b.0 as u64) << 32 | c.0 as u64)
            }
        };
        state.write_u64(first);
        state.write_u64(second);
    }
}

impl Node {
    /// The operands, in order.
    pub fn operands(&self) -> Operands<NodeId> {
        let none = NodeId(0);
        let (list, count) = match *self {
            Node::Constant(_) | Node::Symbol(_) => ([none; 3], 0),
            Node::Unary(_, a) => ([a, none, none], 1),
            Node::Binary(_, a, b) => ([a, b, none], 2),
            Node::Ternary(_, a, b, c) => ([a, b, c], 3),
        };
        Operands::new(list, count)
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
