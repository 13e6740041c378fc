//! A scalar loop that is quadratic in one unknown length.

use linkage_symbolic::program::Ternary;
use linkage_symbolic::{NodeId, SymbolId};

use crate::algebra::{Solution, Term};

use super::{Closed, GapIn, Solver};

impl Solver<'_, '_> {
    /// `a x^2 + 2 p x + c = 0`: `x = (w h - p)/a` or, where that would cancel, `c/(-p - w h)`, with `h = sqrt(p^2 - a c)`.
    pub(super) fn quadratic(
        &mut self,
        symbol: SymbolId,
        a: NodeId,
        b: NodeId,
        c: NodeId,
    ) -> Closed {
        let w = self.mode_sign();
        let p = self.half(b);
        let graph = &mut self.algebra.graph;
        let p2 = graph.square(p);
        let ac = graph.mul(a, c);
        let q = graph.sub(p2, ac);
        let ac_size = self.abs(ac);
        let size = self.algebra.graph.add(p2, ac_size);
        let h = self.root(q, size);
        let graph = &mut self.algebra.graph;
        let hw = graph.mul(w, h);
        let outer = graph.sub(hw, p);
        let direct = graph.div(outer, a);
        let sum = graph.add(p, hw);
        let inner = graph.neg(sum);
        let inverse = graph.div(c, inner);
        let signed = graph.mul(w, p);
        let same_sign = graph.neg(signed);
        let value = graph.ternary(Ternary::Select, same_sign, direct, inverse);
        self.define_length(symbol, value, 0);

        let graph = &mut self.algebra.graph;
        let x = graph.symbol_node(symbol);
        let x2 = graph.square(x);
        let ax = graph.mul(a, x);
        let slope = graph.add(ax, p);
        let two = graph.constant(2.0);
        let slope = graph.mul(two, slope);
        let determinant = graph.mul(two, hw);
        let determinant = self.alias("det", determinant, slope);
        let terms = vec![
            Term {
                coefficient: vec![a],
                factor: x2,
            },
            Term {
                coefficient: vec![b],
                factor: x,
            },
            self.known_term(&[c]),
        ];
        let jacobian = vec![vec![determinant]];
        self.push_solution(Solution {
            terms,
            jacobian,
            determinant,
            elimination: None,
        });

        let graph = &mut self.algebra.graph;
        let lack = graph.neg(q);
        let miss = graph.sqrt(lack);
        let a_size = self.abs(a);
        let miss = self.algebra.graph.div(miss, a_size);
        let gap = self.gap(q, size, miss);
        let graph = &mut self.algebra.graph;
        let largest = graph.sqrt(size);
        Closed {
            kind: "quadratic".into(),
            class: 0,
            order: 0,
            method: "quadratic equation, the root that does not cancel",
            two_modes: true,
            margin: graph.div(h, largest),
            slack: q,
            slack_scale: size,
            gap,
            gap_in: GapIn::Unknown,
        }
    }
}
