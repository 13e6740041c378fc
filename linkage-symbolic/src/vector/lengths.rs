//! What is known of vectors: lengths and what they are the lengths of, scalar products and their factors, directions.

use crate::unordered::{Map, Set};

use crate::expression::Ex;
use crate::graph::{Graph, NodeId, SymbolId};
use crate::probe::{agree, agree_within};
use crate::substitute::substitute;

use super::{V3, Vector, Vn};

/// What rounding may add to the square of a direction.
const UNIT: f64 = 8.0 * f64::EPSILON;

/// What the graph remembers of vectors.
#[derive(Clone, Debug, Default)]
pub(crate) struct Vectors {
    /// Vectors behind nodes that are their lengths: a loop `distance(a, b) = l` is solved by these.
    norms: Map<NodeId, Vec<NodeId>>,
    /// The same behind squares of lengths.
    squares: Map<NodeId, Vec<NodeId>>,
    /// The factors of scalar products in space, one behind the other.
    products: Map<NodeId, Vec<NodeId>>,
    /// Vectors of length 1.
    units: Set<Vec<NodeId>>,
}

impl Graph {
    /// The vector that a node is known to be the length of.
    pub fn vector_of_length(&self, length: NodeId) -> Option<Vec<NodeId>> {
        self.store().vectors.norms.get(&length).cloned()
    }

    /// The vector that a node is known to be the square of.
    pub fn vector_of_square(&self, square: NodeId) -> Option<Vec<NodeId>> {
        self.store().vectors.squares.get(&square).cloned()
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

impl<'g> Vn<'g> {
    /// The length; of what it is the length stays known.
    pub fn length(self) -> Ex<'g> {
        let length = match self.len() {
            2 => self.at(0).hypot(self.at(1)),
            _ => self.square().sqrt(),
        };
        let norms = &mut self.graph.store_mut().vectors.norms;
        norms.insert(length.id(), self.ids().to_vec());
        length
    }

    /// The scalar product with itself; what it is the square of stays known.
    pub fn square(self) -> Ex<'g> {
        let zero = self.graph.number(0.0);
        let square = self.iter().fold(zero, |sum, x| sum + x.square());
        let squares = &mut self.graph.store_mut().vectors.squares;
        squares.insert(square.id(), self.ids().to_vec());
        square
    }

    /// Remembers that the length is 1: of the vector, its opposite, and in the plane both turned by a quarter.
    pub fn mark_unit(self) {
        let back = -self;
        let quarters = match (self.ids(), back.ids()) {
            (&[x, y], &[back_x, back_y]) => vec![vec![back_y, x], vec![y, back_x]],
            _ => Vec::new(),
        };
        let units = &mut self.graph.store_mut().vectors.units;
        units.extend(quarters);
        units.extend([self, back].map(|v| v.ids().to_vec()));
    }

    /// True if the length is known to be 1.
    pub fn is_unit(self) -> bool {
        let constants: Option<Vec<f64>> = self.iter().map(Ex::constant_value).collect();
        match constants {
            Some(numbers) => {
                let square: f64 = numbers.iter().map(|x| x * x).sum();
                (square - 1.0).abs() <= 2.0 * f64::EPSILON
            }
            None => self.graph.store().vectors.units.contains(self.ids()),
        }
    }

    /// True if two vectors are perpendicular and of one length. Not by a product that vanishes: rounded constants leave a rest of it,
    /// which is small only beside the squares.
    pub fn is_turned(self, other: Self) -> bool {
        let [first, second] = [self, other].map(Self::square);
        let whole = (self + other).square();
        let parts = first + second;
        agree(first, second) && agree(whole, parts)
    }
}

impl<'g> V3<'g> {
    /// The scalar product; its factors stay known.
    pub fn product(self, other: Self) -> Ex<'g> {
        let product = self.dot(other);
        let factors = self.0.iter().chain(&other.0).map(|x| x.id()).collect();
        let products = &mut product.graph().store_mut().vectors.products;
        products.insert(product.id(), factors);
        product
    }
}

impl V3<'_> {
    /// The direction. What has length 1 by its formula, as `(cos t, 0, sin t)`, is not divided.
    #[must_use]
    pub fn unit(self) -> Self {
        if !self.is_unit() {
            let (square, one) = (self.square(), self.0[0].number(1.0));
            if agree_within(square, one, UNIT) {
                self.mark_unit();
            }
        }
        self.length_and_unit().1
    }
}
