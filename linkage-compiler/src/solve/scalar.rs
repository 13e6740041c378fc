//! Scalar loops that need no root: linear equations and angle relations.

use crate::algebra::scalar;
use crate::solve::plane;
use linkage_symbolic::{Ex, SymbolId};

use crate::algebra::{Scalar, Term};

use super::plane::{known_term, linear_gap, where_finite};
use super::{Closed, GapIn, Solver};

/// `a x + b = 0`
pub(super) fn linear<'m>(
    solver: &mut Solver<'_, 'm>,
    symbol: SymbolId,
    a: Ex<'m>,
    b: Ex<'m>,
) -> Closed<'m> {
    solver.define_length(symbol, -(b / a), 0);
    let terms = vec![
        Term {
            coefficient: vec![a],
            factor: solver.unknown(symbol),
        },
        known_term(&[b]),
    ];
    plane::push_single(solver, terms, a);

    // The factor's largest value is not known; a direction's component reaches 1.
    let one = solver.algebra.one();
    let size = a.abs();
    let (margin, slack, slack_scale) = match a.is_fixed() {
        true => (one, one, one),
        false => (size.min(one), a, size),
    };
    Closed {
        kind: "linear".into(),
        class: 0,
        order: 0,
        method: "linear equation",
        two_modes: false,
        margin,
        slack: where_finite(slack, &[b]),
        slack_scale,
        gap: where_finite(linear_gap(a), &[b]),
        gap_in: GapIn::Loop,
    }
}

/// An angle given by others.
pub(super) fn relation<'m>(
    solver: &mut Solver<'_, 'm>,
    angle: usize,
    value: &Scalar<'m>,
) -> Closed<'m> {
    let [cos, sin] = scalar::direction(solver.algebra, value).0;
    let number = scalar::value_of(solver.algebra, value);
    solver.define_relation(angle, [cos, sin, number]);
    let one = solver.algebra.one();
    plane::push_single(solver, Vec::new(), one);
    Closed {
        kind: "angle relation".into(),
        class: 0,
        order: 0,
        method: "sum of angles",
        two_modes: false,
        margin: one,
        slack: where_finite(one, &[value.rest]),
        slack_scale: one,
        gap: where_finite(solver.algebra.zero(), &[value.rest]),
        gap_in: GapIn::Loop,
    }
}
