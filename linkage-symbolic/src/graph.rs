//! The graph: a flat arena of operations, behind a cell, so that formulas can be written as formulas.

mod slopes;
mod store;

use std::cell::{Ref, RefCell, RefMut};

use crate::expression::Ex;
use crate::operation::{Binary, Ternary, Unary};
use crate::program::Source;

pub(crate) use store::Store;

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

/// The earliest moment at which a value is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Binding {
    /// At compile time.
    Constant,
    /// In `assemble()`: depends on parameters, modes and windings alone.
    Parameter,
    /// At every call: depends on a driving coordinate.
    Call,
}

/// A leaf of the graph.
#[derive(Clone, Debug)]
pub struct Symbol {
    /// For dumps and messages.
    pub name: String,
    /// Where a program finds its value; `None` for a symbol that lives by its definition.
    pub source: Option<Source>,
    /// What it stands for, once known.
    pub definition: Option<NodeId>,
    /// When its value is known.
    pub binding: Binding,
}

/// A flat arena of operations. Equal operations are one node, constructors simplify. It grows behind a shared reference: [`Ex`] is a
/// node together with that.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    store: RefCell<Store>,
}

/// What a graph held at some time.
#[derive(Clone, Debug)]
pub struct Snapshot(Store);

impl Graph {
    /// An empty graph.
    pub fn new() -> Self {
        Self::default()
    }

    pub(crate) fn store(&self) -> Ref<'_, Store> {
        self.store.borrow()
    }

    pub(crate) fn store_mut(&self) -> RefMut<'_, Store> {
        self.store.borrow_mut()
    }

    /// All that it holds now, for [`Self::restore`].
    pub fn snapshot(&self) -> Snapshot {
        Snapshot(self.store().clone())
    }

    /// Forgets what was made since a snapshot. Expressions made since then must not be used any more.
    pub fn restore(&self, snapshot: Snapshot) {
        *self.store_mut() = snapshot.0;
    }

    /// A node as an expression to compute with.
    pub fn ex(&self, id: NodeId) -> Ex<'_> {
        Ex::new(self, id)
    }

    /// A number as an expression.
    pub fn number(&self, value: f64) -> Ex<'_> {
        self.ex(self.constant(value))
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.store().len()
    }

    /// True if it has no node.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The operation of a node.
    pub fn node(&self, id: NodeId) -> Node {
        self.store().node(id)
    }

    /// When a node's value is known.
    pub fn binding(&self, id: NodeId) -> Binding {
        self.store().binding(id)
    }

    /// The value of a constant node.
    pub fn constant_value(&self, id: NodeId) -> Option<f64> {
        self.store().constant_value(id)
    }

    /// A symbol's record.
    pub fn symbol(&self, id: SymbolId) -> Symbol {
        self.store().symbol(id).clone()
    }

    /// The node of the symbol that a program loads from `source`; one symbol for each source.
    pub fn source(&self, source: Source) -> NodeId {
        self.store_mut().source(source)
    }

    /// The symbol that is loaded from `source`, if the graph has one.
    pub fn find_source(&self, source: Source) -> Option<SymbolId> {
        self.store().find_source(source)
    }

    /// Loads from other places: `new` says from where. What was loaded from different places must still be.
    pub fn move_sources(&self, new: impl Fn(Source) -> Source) {
        self.store_mut().move_sources(new);
    }

    /// A fresh symbol that lives by a definition given now or later.
    pub fn unknown(&self, name: impl Into<String>) -> (SymbolId, NodeId) {
        self.store_mut().unknown(name.into())
    }

    /// Says that two symbols are the cosine and the sine of one angle.
    pub fn pair(&self, cos: SymbolId, sin: SymbolId) {
        self.store_mut().pair(cos, sin);
    }

    /// The node of a symbol.
    pub fn symbol_node(&self, symbol: SymbolId) -> NodeId {
        self.store_mut().intern(Node::Symbol(symbol))
    }

    /// How many symbols there are.
    pub fn symbol_count(&self) -> usize {
        self.store().symbol_count()
    }

    /// The symbols made since there were `count`.
    pub fn symbols_since(&self, count: usize) -> impl Iterator<Item = SymbolId> + use<> {
        (count as u32..self.symbol_count() as u32).map(SymbolId)
    }

    /// Says what a symbol stands for.
    pub fn define(&self, symbol: SymbolId, definition: NodeId) {
        self.store_mut().define(symbol, definition);
    }

    /// A number that changes whenever a definition is exchanged for another.
    pub fn revision(&self) -> usize {
        self.store().revision()
    }

    /// All nodes that `roots` are made of, roots included, children first, without following definitions.
    pub fn reachable(&self, roots: &[NodeId]) -> Vec<NodeId> {
        self.store().reachable(roots)
    }

    /// True if `root` is `part` or computed from it, without following definitions.
    pub fn contains(&self, root: NodeId, part: NodeId) -> bool {
        self.store().contains(root, part)
    }

    /// The symbols that `roots` are made of, in order, without following definitions.
    pub fn symbols_of(&self, roots: &[NodeId]) -> Vec<SymbolId> {
        self.store().symbols_of(roots)
    }

    /// A number.
    pub fn constant(&self, value: f64) -> NodeId {
        self.store_mut().constant(value)
    }

    /// The constant 0.
    pub fn zero(&self) -> NodeId {
        self.constant(0.0)
    }

    /// The constant 1.
    pub fn one(&self) -> NodeId {
        self.constant(1.0)
    }

    /// True for the constant 0.
    pub fn is_zero(&self, id: NodeId) -> bool {
        self.store().is_zero(id)
    }

    /// Any unary operation.
    pub fn unary(&self, op: Unary, a: NodeId) -> NodeId {
        self.store_mut().unary(op, a)
    }

    /// Any binary operation.
    pub fn binary(&self, op: Binary, a: NodeId, b: NodeId) -> NodeId {
        self.store_mut().binary(op, a, b)
    }

    /// Any ternary operation.
    pub fn ternary(&self, op: Ternary, a: NodeId, b: NodeId, c: NodeId) -> NodeId {
        self.store_mut().ternary(op, a, b, c)
    }

    /// `-a`
    pub fn neg(&self, a: NodeId) -> NodeId {
        self.unary(Unary::Neg, a)
    }

    /// `|a|`
    pub fn abs(&self, a: NodeId) -> NodeId {
        self.unary(Unary::Abs, a)
    }

    /// `a + b`
    pub fn add(&self, a: NodeId, b: NodeId) -> NodeId {
        self.binary(Binary::Add, a, b)
    }

    /// `a - b`
    pub fn sub(&self, a: NodeId, b: NodeId) -> NodeId {
        self.binary(Binary::Sub, a, b)
    }

    /// `a * b`
    pub fn mul(&self, a: NodeId, b: NodeId) -> NodeId {
        self.binary(Binary::Mul, a, b)
    }

    /// `a / b`
    pub fn div(&self, a: NodeId, b: NodeId) -> NodeId {
        self.binary(Binary::Div, a, b)
    }

    /// `sqrt(a^2 + b^2)`
    pub fn hypot(&self, a: NodeId, b: NodeId) -> NodeId {
        self.binary(Binary::Hypot, a, b)
    }

    /// `sqrt(a)`
    pub fn sqrt(&self, a: NodeId) -> NodeId {
        self.unary(Unary::Sqrt, a)
    }

    /// `a^2`
    pub fn square(&self, a: NodeId) -> NodeId {
        self.mul(a, a)
    }
}
