//! A scalar loop with one unknown angle.

use linkage_symbolic::NodeId;
use linkage_symbolic::program::Unary;

use crate::algebra::{Solution, Term};

use super::{Closed, GapIn, Solver};

impl Solver<'_, '_> {
    /// `A cos + B sin = C`: with `R = sqrt(A^2 + B^2)` and `h = sqrt((R - C)(R + C))` the unit vector is
    /// `(A C - w B h, B C + w A h) / R^2`.
    pub(super) fn trigonometric(
        &mut self,
        angle: usize,
        a: NodeId,
        b: NodeId,
        known: NodeId,
    ) -> Closed {
        let w = self.mode_sign();
        let ([a, b, known], scale) = self.scaled([a, b, known]);
        let c = self.algebra.graph.neg(known);
        let r = self.algebra.length(&[a, b]);
        let q = self.difference_of_squares(r, c);
        let r2 = self.square([a, b]);
        let h = self.root(q, r2);
        let graph = &mut self.algebra.graph;
        let hw = graph.mul(w, h);
        let [along, across] = [c, hw].map(|x| graph.div(x, r2));
        let turned = self.perp([a, b]);
        let unit = self
            .combine(along, [a, b], across, turned)
            .map(|x| self.guarded(x, h));
        self.define_angle(angle, 1.0, unit, 0);

        let symbols = self.algebra.angles[angle].clone();
        let (cos, sin) = (symbols.cos_node, symbols.sin_node);
        let slope = self.algebra.cross([cos, sin], [a, b]);
        let graph = &mut self.algebra.graph;
        let determinant = graph.neg(hw);
        let determinant = self.alias("det", determinant, slope);
        let terms = vec![
            Term {
                coefficient: vec![a],
                factor: cos,
            },
            Term {
                coefficient: vec![b],
                factor: sin,
            },
            self.known_term(&[known]),
        ];
        let jacobian = vec![vec![determinant]];
        self.push_solution(Solution {
            terms,
            jacobian,
            determinant,
            elimination: None,
        });

        let size = self.abs(c);
        let miss = self.algebra.graph.sub(size, r);
        let miss = self.algebra.graph.div(miss, scale);
        let gap = self.gap(q, r2, miss);
        let graph = &mut self.algebra.graph;
        Closed {
            kind: "A cos x + B sin x = C".into(),
            class: 0,
            order: 0,
            method: "unit vector from the tangent to a circle",
            two_modes: true,
            margin: graph.div(h, r),
            slack: q,
            slack_scale: r2,
            gap,
            gap_in: GapIn::Loop,
        }
    }

    /// An equation between areas, times a power of two near 1 over its size: the squares of areas would leave the range of numbers early.
    fn scaled(&mut self, equation: [NodeId; 3]) -> ([NodeId; 3], NodeId) {
        let one = self.algebra.graph.one();
        if self.dimension.is_none_or(|d| d.half_lengths <= 2) {
            return (equation, one);
        }
        let size = self.algebra.length(&equation[..2]);
        let graph = &mut self.algebra.graph;
        let scale = graph.unary(Unary::InverseScale, size);
        (equation.map(|x| graph.mul(scale, x)), scale)
    }
}
