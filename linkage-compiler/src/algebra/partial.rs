//! Partial derivatives: by one unknown, rate or parameter, while all other unknowns and rates are held.

use std::collections::BTreeSet;

use linkage_symbolic::lookup::Map;

use linkage_symbolic::{Calculus, DerivativeMemo, Ex, Graph, Node, NodeId, SymbolId};

use super::acting::Acting;
use super::implicit::Implicit;
use super::{Algebra, Rule, Term};

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
#[derive(Clone, Debug, Default)]
pub(super) struct Partials {
    memo: DerivativeMemo,
    /// Symbols that stand for unknowns of groups as variables.
    unknowns: Map<(usize, usize), SymbolId>,
    mentioned: Map<SymbolId, BTreeSet<Solved>>,
    pub(super) acting: Acting,
}

struct Partial<'a, 'm>(&'a mut Algebra<'m>);

impl<'m> Calculus<'m> for Partial<'_, 'm> {
    fn graph(&self) -> &'m Graph {
        self.0.graph
    }

    fn memo(&mut self) -> &mut DerivativeMemo {
        &mut self.0.derivatives.partials.memo
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
    ) -> Ex<'m> {
        // A rate has a symbol of its own: if that is the variable, nobody asks here.
        match by.is_empty()
            && self.0.derivatives.partials.unknowns.get(&(group, position)) == Some(&variable)
        {
            true => self.0.one(),
            false => self.0.zero(),
        }
    }
}

impl<'m> Algebra<'m> {
    /// 0 plus or minus all derivatives of coefficients, which `slope` finds, times their factors.
    pub(super) fn sum_of_slopes(
        &mut self,
        terms: &[Term<'m>],
        row: usize,
        join: fn(Ex<'m>, Ex<'m>) -> Ex<'m>,
        slope: &mut dyn FnMut(&mut Self, Ex<'m>) -> Ex<'m>,
    ) -> Ex<'m> {
        let zero = self.zero();
        let mut products = Vec::new();
        let mut sum = zero;
        for term in terms {
            let slope = slope(self, term.coefficient[row]);
            sum = join(sum, slope * term.factor);
            if !slope.is_zero() {
                products.push((slope, term.factor));
            }
        }
        let gathered = gathered(&products);
        if gathered.len() == products.len() {
            return sum;
        }
        let gathered = gathered.into_iter();
        gathered.fold(zero, |sum, (slope, factor)| join(sum, slope * factor))
    }

    /// The derivative of an expression that mentions `variable`, a parameter or a symbol from [`Self::symbol_for`].
    pub(crate) fn partial(&mut self, x: Ex<'m>, variable: SymbolId) -> Ex<'m> {
        Partial(self).slope(x, variable)
    }

    /// The symbol that stands for an unknown or a rate as a variable.
    pub(super) fn symbol_for(&mut self, solved: &Solved) -> SymbolId {
        let System { group, by, .. } = &solved.system;
        if by.is_empty() {
            let graph = self.graph;
            let key = (*group, solved.position);
            let unknowns = &mut self.derivatives.partials.unknowns;
            return *unknowns
                .entry(key)
                .or_insert_with(|| graph.unknown(format!("unknown {key:?}")).0);
        }
        let rate = self.rates(*group, by.clone()).rates[solved.position];
        match rate.node() {
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

    /// The unknowns and rates that expressions mention.
    pub(super) fn mentioned_in(&mut self, all: &[Ex<'m>]) -> BTreeSet<Solved> {
        let nodes: Vec<NodeId> = all.iter().map(|x| x.id()).collect();
        let symbols = self.graph.symbols_of(&nodes);
        let behind = symbols.into_iter().map(|symbol| self.behind(symbol));
        behind.flatten().collect()
    }

    fn behind(&mut self, symbol: SymbolId) -> BTreeSet<Solved> {
        if let Some(known) = self.derivatives.partials.mentioned.get(&symbol) {
            return known.clone();
        }
        let result = |group, position, by| Solved {
            system: System::new(group, by),
            position,
        };
        let behind = match self.solutions.rule(symbol).cloned() {
            None => BTreeSet::new(),
            Some(Rule::Follow(equal)) => self.mentioned_in(&[equal]),
            Some(Rule::Turn(own)) => self.mentioned_in(&[own.equal]),
            Some(Rule::Seen(seen)) => {
                let mut behind = self.mentioned_in(&seen.vector.0);
                behind.extend(self.mentioned_in(&[seen.carrier.angle]));
                behind
            }
            Some(Rule::Shown(shown)) => {
                let [x, y] = shown.vector.0;
                let [base_x, base_y] = shown.base.0;
                self.mentioned_in(&[x, y, base_x, base_y, shown.carrier.angle])
            }
            Some(Rule::Axis(own)) => self.mentioned_in(&[own.0.angle]),
            Some(Rule::Turning(turning)) => {
                let mut behind = self.mentioned_in(&turning.z.0);
                behind.insert(result(turning.group, turning.position, Vec::new()));
                behind
            }
            Some(Rule::Cosine(rule) | Rule::Sine(rule) | Rule::Value(rule)) => {
                let angle = rule.carrier.map(|carrier| carrier.angle);
                let mut behind = angle.map_or_else(BTreeSet::new, |x| self.mentioned_in(&[x]));
                behind.insert(result(rule.group, rule.position, Vec::new()));
                behind
            }
            Some(Rule::Unknown { group, position }) => {
                BTreeSet::from([result(group, position, Vec::new())])
            }
            Some(Rule::Rate {
                group,
                position,
                by,
            }) => BTreeSet::from([result(group, position, by)]),
        };
        self.derivatives
            .partials
            .mentioned
            .insert(symbol, behind.clone());
        behind
    }
}

/// Products of slopes and factors, those of equal slopes put together: a centre that moves alone moves all differences from
/// it.
fn gathered<'m>(products: &[(Ex<'m>, Ex<'m>)]) -> Vec<(Ex<'m>, Ex<'m>)> {
    let mut gathered: Vec<(Ex, Ex)> = Vec::new();
    for &(slope, factor) in products {
        let opposite = -slope;
        let like = |(other, _): &&mut (Ex, Ex)| *other == slope || *other == opposite;
        match gathered.iter_mut().find(like) {
            Some((other, sum)) if *other == slope => *sum += factor,
            Some((_, sum)) => *sum -= factor,
            None => gathered.push((slope, factor)),
        }
    }
    gathered
}
