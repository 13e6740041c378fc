//! PRP and RPP: two slides along known directions, a linear group.

use linkage_symbolic::SymbolId;

use crate::algebra::Term;

use super::vector::Vector;
use super::{Closed, GapIn, Solver};

impl Solver<'_, '_> {
    /// `s1 G1 + s2 G2 = C` by Cramer's rule.
    pub(super) fn two_slides(
        &mut self,
        slides: [SymbolId; 2],
        guides: [Vector; 2],
        known: Vector,
    ) -> Closed {
        let c = self.negative(known);
        let determinant = self.algebra.cross(guides[0], guides[1]);
        let numerators = [
            self.algebra.cross(c, guides[1]),
            self.algebra.cross(guides[0], c),
        ];
        let mut terms = Vec::new();
        for position in 0..2 {
            let value = self.algebra.graph.div(numerators[position], determinant);
            self.define_length(slides[position], value, position);
            let factor = self.algebra.graph.symbol_node(slides[position]);
            terms.push(Term {
                coefficient: guides[position].to_vec(),
                factor,
            });
        }
        terms.push(self.known_term(&known));
        self.push_pair(terms, guides, determinant);

        let [first, second] = guides.map(|guide| self.length_and_unit(guide).0);
        let graph = &mut self.algebra.graph;
        let largest = graph.mul(first, second);
        let slack = graph.div(determinant, largest);
        let rigid = self.algebra.is_fixed(determinant);
        Closed {
            // Guides at a fixed angle to each other belong to one link: the slides are neighbours.
            kind: if rigid { "RPP" } else { "PRP" },
            class: 2,
            order: 2,
            method: "intersection of two lines",
            two_modes: false,
            margin: self.abs(slack),
            slack,
            gap: self.linear_gap(determinant),
            gap_in: GapIn::Loop,
        }
    }
}
