//! What differentiation needs of a point on spheres and planes.

use linkage_symbolic::{NodeId, SymbolId};

use crate::algebra::{CoreRow, Elimination, Solution, Term};
use crate::formulate::Solver;
use crate::structure::{Plane, Sphere};

use super::{Ball, Place};

impl Solver<'_, '_> {
    /// Records what differentiation needs. `determinant` is that of the scaled distances from the centres and the unit normals.
    ///
    /// A sphere's equation is `(V.V - l^2)/2` times the scale, so that its row of the matrix has no length.
    pub(super) fn push_point(
        &mut self,
        coordinates: &[(SymbolId, usize)],
        spheres: &[Sphere],
        planes: &[Plane],
        balls: &[Ball],
        place: &Place,
        mut determinant: NodeId,
    ) {
        let count = coordinates.len();
        let (zero, one) = (self.algebra.graph.zero(), self.algebra.graph.one());
        let row_of = |row: usize, node: NodeId| {
            let mut coefficient = vec![zero; count];
            coefficient[row] = node;
            coefficient
        };
        let point: Vec<NodeId> = coordinates
            .iter()
            .map(|(symbol, _)| self.algebra.graph.symbol_node(*symbol))
            .collect();
        let mut jacobian = vec![vec![zero; count]; count];
        let mut terms = Vec::new();
        let mut factors = Vec::new();
        for (row, (sphere, ball)) in spheres.iter().zip(balls).enumerate() {
            let link = [0, 1, 2].map(|k| {
                let graph = &mut self.algebra.graph;
                let own = graph.sub(place.arm[k], ball.apart[k]);
                let value = graph.mul(sphere.factor, own);
                let value = self.guarded(value, place.h);
                let moved = coordinates.iter().zip(&point).find(|((_, c), _)| *c == k);
                let graph = &mut self.algebra.graph;
                let moved = moved.map_or(zero, |(_, &p)| graph.mul(sphere.factor, p));
                let equal = graph.add(sphere.known[k], moved);
                let equal = graph.mul(place.scale, equal);
                self.alias("leg", value, equal)
            });
            let graph = &mut self.algebra.graph;
            let length = graph.mul(place.scale, sphere.radius);
            let minus = graph.neg(length);
            let known = sphere.known.into_iter().zip(link);
            let along: Vec<NodeId> = coordinates.iter().map(|&(_, k)| link[k]).collect();
            let moved = self.algebra.dot(&along, &point);
            let own = known.chain([(sphere.radius, minus), (sphere.factor, moved)]);
            terms.extend(own.map(|(coefficient, factor)| Term {
                coefficient: row_of(row, coefficient),
                factor,
            }));
            for (column, &(_, k)) in coordinates.iter().enumerate() {
                jacobian[column][row] = self.algebra.graph.mul(sphere.factor, link[k]);
            }
            factors.push(one);
            let square = self.algebra.graph.square(sphere.factor);
            determinant = self.algebra.graph.mul(square, determinant);
        }
        for (k, plane) in planes.iter().enumerate() {
            let row = spheres.len() + k;
            for (column, &(_, k)) in coordinates.iter().enumerate() {
                jacobian[column][row] = plane.normal[k];
                terms.push(Term {
                    coefficient: row_of(row, plane.normal[k]),
                    factor: point[column],
                });
            }
            terms.push(Term {
                coefficient: row_of(row, plane.offset),
                factor: one,
            });
            let (length, _) = self.algebra.length_and_unit(plane.normal);
            factors.push(self.algebra.graph.div(one, length));
        }
        let matrix: Vec<Vec<NodeId>> = (0..count)
            .map(|row| {
                let columns = jacobian.iter();
                columns
                    .map(|column| self.algebra.graph.mul(factors[row], column[row]))
                    .collect()
            })
            .collect();
        let product = self.algebra.determinant(&matrix);
        let determinant = self.alias("det", determinant, product);
        let rows = factors
            .into_iter()
            .enumerate()
            .map(|(first, factor)| CoreRow {
                first,
                factors: vec![factor],
            });
        let elimination = Elimination {
            rows: rows.collect(),
            matrix,
            units: vec![one; count],
            privates: Vec::new(),
        };
        self.push_solution(Solution {
            terms,
            jacobian,
            determinant,
            elimination: Some(elimination),
        });
    }
}
