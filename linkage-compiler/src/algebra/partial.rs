//! Partial derivatives: by one unknown, rate or parameter, while all other unknowns and rates are held.

use crate::algebra::implicit;
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

/// 0 plus or minus all derivatives of coefficients, which `slope` finds, times their factors.
pub(super) fn sum_of_slopes<'m>(
    algebra: &mut Algebra<'m>,
    terms: &[Term<'m>],
    row: usize,
    join: fn(Ex<'m>, Ex<'m>) -> Ex<'m>,
    slope: &mut dyn FnMut(&mut Algebra<'m>, Ex<'m>) -> Ex<'m>,
) -> Ex<'m> {
    let zero = algebra.zero();
    let mut products = Vec::new();
    let mut sum = zero;
    for term in terms {
        let slope = slope(algebra, term.coefficient[row]);
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
pub(crate) fn partial<'m>(algebra: &mut Algebra<'m>, x: Ex<'m>, variable: SymbolId) -> Ex<'m> {
    Partial(algebra).slope(x, variable)
}

/// The symbol that stands for an unknown or a rate as a variable.
pub(super) fn symbol_for(algebra: &mut Algebra<'_>, solved: &Solved) -> SymbolId {
    let System { group, by, .. } = &solved.system;
    if by.is_empty() {
        let graph = algebra.graph;
        let key = (*group, solved.position);
        let unknowns = &mut algebra.derivatives.partials.unknowns;
        return *unknowns
            .entry(key)
            .or_insert_with(|| graph.unknown(format!("unknown {key:?}")).0);
    }
    let rate = implicit::rates(algebra, *group, by.clone()).rates[solved.position];
    match rate.node() {
        Node::Symbol(symbol) => symbol,
        _ => unreachable!("only rates that are symbols are mentioned"),
    }
}

/// The symbol that stands for an unknown of a group as a variable of [`Self::partial`].
pub(crate) fn unknown_variable(
    algebra: &mut Algebra<'_>,
    group: usize,
    position: usize,
) -> SymbolId {
    symbol_for(
        algebra,
        &Solved {
            system: System::new(group, Vec::new()),
            position,
        },
    )
}

/// The unknowns and rates that expressions mention.
pub(super) fn mentioned_in<'m>(algebra: &mut Algebra<'m>, all: &[Ex<'m>]) -> BTreeSet<Solved> {
    let nodes: Vec<NodeId> = all.iter().map(|x| x.id()).collect();
    let symbols = algebra.graph.symbols_of(&nodes);
    let behind = symbols.into_iter().map(|symbol| behind(algebra, symbol));
    behind.flatten().collect()
}

fn behind(algebra: &mut Algebra<'_>, symbol: SymbolId) -> BTreeSet<Solved> {
    if let Some(known) = algebra.derivatives.partials.mentioned.get(&symbol) {
        return known.clone();
    }
    let result = |group, position, by| Solved {
        system: System::new(group, by),
        position,
    };
    let behind = match algebra.solutions.rule(symbol).cloned() {
        None => BTreeSet::new(),
        Some(Rule::Follow(equal)) => mentioned_in(algebra, &[equal]),
        Some(Rule::Turn(own)) => mentioned_in(algebra, &[own.equal]),
        Some(Rule::Seen(seen)) => {
            let mut behind = mentioned_in(algebra, &seen.vector.0);
            behind.extend(mentioned_in(algebra, &[seen.carrier.angle]));
            behind
        }
        Some(Rule::Shown(shown)) => {
            let [x, y] = shown.vector.0;
            let [base_x, base_y] = shown.base.0;
            mentioned_in(algebra, &[x, y, base_x, base_y, shown.carrier.angle])
        }
        Some(Rule::Axis(own)) => mentioned_in(algebra, &[own.0.angle]),
        Some(Rule::Turning(turning)) => {
            let mut behind = mentioned_in(algebra, &turning.z.0);
            behind.insert(result(turning.group, turning.position, Vec::new()));
            behind
        }
        Some(Rule::Cosine(rule) | Rule::Sine(rule) | Rule::Value(rule)) => {
            let angle = rule.carrier.map(|carrier| carrier.angle);
            let mut behind = angle.map_or_else(BTreeSet::new, |x| mentioned_in(algebra, &[x]));
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
    algebra
        .derivatives
        .partials
        .mentioned
        .insert(symbol, behind.clone());
    behind
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
