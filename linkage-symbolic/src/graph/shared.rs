//! The graph: a store behind a cell, so that formulas can be written as formulas.

use std::cell::{Ref, RefCell, RefMut};

use super::binding::{Binding, Source};
use super::node::{Node, NodeId, Symbol, SymbolId};
use super::store::Store;

/// A flat arena of operations. Equal operations are one node, constructors simplify. It grows
/// behind a shared reference: [`Ex`](crate::Ex) is a node together with that.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    store: RefCell<Store>,
}

/// The contents of a graph at some time.
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

    /// Drops everything that was made since a snapshot. Expressions made since then must not be
    /// used any more.
    pub fn restore(&self, snapshot: Snapshot) {
        *self.store_mut() = snapshot.0;
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

    /// Replaces each source by `new(source)`. Different sources must stay different.
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

    /// Returns the number of symbols.
    pub fn symbol_count(&self) -> usize {
        self.store().symbol_count()
    }

    /// The symbols made since there were `count`.
    pub fn symbols_since(&self, count: usize) -> impl Iterator<Item = SymbolId> + use<> {
        (count as u32..self.symbol_count() as u32).map(SymbolId)
    }

    /// Sets the definition of a symbol.
    pub fn define(&self, symbol: SymbolId, definition: NodeId) {
        self.store_mut().define(symbol, definition);
    }

    /// A number that changes whenever a definition is exchanged for another.
    pub fn revision(&self) -> usize {
        self.store().revision()
    }

    /// All nodes that `roots` are made of, roots included, children first, without following
    /// definitions.
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

    /// True for the constant 0.
    pub fn is_zero(&self, id: NodeId) -> bool {
        self.store().is_zero(id)
    }

    /// The vector that a node is known to be the length of.
    pub fn vector_of_length(&self, length: NodeId) -> Option<Vec<NodeId>> {
        self.store().vectors.norms.get(&length).cloned()
    }

    /// The vector that a node is known to be the square of.
    pub fn vector_of_square(&self, square: NodeId) -> Option<Vec<NodeId>> {
        self.store().vectors.squares.get(&square).cloned()
    }

    /// Returns the argument of a node and its slope with respect to that, if it was set.
    pub(crate) fn known_slope(&self, id: NodeId) -> Option<(NodeId, NodeId)> {
        self.store().slopes.get(&id).copied()
    }
}
