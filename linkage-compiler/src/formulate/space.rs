//! What closed forms in space share.

use linkage_symbolic::program::{Binary, Unary};
use linkage_symbolic::{Node, NodeId};

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

    /// `e . v`. What is prepared of it, and what each further term is multiplied by, is put together beforehand: with a crank in `v` and a
    /// fixed `e`, two multiply-adds remain.
    pub(super) fn projection(&mut self, e: Space, v: Space) -> NodeId {
        if !e.iter().all(|&x| self.algebra.is_fixed(x)) {
            return self.algebra.dot(&e, &v);
        }
        let parts = v.map(|x| self.early_and_late(x));
        let early = parts.map(|(early, _)| early);
        let late = parts.map(|(_, late)| late);
        let start = self.algebra.dot(&e, &early);
        e.into_iter().zip(late).fold(start, |sum, (e, late)| {
            let product = self.algebra.graph.mul(e, late);
            self.algebra.graph.add(sum, product)
        })
    }

    /// A sum in two parts: what is known before a call, and the rest.
    fn early_and_late(&mut self, sum: NodeId) -> (NodeId, NodeId) {
        let zero = self.algebra.graph.zero();
        if self.algebra.is_fixed(sum) {
            return (sum, zero);
        }
        let (op, a, b) = match self.algebra.graph.node(sum) {
            Node::Binary(op @ (Binary::Add | Binary::Sub), a, b) => (op, a, b),
            Node::Unary(Unary::Neg, a) => (Binary::Sub, zero, a),
            _ => return (zero, sum),
        };
        let (a, b) = (self.early_and_late(a), self.early_and_late(b));
        let graph = &mut self.algebra.graph;
        (graph.binary(op, a.0, b.0), graph.binary(op, a.1, b.1))
    }
}
