//! A scalar loop that is quadratic in one unknown length.

use linkage_symbolic::{Ex, SymbolId};

use crate::algebra::Term;

use super::plane::{gap, known_term};
use super::{Closed, GapIn, Solver};

impl<'m> Solver<'_, 'm> {
    /// `a x^2 + 2 p x + c = 0`: `x = (w h - p)/a` or, where that would cancel, `c/(-p - w h)`, with `h = sqrt(p^2 - a c)`.
    pub(super) fn quadratic(
        &mut self,
        symbol: SymbolId,
        a: Ex<'m>,
        b: Ex<'m>,
        c: Ex<'m>,
    ) -> Closed<'m> {
        let w = self.mode_sign();
        let p = 0.5 * b;
        let (p2, ac) = (p.square(), a * c);
        let q = p2 - ac;
        let size = p2 + ac.abs();
        let h = q.root(size);
        let hw = w * h;
        let direct = (hw - p) / a;
        let inverse = c / -(p + hw);
        let same_sign = -(w * p);
        self.define_length(symbol, same_sign.select(direct, inverse), 0);

        let x = self.unknown(symbol);
        let x2 = x.square();
        let slope = 2.0 * (a * x + p);
        let determinant = self.alias("det", 2.0 * hw, slope);
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
        self.push_single(terms, determinant);

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
}
