//! A scalar loop that is quadratic in one unknown length.

use crate::solve::plane;
use linkage_symbolic::{Ex, SymbolId};

use crate::algebra::Term;

use super::plane::{gap, known_term};
use super::{Closed, GapIn, Solver};

/// `a x^2 + 2 p x + c = 0`: `x = (w h - p)/a` or, where that would cancel, `c/(-p - w h)`, with `h = sqrt(p^2 - a c)`.
pub(super) fn quadratic<'m>(
    solver: &mut Solver<'_, 'm>,
    symbol: SymbolId,
    a: Ex<'m>,
    b: Ex<'m>,
    c: Ex<'m>,
) -> Closed<'m> {
    let w = solver.mode_sign();
    let p = 0.5 * b;
    let (p2, ac) = (p.square(), a * c);
    let q = p2 - ac;
    let size = p2 + ac.abs();
    let h = q.root(size);
    let hw = w * h;
    let direct = (hw - p) / a;
    let inverse = c / -(p + hw);
    let same_sign = -(w * p);
    solver.define_length(symbol, same_sign.select(direct, inverse), 0);

    let x = solver.unknown(symbol);
    let x2 = x.square();
    let slope = 2.0 * (a * x + p);
    let determinant = solver.alias("det", 2.0 * hw, slope);
    let terms = vec![
        Term {
            coefficient: vec![a],
            factor: x2,
        },
        Term {
            coefficient: vec![b],
            factor: x,
        },
        known_term(&[c]),
    ];
    plane::push_single(solver, terms, determinant);

    let miss = (-q).sqrt() / a.abs();
    Closed {
        kind: "quadratic".into(),
        class: 0,
        order: 0,
        method: "quadratic equation, the root that does not cancel",
        two_modes: true,
        gap: gap(q, size, miss),
        margin: h / size.sqrt(),
        slack: q,
        slack_scale: size,
        gap_in: GapIn::Unknown,
    }
}
