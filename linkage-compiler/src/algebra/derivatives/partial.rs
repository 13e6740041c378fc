//! Partial derivatives: by one unknown, rate or parameter, while all other unknowns and rates are
//! held.

use linkage_symbolic::{Calculus, DerivativeMemo, Ex, Graph, Node, NodeId, SymbolId};

use crate::algebra::context::Algebra;
use crate::algebra::derivatives::by_rule::{GroupRates, RuleCalculus};
use crate::algebra::equations::Term;
use crate::algebra::systems::{Solved, System};

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

impl<'m> RuleCalculus<'m> for Partial<'_, 'm> {
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

/// `zero` plus or minus all derivatives of coefficients, which `slope` finds, times their factors.
pub(crate) fn sum_of_slopes<'m>(
    zero: Ex<'m>,
    terms: &[Term<'m>],
    row: usize,
    join: fn(Ex<'m>, Ex<'m>) -> Ex<'m>,
    slope: &mut dyn FnMut(Ex<'m>) -> Ex<'m>,
) -> Ex<'m> {
    let mut products = Vec::new();
    let mut sum = zero;
    for term in terms {
        let slope = slope(term.coefficient[row]);
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

/// The derivative of an expression that mentions `variable`, a parameter or a symbol from
/// [`symbol_for`].
pub(crate) fn partial<'m>(algebra: &mut Algebra<'m>, x: Ex<'m>, variable: SymbolId) -> Ex<'m> {
    Partial(algebra).slope(x, variable)
}

/// The symbol that stands for an unknown or a rate as a variable.
pub(crate) fn symbol_for(algebra: &mut Algebra<'_>, solved: &Solved) -> SymbolId {
    let System { group, by, .. } = &solved.system;
    if by.is_empty() {
        let graph = algebra.graph;
        let key = (*group, solved.position);
        let unknowns = &mut algebra.derivatives.partials.unknowns;
        return *unknowns
            .entry(key)
            .or_insert_with(|| graph.unknown(format!("unknown {key:?}")).0);
    }
    let rate = algebra.rates(*group, by.clone()).rates[solved.position];
    match rate.node() {
        Node::Symbol(symbol) => symbol,
        _ => unreachable!("only rates that are symbols are mentioned"),
    }
}

/// The symbol that stands for an unknown of a group as a variable of [`partial`].
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

/// Products of slopes and factors, those of equal slopes put together: a centre that moves alone
/// moves all differences from it.
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
