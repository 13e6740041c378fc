//! The contents of the graph.

use std::cell::RefCell;

use super::binding::{Binding, Source};
use super::marks::Marks;
use super::node::{Node, NodeId, Symbol, SymbolId};
use super::vectors::Vectors;
use crate::lookup::{Map, Set};

/// Among so many nodes for each one that is looked for, these are put in order by going through all.
const DENSE: usize = 16;

/// A flat arena of operations. Equal operations are one node.
#[derive(Clone, Debug, Default)]
pub(crate) struct Store {
    nodes: Vec<Node>,
    bindings: Vec<Binding>,
    /// True for each node that is never negative.
    never_negative: Vec<bool>,
    index: Map<Node, NodeId>,
    symbols: Vec<Symbol>,
    sources: Map<Source, SymbolId>,
    /// The cosine that a sine belongs to.
    cosines: Map<SymbolId, SymbolId>,
    with_sine: Set<SymbolId>,
    /// The number of definitions that were exchanged for another.
    revision: usize,
    /// The nodes that the present walk has seen.
    marks: RefCell<Marks>,
    /// Known facts about vectors.
    pub(crate) vectors: Vectors,
    /// Known slopes of nodes: the argument, and the slope with respect to it.
    pub(crate) slopes: Map<NodeId, (NodeId, NodeId)>,
}

impl Store {
    /// Number of nodes.
    pub(crate) fn len(&self) -> usize {
        self.nodes.len()
    }

    /// The operation of a node.
    pub(crate) fn node(&self, id: NodeId) -> Node {
        // A slice: an index of a list is two calls more where nothing is optimised.
        let nodes: &[Node] = &self.nodes;
        nodes[id.0 as usize]
    }

    /// When a node's value is known.
    pub(crate) fn binding(&self, id: NodeId) -> Binding {
        let bindings: &[Binding] = &self.bindings;
        bindings[id.0 as usize]
    }

    /// Returns true for a node that is no negative number for any operands; it may be -0, or NaN.
    pub(crate) fn is_never_negative(&self, id: NodeId) -> bool {
        let never_negative: &[bool] = &self.never_negative;
        never_negative[id.0 as usize]
    }

    /// A number.
    pub(crate) fn constant(&mut self, value: f64) -> NodeId {
        // -0 and 0 are one constant: the sign of zero carries no meaning in a mechanism.
        let value = if value == 0.0 { 0.0 } else { value };
        self.intern(Node::Constant(value.to_bits()))
    }

