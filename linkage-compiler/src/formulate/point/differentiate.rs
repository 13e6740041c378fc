//! What differentiation needs of a point on spheres and planes.

use linkage_symbolic::program::Unary;
use linkage_symbolic::{NodeId, SymbolId};

use crate::algebra::{CoreRow, Elimination, Solution, Term};
use crate::formulate::Solver;
use crate::formulate::space::Space;
use crate::structure::{Plane, Sphere};

use super::Ball;

impl Solver<'_, '_> {
    /// Records what differentiation needs but the determinant; returns the factors by which the rows and their links enter it.
    pub(super) fn push_point(
        &mut self,
        coordinates: &[(SymbolId, usize)],
        spheres: &[Sphere],
        planes: &[Plane],
        balls: &[Ball],
        arm: Space,
        h: NodeId,
    ) -> Vec<NodeId> {
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
        let mut rows = Vec::new();
        let mut factors = Vec::new();
        for (row, (sphere, ball)) in spheres.iter().zip(balls).enumerate() {
            let link = [0, 1, 2].map(|k| {
                let graph = &mut self.algebra.graph;
                let apart = graph.sub(ball.centre[k], balls[0].centre[k]);
                let own = graph.sub(arm[k], apart);
                let value = graph.mul(sphere.factor, own);
                let value = self.guarded(value, h);
                let moved = coordinates.iter().zip(&point).find(|((_, c), _)| *c == k);
                let graph = &mut self.algebra.graph;
                let moved = moved.map_or(zero, |(_, &p)| graph.mul(sphere.factor, p));
                let equal = graph.add(sphere.known[k], moved);
                self.alias("leg", value, equal)
            });
            let own = self.distance_terms(link, sphere.known, sphere.radius);
            terms.extend(own.into_iter().map(|term| Term {
                coefficient: row_of(row, term.coefficient[0]),
                factor: term.factor,
            }));
            let along: Vec<NodeId> = coordinates.iter().map(|&(_, k)| link[k]).collect();
            let factor = self.algebra.dot(&along, &point);
            terms.push(Term {
                coefficient: row_of(row, sphere.factor),
                factor,
            });
            for (column, &(_, k)) in coordinates.iter().enumerate() {
                jacobian[column][row] = self.algebra.graph.mul(sphere.factor, link[k]);
            }
            let graph = &mut self.algebra.graph;
            let scale = graph.unary(Unary::InverseScale, sphere.radius);
            rows.push(scale);
            let square = graph.square(sphere.factor);
            factors.push(graph.mul(scale, square));
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
            let scale = self.algebra.graph.unary(Unary::InverseScale, length);
            rows.push(scale);
            factors.push(scale);
        }
        let matrix = (0..count)
            .map(|row| {
                let columns = jacobian.iter();
                columns
                    .map(|column| self.algebra.graph.mul(rows[row], column[row]))
                    .collect()
            })
            .collect();
        let rows = rows.into_iter().enumerate().map(|(first, scale)| CoreRow {
            first,
            factors: vec![scale],
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
            determinant: zero,
            elimination: Some(elimination),
        });
        factors
    }

    /// The determinant of the last solution, computed as `value`.
    pub(super) fn set_determinant(&mut self, value: NodeId) {
        let solution = self.algebra.solutions[self.index].clone();
        let matrix = solution.elimination.map(|e| e.matrix).unwrap_or_default();
        let product = self.algebra.determinant(&matrix);
        let determinant = self.alias("det", value, product);
        self.algebra.solutions[self.index].determinant = determinant;
    }
}
