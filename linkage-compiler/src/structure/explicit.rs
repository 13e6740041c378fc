//! Unknowns that become explicit expressions of others.

use linkage_symbolic::{Ex, Graph, SymbolId};

use crate::algebra::names::Names;
use crate::algebra::{Atom, Scalar, scalar};
use crate::structure::equations;
use crate::structure::equations::{Coordinate, Equation};
use crate::structure::group::Explicit;
use crate::structure::reductions::{Reductions, Substitutions};

/// An angle relation solved for one angle.
pub(crate) fn solved_relation<'m>(
    names: &Names<'m>,
    equation: &Equation<'m>,
    angle: usize,
) -> Option<Scalar<'m>> {
    let relation = equation.relation.clone()?;
    let factor = relation.coefficient(Atom::Angle(angle));
    let own_symbols = names.angles[angle].symbols();
    let present = equations::symbols_of(names.graph, &[relation.rest]);
    if factor == 0.0 || own_symbols.iter().any(|s| present.contains(s)) {
        return None;
    }
    let mut value = relation;
    value.terms.retain(|(atom, _)| *atom != Atom::Angle(angle));
    Some(value.scaled(-1.0 / factor))
}

/// Makes an angle an explicit expression of others.
pub(crate) fn replace_angle<'m>(
    names: &mut Names<'m>,
    reductions: &mut Reductions<'m>,
    angle: usize,
    value: &Scalar<'m>,
) {
    for (symbol, value) in replacements_of_angle(names, angle, value) {
        make_explicit(reductions, symbol, value);
    }
}

/// Returns the symbols of an angle that is given by others, with the expressions that replace them.
pub(crate) fn replacements_of_angle<'m>(
    names: &mut Names<'m>,
    angle: usize,
    value: &Scalar<'m>,
) -> [(SymbolId, Ex<'m>); 3] {
    let [cos, sin] = scalar::direction(names, value).0;
    let number = scalar::value_of(names, value);
    let symbols = names.angles[angle].symbols();
    [0, 1, 2].map(|k| (symbols[k], [cos, sin, number][k]))
}

/// Makes an unknown an explicit expression of others.
pub(crate) fn make_explicit<'m>(reductions: &mut Reductions<'m>, symbol: SymbolId, value: Ex<'m>) {
    reductions.substitutions.insert(symbol, value);
    reductions.explicit.push(Explicit { symbol, value });
}

/// Substitutes in an equation; if that changes it, it also answers for the eliminated loop and
/// unknowns.
pub(crate) fn substitute_in<'m>(
    graph: &'m Graph,
    substitutions: &Substitutions<'m>,
    equation: &mut Equation<'m>,
    eliminated: &Equation<'m>,
    gone: &[Coordinate],
) {
    let changed = equations::substituted(graph, substitutions, equation);
    if changed.rows != equation.rows {
        *equation = changed;
        equation.absorb(eliminated, gone);
    }
}
