//! PRP and RPP: two slides along known directions, a linear group.

use linkage_symbolic::program::Binary;
use linkage_symbolic::{NodeId, SymbolId};

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

        let largest = self.largest_determinant(guides);
        let graph = &mut self.algebra.graph;
        let slack = graph.div(determinant, largest);
        let rigid = self.algebra.is_fixed(determinant);
        Closed {
            // Guides at a fixed angle to each other belong to one link: the slides are neighbours.
            kind: if rigid { "RPP" } else { "PRP" }.into(),
            class: 2,
            order: 2,
            method: "intersection of two lines",
            two_modes: false,
            margin: self.abs(slack),
            slack,
            slack_scale: self.algebra.graph.one(),
            gap: self.linear_gap(determinant),
            gap_in: GapIn::Loop,
        }
    }

    /// The determinant's largest value: 1 for guides along directions, and for lines given by unit normals.
    fn largest_determinant(&mut self, guides: [Vector; 2]) -> NodeId {
        let [along, across] = [guides, [0, 1].map(|k| [guides[0][k], guides[1][k]])].map(|pair| {
            let [first, second] = pair.map(|v| self.algebra.length_and_unit(v).0);
            self.algebra.graph.mul(first, second)
        });
        let one = self.algebra.graph.one();
        match along == one || across == one {
            true => one,
            false => self.algebra.graph.binary(Binary::Max, along, across),
        }
    }
}
