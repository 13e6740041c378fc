//! Partial derivatives: by one unknown, rate or parameter, while all other unknowns and rates are held.

use std::collections::{BTreeSet, HashMap};

use linkage_symbolic::{Calculus, DerivativeMemo, Graph, Node, NodeId, SymbolId, differentiate};

use super::Algebra;
use super::implicit::{AngleRule, Implicit, Rule, Term};

/// What is solved together: a group's unknowns, or their derivatives by some variables. In the order in which they
/// depend on each other: a system mentions its own results and those of smaller ones.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct System {
    pub(super) group: usize,
    pub(super) order: usize,
    /// In order; empty for the unknowns themselves.
    pub(super) by: Vec<SymbolId>,
}

impl System {
    pub(super) fn new(group: usize, by: Vec<SymbolId>) -> Self {
        Self {
            group,
            order: by.len(),
            by,
        }
    }
}

/// One result of a system.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Solved {
    pub(super) system: System,
    pub(super) position: usize,
}

/// What is known of partial derivatives.
#[derive(Debug, Default)]
pub(super) struct Partials {
    memo: DerivativeMemo,
    /// Symbols that stand for unknowns of groups as variables.
    unknowns: HashMap<(usize, usize), SymbolId>,
    mentioned: HashMap<SymbolId, BTreeSet<Solved>>,
}

struct Partial<'a, 'm>(&'a mut Algebra<'m>);

impl<'m> Calculus<'m> for Partial<'_, 'm> {
    fn graph(&self) -> &'m Graph {
        self.0.graph
    }

    fn memo(&mut self) -> &mut DerivativeMemo {
        &mut self.0.partials.memo
    }

    fn symbol_derivative(&mut self, symbol: SymbolId, variable: SymbolId) -> NodeId {
        self.derivative_by_rule(symbol, variable)
    }
}

impl<'m> Implicit<'m> for Partial<'_, 'm> {
    fn algebra(&mut self) -> &mut Algebra<'m> {
        self.0
    }

    fn rate(
        &mut self,
        group: usize,
        position: usize,
        by: Vec<SymbolId>,
        variable: SymbolId,
    ) -> NodeId {
        // A rate has a symbol of its own: if that is the variable, nobody asks here.
        match by.is_empty() && self.0.partials.unknowns.get(&(group, position)) == Some(&variable) {
            true => self.0.graph.one(),
            false => self.0.graph.zero(),
        }
    }
}

impl Algebra<'_> {
    /// 0 plus or minus all derivatives of coefficients, which `slope` finds, times their factors.
    pub(super) fn sum_of_slopes(
        &mut self,
        terms: &[Term],
        row: usize,
        join: fn(&Graph, NodeId, NodeId) -> NodeId,
        slope: &mut dyn FnMut(&mut Self, NodeId) -> NodeId,
    ) -> NodeId {
        let zero = self.graph.zero();
        let mut products = Vec::new();
        let mut sum = zero;
        for term in terms {
            let slope = slope(self, term.coefficient[row]);
            let product = self.graph.mul(slope, term.factor);
            sum = join(&mut self.graph, sum, product);
            if !self.graph.is_zero(slope) {
                products.push((slope, term.factor));
            }
        }
        let gathered = self.gathered(&products);
        if gathered.len() == products.len() {
            return sum;
        }
        gathered.into_iter().fold(zero, |sum, (slope, factor)| {
            let product = self.graph.mul(slope, factor);
            join(&mut self.graph, sum, product)
        })
    }

    /// Products of slopes and factors, those of equal slopes put together: a centre that moves alone moves all differences from
    /// it.
    fn gathered(&mut self, products: &[(NodeId, NodeId)]) -> Vec<(NodeId, NodeId)> {
        let mut gathered: Vec<(NodeId, NodeId)> = Vec::new();
        for &(slope, factor) in products {
            let opposite = self.graph.neg(slope);
            let like = |(other, _): &&mut (NodeId, NodeId)| *other == slope || *other == opposite;
            match gathered.iter_mut().find(like) {
                Some((other, sum)) if *other == slope => *sum = self.graph.add(*sum, factor),
                Some((_, sum)) => *sum = self.graph.sub(*sum, factor),
                None => gathered.push((slope, factor)),
            }
        }
        gathered
    }

    /// The derivative of a node that mentions `variable`, a parameter or a symbol from [`Self::symbol_for`].
    pub(crate) fn partial(&mut self, node: NodeId, variable: SymbolId) -> NodeId {
        differentiate(&mut Partial(self), node, variable)
    }

    /// The symbol that stands for an unknown or a rate as a variable.
    pub(super) fn symbol_for(&mut self, solved: &Solved) -> SymbolId {
        let System { group, by, .. } = &solved.system;
        if by.is_empty() {
            let graph = &mut self.graph;
            let key = (*group, solved.position);
            let unknowns = &mut self.partials.unknowns;
            return *unknowns
                .entry(key)
                .or_insert_with(|| graph.unknown(format!("unknown {key:?}")).0);
        }
        let node = self.rates(*group, by.clone()).rates[solved.position];
        match self.graph.node(node) {
            Node::Symbol(symbol) => symbol,
            _ => unreachable!("only rates that are symbols are mentioned"),
        }
    }

    /// The symbol that stands for an unknown of a group as a variable of [`Self::partial`].
    pub(crate) fn unknown_variable(&mut self, group: usize, position: usize) -> SymbolId {
        self.symbol_for(&Solved {
            system: System::new(group, Vec::new()),
            position,
        })
    }

    /// The unknowns and rates that nodes mention.
    pub(super) fn mentioned_in(&mut self, nodes: &[NodeId]) -> BTreeSet<Solved> {
        let symbols = self.graph.symbols_of(nodes);
        let behind = symbols.into_iter().map(|symbol| self.behind(symbol));
        behind.flatten().collect()
    }

    fn behind(&mut self, symbol: SymbolId) -> BTreeSet<Solved> {
        if let Some(known) = self.partials.mentioned.get(&symbol) {
            return known.clone();
        }
        let result = |group, position, by| Solved {
            system: System::new(group, by),
            position,
        };
        let behind = match self.rules.get(&symbol).cloned() {
            None => BTreeSet::new(),
            Some(Rule::Follow(node)) => self.mentioned_in(&[node]),
            Some(Rule::Turning(turning)) => {
                let mut behind = self.mentioned_in(&turning.z);
                behind.insert(result(turning.group, turning.position, Vec::new()));
                behind
            }
            Some(
                Rule::Cosine(AngleRule {
                    group, position, ..
                })
                | Rule::Sine(AngleRule {
                    group, position, ..
                })
                | Rule::Value(AngleRule {
                    group, position, ..
                })
                | Rule::Unknown { group, position },
            ) => BTreeSet::from([result(group, position, Vec::new())]),
            Some(Rule::Rate {
                group,
                position,
                by,
            }) => BTreeSet::from([result(group, position, by)]),
        };
        self.partials.mentioned.insert(symbol, behind.clone());
        behind
    }
}
