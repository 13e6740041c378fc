//! RRP and PRR: a link of given length between a known point and a slider on a known line.

use linkage_symbolic::SymbolId;

use crate::algebra::Term;
use crate::structure::Rotor;

use super::vector::Vector;
use super::{Closed, GapIn, Solver};

impl Solver<'_, '_> {
    /// `Z u + s G = C`: the distance of the point from the line is `X = g x C`, the link reaches `h = sqrt((r - X)(r + X))`
    /// along it. The link's vector is `w h g + X g_perp`, never the difference `C - s G`.
    pub(super) fn rotor_and_slide(
        &mut self,
        rotor: &Rotor,
        slide: SymbolId,
        guide: Vector,
        known: Vector,
    ) -> Closed {
        let c = self.negative(known);
        let r = self.algebra.length(&rotor.z);
        let (stretch, g) = self.algebra.length_and_unit(guide);
        let w = self.mode_sign();

        let x = self.algebra.cross(g, c);
        let along = self.algebra.dot(&g, &c);
        let q = self.difference_of_squares(r, x);
        // Rounding in `X` is that of `|C|`, which near the dead point, where `|X| = r`, is less than this sum.
        let reach = self.abs(along);
        let graph = &mut self.algebra.graph;
        let far = graph.mul(r, reach);
        let near = graph.square(r);
        let noise = graph.add(far, near);
        let h = self.root(q, noise);
        let hw = self.algebra.graph.mul(w, h);
        let across = self.perp(g);
        let value = self.combine(hw, g, x, across);
        let graph = &mut self.algebra.graph;
        let position = graph.sub(along, hw);
        let position = graph.div(position, stretch);
        let determinant = graph.mul(stretch, hw);
        let determinant = graph.neg(determinant);

        let unit = self.unit_of(rotor);
        let vector = value.map(|x| self.guarded(x, h));
        let vector = self.turning(vector, rotor.z, unit, 0);
        let quotient = self.complex_quotient(vector, rotor.z);
        self.define_angle(rotor.angle, rotor.sense, quotient, 0);
        self.define_length(slide, position, 1);

        let mut terms = self.rotor_terms(rotor.z, unit);
        let slide_node = self.algebra.graph.symbol_node(slide);
        terms.push(Term {
            coefficient: guide.to_vec(),
            factor: slide_node,
        });
        terms.push(self.known_term(&known));
        let turning = self.perp(vector);
        self.push_pair(terms, [turning, guide], determinant);

        let off = self.abs(x);
        let miss = self.algebra.graph.sub(off, r);
        let gap = self.gap(q, noise, miss);
        let graph = &mut self.algebra.graph;
        let largest2 = graph.square(r);
        Closed {
            kind: "RRP".into(),
            class: 2,
            order: 2,
            method: "intersection of a circle and a line, by the distance from the line",
            two_modes: true,
            margin: graph.div(h, r),
            slack: graph.div(q, largest2),
            slack_scale: graph.one(),
            gap,
            gap_in: GapIn::Loop,
        }
    }
}
