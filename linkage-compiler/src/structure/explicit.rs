//! Unknowns that become explicit expressions of others.

use linkage_symbolic::{Ex, SymbolId};

use crate::algebra::context::Algebra;
use crate::algebra::{Atom, Scalar, scalar};
use crate::structure::analysis::Analysis;
use crate::structure::equations;
use crate::structure::equations::{Coordinate, Equation};
use crate::structure::group::Explicit;

/// An angle relation solved for one angle.
pub(crate) fn solved_relation<'m>(
    algebra: &Algebra<'m>,
    equation: &Equation<'m>,
    angle: usize,
) -> Option<Scalar<'m>> {
    let relation = equation.relation.clone()?;
    let factor = relation.coefficient(Atom::Angle(angle));
    let own_symbols = algebra.names.angles[angle].symbols();
    let present = equations::symbols_of(algebra, &[relation.rest]);
    if factor == 0.0 || own_symbols.iter().any(|s| present.contains(s)) {
        return None;
    }
    let mut value = relation;
    value.terms.retain(|(atom, _)| *atom != Atom::Angle(angle));
    Some(value.scaled(-1.0 / factor))
}

/// Makes an angle an explicit expression of others.
pub(crate) fn replace_angle<'m>(analysis: &mut Analysis<'_, 'm>, angle: usize, value: &Scalar<'m>) {
    let [cos, sin] = scalar::direction(analysis.algebra, value).0;
    let number = scalar::value_of(analysis.algebra, value);
    let symbols = analysis.algebra.names.angles[angle].symbols();
    for (symbol, value) in symbols.into_iter().zip([cos, sin, number]) {
        make_explicit(analysis, symbol, value);
    }
}

pub(crate) fn make_explicit<'m>(analysis: &mut Analysis<'_, 'm>, symbol: SymbolId, value: Ex<'m>) {
    analysis.substitutions.insert(symbol, value);
    analysis.structure.explicit.push(Explicit { symbol, value });
}

/// Substitutes in an equation; if that changes it, it also answers for the eliminated loop and
/// unknowns.
pub(crate) fn substitute_in<'m>(
    analysis: &Analysis<'_, 'm>,
    equation: &mut Equation<'m>,
    eliminated: &Equation<'m>,
    gone: &[Coordinate],
) {
    let changed = equations::substituted(analysis, equation);
    if changed.rows != equation.rows {
        *equation = changed;
        equation.absorb(eliminated, gone);
    }
}
