//! Nodes of a graph as expressions and vectors to compute with.

use super::any_vector::Vn;
use super::ex::Ex;
use super::substitute::substitute;
use super::vector::{V3, Vector};
use crate::graph::{Graph, NodeId, SymbolId, Vectors};
use crate::lookup::Map;

impl Graph {
    /// A node as an expression to compute with.
    pub fn ex(&self, id: NodeId) -> Ex<'_> {
        Ex::new(self, id)
    }

    /// A number as an expression.
    pub fn number(&self, value: f64) -> Ex<'_> {
        self.ex(self.constant(value))
    }

    /// Nodes as a vector to compute with.
    pub fn vector<const N: usize>(&self, ids: [NodeId; N]) -> Vector<'_, N> {
        Vector(ids.map(|id| self.ex(id)))
    }

    /// Nodes as a vector to compute with.
    ///
    /// # Panics
    ///
    /// Panics if there are more than three.
    pub fn components(&self, ids: &[NodeId]) -> Vn<'_> {
        Vn::new(self, ids)
    }

    /// A vector of so many zeros.
    pub fn zeros(&self, count: usize) -> Vn<'_> {
        self.components(&vec![self.zero(); count])
    }

    /// The vectors in space that a node is known to be the scalar product of.
    pub fn factors_of_product(&self, product: NodeId) -> Option<[V3<'_>; 2]> {
        let factors = self.store().vectors.products.get(&product).cloned()?;
        let factor = |first: usize| Vector([0, 1, 2].map(|k| self.ex(factors[first + k])));
        Some([0, 3].map(factor))
    }

    /// Lengths and products in `roots` stay known as those of vectors when symbols are replaced.
    pub fn substitute_lengths<'g>(&'g self, roots: &[Ex<'g>], map: &Map<SymbolId, Ex<'g>>) {
        type Known = fn(&mut Vectors) -> &mut Map<NodeId, Vec<NodeId>>;
        let roots: Vec<NodeId> = roots.iter().map(|root| root.id()).collect();
        for node in self.reachable(&roots) {
            let kinds: [Known; 3] = [
                |known| &mut known.norms,
                |known| &mut known.squares,
                |known| &mut known.products,
            ];
            for kind in kinds {
                let vector = kind(&mut self.store_mut().vectors).get(&node).cloned();
                if let Some(vector) = vector {
                    let all = [&[node], &vector[..]].concat();
                    let all: Vec<Ex> = all.into_iter().map(|id| self.ex(id)).collect();
                    let renewed = substitute(&all, map).into_iter().map(Ex::id);
                    let renewed: Vec<NodeId> = renewed.collect();
                    kind(&mut self.store_mut().vectors).insert(renewed[0], renewed[1..].to_vec());
                }
            }
        }
    }
}
