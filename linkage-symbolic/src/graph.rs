//! The arena: nodes, symbols, hash-consing.

use std::collections::{HashMap, HashSet};

use crate::program::{Binary, Source, Ternary, Unary};

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
    Constant(u64),
    Symbol(SymbolId),
    Unary(Unary, NodeId),
    Binary(Binary, NodeId, NodeId),
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

/// A flat arena of operations. Equal operations are one node.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    nodes: Vec<Node>,
    bindings: Vec<Binding>,
    index: HashMap<Node, NodeId>,
    symbols: Vec<Symbol>,
    sources: HashMap<Source, SymbolId>,
    /// The cosine that a sine belongs to.
    cosines: HashMap<SymbolId, SymbolId>,
    with_sine: HashSet<SymbolId>,
}

impl Graph {
    /// An empty graph.
    pub fn new() -> Self {
        Self::default()
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// True if it has no node.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// The operation of a node.
    pub fn node(&self, id: NodeId) -> Node {
        self.nodes[id.index()]
    }

    /// When a node's value is known.
    pub fn binding(&self, id: NodeId) -> Binding {
        self.bindings[id.index()]
    }

    /// The value of a constant node.
    pub fn constant_value(&self, id: NodeId) -> Option<f64> {
        match self.node(id) {
            Node::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    /// A symbol's record.
    pub fn symbol(&self, id: SymbolId) -> &Symbol {
        &self.symbols[id.index()]
    }

    /// The node of the symbol that a program loads from `source`; one symbol for each source.
    pub fn source(&mut self, source: Source) -> NodeId {
        if let Some(&symbol) = self.sources.get(&source) {
            return self.intern(Node::Symbol(symbol));
        }
        let binding = match source {
            Source::Input(_) | Source::State(..) | Source::Limit => Binding::Call,
            _ => Binding::Parameter,
        };
        let symbol = self.add_symbol(Symbol {
            name: format!("{source:?}"),
            source: Some(source),
            definition: None,
            binding,
        });
        self.sources.insert(source, symbol);
        self.intern(Node::Symbol(symbol))
    }

    /// The symbol that is loaded from `source`, if the graph has one.
    pub fn find_source(&self, source: Source) -> Option<SymbolId> {
        self.sources.get(&source).copied()
    }

    /// A fresh symbol that lives by a definition given now or later.
    pub fn unknown(&mut self, name: impl Into<String>) -> (SymbolId, NodeId) {
        let symbol = self.add_symbol(Symbol {
            name: name.into(),
            source: None,
            definition: None,
            binding: Binding::Call,
        });
        (symbol, self.intern(Node::Symbol(symbol)))
    }

    /// Says that two symbols are the cosine and the sine of one angle.
    pub fn pair(&mut self, cos: SymbolId, sin: SymbolId) {
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

    /// The node of a symbol.
    pub fn symbol_node(&mut self, symbol: SymbolId) -> NodeId {
        self.intern(Node::Symbol(symbol))
    }

    /// How many symbols there are.
    pub fn symbol_count(&self) -> usize {
        self.symbols.len()
    }

    /// The symbols made since there were `count`.
    pub fn symbols_since(&self, count: usize) -> impl Iterator<Item = SymbolId> + use<> {
        (count as u32..self.symbols.len() as u32).map(SymbolId)
    }

    /// Says what a symbol stands for.
    pub fn define(&mut self, symbol: SymbolId, definition: NodeId) {
        self.symbols[symbol.index()].definition = Some(definition);
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
            _ => node
                .operands()
                .map(|o| self.binding(o))
                .max()
                .unwrap_or(Binding::Constant),
        };
        let id = NodeId(self.nodes.len() as u32);
        self.nodes.push(node);
        self.bindings.push(binding);
        self.index.insert(node, id);
        id
    }

    /// All nodes that `roots` are made of, roots included, children first, without following definitions.
    pub fn reachable(&self, roots: &[NodeId]) -> Vec<NodeId> {
        let mut seen = vec![false; self.len()];
        let mut stack: Vec<NodeId> = roots.to_vec();
        let mut found = Vec::new();
        while let Some(id) = stack.pop() {
            if std::mem::replace(&mut seen[id.index()], true) {
                continue;
            }
            found.push(id);
            stack.extend(self.node(id).operands());
        }
        found.sort_unstable();
        found
    }

    /// True if `root` is `part` or computed from it, without following definitions.
    pub fn contains(&self, root: NodeId, part: NodeId) -> bool {
        let mut seen = HashSet::new();
        let mut open = vec![root];
        while let Some(id) = open.pop() {
            if id == part {
                return true;
            }
            // Operands stand before their operations: nothing below `part` can contain it.
            if id > part && seen.insert(id) {
                open.extend(self.node(id).operands());
            }
        }
        false
    }

    /// The symbols that `roots` are made of, in order, without following definitions.
    pub fn symbols_of(&self, roots: &[NodeId]) -> Vec<SymbolId> {
        let mut symbols: Vec<SymbolId> = self
            .reachable(roots)
            .into_iter()
            .filter_map(|id| match self.node(id) {
                Node::Symbol(symbol) => Some(symbol),
                _ => None,
            })
            .collect();
        symbols.sort_unstable();
        symbols
    }
}
