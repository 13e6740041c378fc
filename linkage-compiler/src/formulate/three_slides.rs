//! Three slides in space: a linear system.

use linkage_symbolic::{NodeId, SymbolId};

use crate::algebra::{CoreRow, Elimination, Solution, Term};

use super::space::Space;
use super::{Closed, GapIn, Solver};

impl Solver<'_, '_> {
    /// `s1 G1 + s2 G2 + s3 G3 + K = 0` by triple products.
    pub(super) fn three_slides(
        &mut self,
        slides: [SymbolId; 3],
        guides: [Space; 3],
        known: Space,
    ) -> Closed {
        let one = self.algebra.graph.one();
        let [a, b, c] = guides;
        let product = self.algebra.cross3(b, c);
        let determinant = self.algebra.dot(&a, &product);
        let crosses = [
            product,
            self.algebra.cross3(c, a),
            self.algebra.cross3(a, b),
        ];
        for (position, (slide, cross)) in slides.into_iter().zip(crosses).enumerate() {
            let above = self.algebra.dot(&cross, &known);
            let quotient = self.algebra.graph.div(above, determinant);
            let value = self.algebra.graph.neg(quotient);
            self.define_length(slide, value, position);
        }
        let mut terms: Vec<Term> = slides
            .into_iter()
            .zip(guides)
            .map(|(slide, guide)| Term {
                coefficient: guide.to_vec(),
                factor: self.algebra.graph.symbol_node(slide),
            })
            .collect();
        terms.push(self.known_term(&known));
        let rows = (0..3).map(|first| CoreRow {
            first,
            factors: vec![one],
        });
        let elimination = Elimination {
            rows: rows.collect(),
            matrix: (0..3).map(|row| guides.map(|g| g[row]).to_vec()).collect(),
            units: vec![one; 3],
            privates: Vec::new(),
        };
        self.push_solution(Solution {
            terms,
            jacobian: guides.map(|guide| guide.to_vec()).to_vec(),
            determinant,
            elimination: Some(elimination),
        });

        let largest: NodeId = guides.into_iter().fold(one, |product, guide| {
            let (length, _) = self.algebra.length_and_unit(guide);
            self.algebra.graph.mul(product, length)
        });
        let slack = self.algebra.graph.div(determinant, largest);
        let margin = self.abs(slack);
        Closed {
            kind: "PPP".into(),
            class: 0,
            order: 0,
            method: "three linear equations",
            two_modes: false,
            margin,
            slack,
            slack_scale: one,
            gap: self.linear_gap(determinant),
            gap_in: GapIn::Loop,
        }
    }
}