    /// The value of a constant node.
    pub(crate) fn constant_value(&self, id: NodeId) -> Option<f64> {
        match self.node(id) {
            Node::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    /// A symbol's record.
    pub(crate) fn symbol(&self, id: SymbolId) -> &Symbol {
        &self.symbols[id.index()]
    }

    /// The node of the symbol that a program loads from `source`; one symbol for each source.
    pub(crate) fn source(&mut self, source: Source) -> NodeId {
        if let Some(&symbol) = self.sources.get(&source) {
            return self.intern(Node::Symbol(symbol));
        }
        let symbol = self.add_symbol(Symbol {
            name: format!("{source:?}"),
            source: Some(source),
            definition: None,
            binding: source.binding(),
        });
        self.sources.insert(source, symbol);
        self.intern(Node::Symbol(symbol))
    }

    /// The symbol that is loaded from `source`, if the graph has one.
    pub(crate) fn find_source(&self, source: Source) -> Option<SymbolId> {
        self.sources.get(&source).copied()
    }

    /// A fresh symbol that lives by a definition given now or later.
    pub(crate) fn unknown(&mut self, name: String) -> (SymbolId, NodeId) {
        let symbol = self.add_symbol(Symbol {
            name,
            source: None,
            definition: None,
            binding: Binding::Call,
        });
        (symbol, self.intern(Node::Symbol(symbol)))
    }

    /// Says that two symbols are the cosine and the sine of one angle.
    pub(crate) fn pair(&mut self, cos: SymbolId, sin: SymbolId) {
        self.cosines.insert(sin, cos);
        self.with_sine.insert(cos);
    }

    /// The cosine of the angle that a symbol is the sine of.
    pub(crate) fn cosine_of(&self, sin: SymbolId) -> Option<SymbolId> {
        self.cosines.get(&sin).copied()
    }

    pub(crate) fn is_cosine(&self, symbol: SymbolId) -> bool {
        self.with_sine.contains(&symbol)
    }

    /// Returns the number of symbols.
    pub(crate) fn symbol_count(&self) -> usize {
        self.symbols.len()
    }

    /// Sets the definition of a symbol. Results that were found with another definition must be
    /// found again.
    pub(crate) fn define(&mut self, symbol: SymbolId, definition: NodeId) {
        let old = self.symbols[symbol.index()].definition.replace(definition);
        if old.is_some_and(|old| old != definition) {
            self.revision += 1;
        }
    }

    pub(crate) fn revision(&self) -> usize {
        self.revision
    }

    /// Replaces each source by `new(source)`. Different sources stay different.
    pub(crate) fn move_sources(&mut self, new: impl Fn(Source) -> Source) {
        self.sources = Map::new();
        for (index, symbol) in self.symbols.iter_mut().enumerate() {
            if let Some(source) = symbol.source.map(&new) {
                symbol.name = format!("{source:?}");
                symbol.source = Some(source);
                self.sources.insert(source, SymbolId(index as u32));
            }
        }
    }

    fn add_symbol(&mut self, symbol: Symbol) -> SymbolId {
        self.symbols.push(symbol);
        SymbolId(self.symbols.len() as u32 - 1)
    }

    /// A node that exists already.
    pub(crate) fn find(&self, node: Node) -> Option<NodeId> {
        self.index.get(&node).copied()
    }

    /// The node of an operation, new or old. No simplification: see the constructors.
    pub(crate) fn intern(&mut self, node: Node) -> NodeId {
        if let Some(&id) = self.index.get(&node) {
            return id;
        }
        let binding = match node {
            Node::Constant(_) => Binding::Constant,
            Node::Symbol(symbol) => self.symbols[symbol.index()].binding,
            _ => {
                let mut latest = Binding::Constant;
                for operand in node.operands() {
                    latest = latest.max(self.binding(operand));
                }
                latest
            }
        };
        let never_negative = self.makes_no_negative(node);
        let id = NodeId(self.nodes.len() as u32);
        self.nodes.push(node);
        self.bindings.push(binding);
        self.never_negative.push(never_negative);
        self.index.insert(node, id);
        id
    }

    /// All nodes that `roots` are made of, roots included, children first, without following
    /// definitions.
    pub(crate) fn reachable(&self, roots: &[NodeId]) -> Vec<NodeId> {
        let mut seen = self.marks.borrow_mut();
        seen.begin(self.len());
        let mut open: Vec<NodeId> = roots.to_vec();
        let mut found = Vec::new();
        let (mut first, mut end) = (self.len(), 0);
        while let Some(id) = open.pop() {
            if !seen.mark(id) {
                continue;
            }
            let index = id.index();
            first = first.min(index);
            end = end.max(index + 1);
            found.push(id);
            for operand in self.node(id).operands() {
                if !seen.has(operand) {
                    open.push(operand);
                }
            }
        }
        if found.len() < end.saturating_sub(first) / DENSE {
            found.sort_unstable();
            return found;
        }
        found.clear();
        while first < end {
            let id = NodeId(first as u32);
            if seen.has(id) {
                found.push(id);
            }
            first += 1;
        }
        found
    }

    /// True if `root` is `part` or computed from it, without following definitions.
    pub(crate) fn contains(&self, root: NodeId, part: NodeId) -> bool {
        let mut seen = self.marks.borrow_mut();
        seen.begin(self.len());
        let mut open = vec![root];
        while let Some(id) = open.pop() {
            if id == part {
                return true;
            }
            // Operands stand before their operations: nothing below `part` can contain it.
            if id > part && seen.mark(id) {
                open.extend(self.node(id).operands());
            }
        }
        false
    }

    /// The symbols that `roots` are made of, in order, without following definitions.
    pub(crate) fn symbols_of(&self, roots: &[NodeId]) -> Vec<SymbolId> {
        let mut seen = self.marks.borrow_mut();
        seen.begin(self.len());
        let mut stack: Vec<NodeId> = roots.to_vec();
        let mut symbols = Vec::new();
        while let Some(id) = stack.pop() {
            if !seen.mark(id) {
                continue;
            }
            match self.node(id) {
                Node::Symbol(symbol) => symbols.push(symbol),
                node => {
                    for operand in node.operands() {
                        stack.push(operand);
                    }
                }
            }
        }
        symbols.sort_unstable();
        symbols
    }
}
