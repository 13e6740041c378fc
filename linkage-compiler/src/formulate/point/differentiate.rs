//! What differentiation needs of a point on spheres and planes.

use linkage_symbolic::program::Unary;
use linkage_symbolic::{NodeId, SymbolId};

use crate::algebra::{CoreRow, Elimination, Solution, Term};
use crate::formulate::Solver;
use crate::formulate::space::Space;
use crate::structure::Plane;

use super::Ball;

impl Solver<'_, '_> {
    /// Records what differentiation needs but the determinant; returns the factors by which the rows and their links enter it.
    pub(super) fn push_point(
        &mut self,
        coordinates: &[(SymbolId, usize)],
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
        // The first sphere, and how the others differ from it: three nearly equal rows would cancel.
        let mut legs: Vec<Space> = Vec::new();
        for ball in balls {
            let link = [0, 1, 2].map(|k| {
                let graph = &mut self.algebra.graph;
                let apart = graph.sub(ball.centre[k], balls[0].centre[k]);
                let value = graph.sub(arm[k], apart);
                let value = self.guarded(value, h);
                let moved = coordinates.iter().zip(&point).find(|((_, c), _)| *c == k);
                let moved = moved.map_or(zero, |(_, &p)| p);
                let equal = self.algebra.graph.sub(moved, ball.centre[k]);
                self.alias("leg", value, equal)
            });
            legs.push(link);
        }
        for (row, ball) in balls.iter().enumerate() {
            let base = &balls[0];
            let known = base.centre.map(|x| self.algebra.graph.neg(x));
            let own = match row {
                0 => self.distance_terms(legs[0], known, base.radius),
                _ => self.difference_terms(legs[row], base, ball),
            };
            terms.extend(own.into_iter().map(|term| Term {
                coefficient: row_of(row, term.coefficient[0]),
                factor: term.factor,
            }));
            let (slope, length) = match row {
                0 => (legs[0], base.radius),
                _ => {
                    let apart = self.apart(base, ball);
                    (apart, self.algebra.length(&apart))
                }
            };
            for (column, &(_, k)) in coordinates.iter().enumerate() {
                jacobian[column][row] = slope[k];
            }
            let scale = self.algebra.graph.unary(Unary::InverseScale, length);
            rows.push(scale);
            factors.push(scale);
        }
        for (k, plane) in planes.iter().enumerate() {
            let row = balls.len() + k;
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

    /// The terms of `a . (p - c) - (a . a + r^2 - r'^2)/2`, where `a` leads from the first sphere's centre `c` to that of the other.
    fn difference_terms(&mut self, leg: Space, base: &Ball, ball: &Ball) -> Vec<Term> {
        let apart = self.apart(base, ball);
        let mut terms = Vec::new();
        for k in 0..3 {
            terms.push((apart[k], leg[k]));
            terms.push((base.centre[k], self.algebra.graph.neg(apart[k])));
        }
        terms.push((base.radius, self.algebra.graph.neg(base.radius)));
        terms.push((ball.radius, ball.radius));
        let terms = terms.into_iter();
        terms
            .map(|(coefficient, factor)| Term {
                coefficient: vec![coefficient],
                factor,
            })
            .collect()
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
