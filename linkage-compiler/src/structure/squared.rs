//! Distances in space as polynomials of low degree, for the general machinery.

use linkage_symbolic::NodeId;

use super::Analysis;
use super::equations::{Coordinate, CoordinateKind, Equation};
use super::space::Vector;

/// A distance that was squared.
struct Link {
    vector: Vector,
    length: NodeId,
}

impl Analysis<'_, '_> {
    /// `|v| = l` becomes `(v . v / l - l)/2`, a length. Where an earlier distance is about the same point, their difference is taken: it
    /// is of the first degree in that point, which leaves fewer solutions at infinity.
    pub(super) fn squared(
        &mut self,
        equations: &[Equation],
        coordinates: &[Coordinate],
    ) -> Vec<Equation> {
        let mut squared = equations.to_vec();
        let mut links: Vec<Link> = Vec::new();
        for equation in &mut squared {
            let &[row] = &equation.rows[..] else { continue };
            let Some((vector, length)) = self.space_distance(row, coordinates) else {
                continue;
            };
            let link = Link { vector, length };
            let partner = links
                .iter()
                .find_map(|other| Some((self.apart(&link, other, coordinates)?, other)));
            let row = match partner {
                Some(([apart, sum], other)) => self.difference_of_links(&link, other, apart, sum),
                None => self.square_of_link(&link),
            };
            equation.rows = vec![row];
            equation.distance = Some(length);
            links.push(link);
        }
        squared
    }

    /// Difference and sum of two links' vectors (one of them reversed if need be), if the difference is free of a length that the
    /// first vector contains.
    fn apart(
        &mut self,
        link: &Link,
        other: &Link,
        coordinates: &[Coordinate],
    ) -> Option<[Vector; 2]> {
        let contained = self.lengths_in(link.vector, coordinates)?;
        let [sum, difference] = [false, true].map(|minus| {
            [0, 1, 2].map(|k| {
                let (a, b) = (link.vector[k], other.vector[k]);
                let graph = &mut self.algebra.graph;
                if minus {
                    graph.sub(a, b)
                } else {
                    graph.add(a, b)
                }
            })
        });
        [[difference, sum], [sum, difference]]
            .into_iter()
            .find(|[apart, _]| {
                let left = self.lengths_in(*apart, coordinates);
                left.is_some_and(|left| contained.iter().any(|k| !left.contains(k)))
            })
    }

    /// The unknown lengths that a vector contains.
    fn lengths_in(&mut self, vector: Vector, coordinates: &[Coordinate]) -> Option<Vec<usize>> {
        let polynomials = self.polynomials(&vector, coordinates)?;
        let is_length = |k: &usize| matches!(coordinates[*k].kind, CoordinateKind::Length(_));
        let contained = (0..coordinates.len())
            .filter(is_length)
            .filter(|&k| polynomials.mention(self.first_symbol(coordinates, k)));
        Some(contained.collect())
    }

    fn square_of_link(&mut self, link: &Link) -> NodeId {
        let square = self.algebra.dot(&link.vector, &link.vector);
        let graph = &mut self.algebra.graph;
        let share = graph.div(square, link.length);
        let miss = graph.sub(share, link.length);
        let half = graph.constant(0.5);
        graph.mul(half, miss)
    }

    /// `((v - w).(v + w) - (l - m)(l + m))/2 l`
    fn difference_of_links(
        &mut self,
        link: &Link,
        other: &Link,
        apart: Vector,
        sum: Vector,
    ) -> NodeId {
        let product = self.algebra.dot(&apart, &sum);
        let graph = &mut self.algebra.graph;
        let difference = graph.sub(link.length, other.length);
        let total = graph.add(link.length, other.length);
        let wanted = graph.mul(difference, total);
        let miss = graph.sub(product, wanted);
        let miss = graph.div(miss, link.length);
        let half = graph.constant(0.5);
        graph.mul(half, miss)
    }
}
