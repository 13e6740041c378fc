//! What closed forms in space share.

use linkage_symbolic::NodeId;

use crate::algebra::Term;

use super::Solver;

pub(super) type Space = [NodeId; 3];

impl Solver<'_, '_> {
    /// The terms `K.V - l l` of `(V.V - l^2)/2`, where `V` is the link's vector: what is known before the group enters by its
    /// derivative times these factors.
    pub(super) fn distance_terms(
        &mut self,
        link: Space,
        known: Space,
        length: NodeId,
    ) -> Vec<Term> {
        let minus = self.algebra.graph.neg(length);
        let components = known.into_iter().zip(link);
        let mut terms: Vec<Term> = components
            .map(|(known, link)| Term {
                coefficient: vec![known],
                factor: link,
            })
            .collect();
        terms.push(Term {
            coefficient: vec![length],
            factor: minus,
        });
        terms
    }

    /// `a u + b v`
    pub(super) fn combine_space(&mut self, a: NodeId, u: Space, b: NodeId, v: Space) -> Space {
        [0, 1, 2].map(|k| {
            let first = self.algebra.graph.mul(a, u[k]);
            let second = self.algebra.graph.mul(b, v[k]);
            self.algebra.graph.add(first, second)
        })
    }
}
