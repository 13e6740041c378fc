//! Scalar loops that need no root: linear equations and angle relations.

use linkage_symbolic::{Ex, SymbolId};

use crate::algebra::{Algebra, Scalar, Term, scalar};
use crate::solve::closed::{ClosedForm, GapIn};
use crate::solve::group_context::GroupContext;
use crate::solve::{definitions, plane, unknowns};

use super::plane::{known_term, linear_gap, where_finite};

/// `a x + b = 0`
pub(super) fn linear<'m>(
    algebra: &mut Algebra<'m>,
    group: &GroupContext<'_, 'm>,
    symbol: SymbolId,
    a: Ex<'m>,
    b: Ex<'m>,
) -> ClosedForm<'m> {
    definitions::define_length(algebra, group, symbol, -(b / a), 0);
    let terms = vec![
        Term {
            coefficient: vec![a],
            factor: unknowns::unknown(algebra, symbol),
        },
        known_term(&[b]),
    ];
    plane::push_single(algebra, terms, a);

    // The factor's largest value is not known; a direction's component reaches 1.
    let one = algebra.one();
    let size = a.abs();
    let (margin, slack, slack_scale) = if a.is_fixed() {
        (one, one, one)
    } else {
        (size.min(one), a, size)
    };
    ClosedForm {
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
    algebra: &mut Algebra<'m>,
    angle: usize,
    value: &Scalar<'m>,
) -> ClosedForm<'m> {
    let [cos, sin] = scalar::direction(&mut algebra.names, value).0;
    let number = scalar::value_of(&algebra.names, value);
    definitions::define_relation(algebra, angle, [cos, sin, number]);
    let one = algebra.one();
    plane::push_single(algebra, Vec::new(), one);
    ClosedForm {
        kind: "angle relation".into(),
        class: 0,
        order: 0,
        method: "sum of angles",
        two_modes: false,
        margin: one,
        slack: where_finite(one, &[value.rest]),
        slack_scale: one,
        gap: where_finite(algebra.zero(), &[value.rest]),
        gap_in: GapIn::Loop,
    }
}
