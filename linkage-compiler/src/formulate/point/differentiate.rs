//! What differentiation needs of a point on spheres and planes.

use linkage_symbolic::{NodeId, SymbolId};

use crate::algebra::{CoreRow, Elimination, Solution, Term};
use crate::formulate::Solver;
use crate::formulate::space::Space;
use crate::structure::Plane;

use super::{Ball, Place};

/// Coefficients and factors of one equation.
type Row = Vec<(NodeId, NodeId)>;

impl Solver<'_, '_> {
    /// Records what differentiation needs. `volume` is the determinant of the first sphere's arm and the normals, scaled.
    ///
    /// The equations are the first sphere's and how the others differ from it: three nearly equal rows would cancel. They are
    /// multiplied by the scale, so that the matrix consists of scaled lengths.
    pub(super) fn push_point(
        &mut self,
        coordinates: &[(SymbolId, usize)],
        planes: &[Plane],
        balls: &[Ball],
        place: &Place,
        volume: NodeId,
    ) {
        let count = coordinates.len();
        let (zero, one) = (self.algebra.graph.zero(), self.algebra.graph.one());
        let point: Vec<NodeId> = coordinates
            .iter()
            .map(|(symbol, _)| self.algebra.graph.symbol_node(*symbol))
            .collect();
        let first = [0, 1, 2].map(|k| {
            let value = self.guarded(place.arm[k], place.h);
            let moved = coordinates.iter().zip(&point).find(|((_, c), _)| *c == k);
            let moved = moved.map_or(zero, |(_, &p)| p);
            let graph = &mut self.algebra.graph;
            let equal = graph.sub(moved, balls[0].centre[k]);
            let equal = graph.mul(place.scale, equal);
            self.alias("leg", value, equal)
        });
        let mut rows = vec![(self.sphere_terms(first, &balls[0]), first, one)];
        for ball in &balls[1..] {
            let leg = [0, 1, 2].map(|k| self.algebra.graph.sub(first[k], ball.apart[k]));
            let terms = self.difference_terms(leg, &balls[0], ball);
            rows.push((terms, ball.apart, one));
        }
        for plane in planes {
            let mut terms = vec![(plane.offset, one)];
            for (&(_, k), &coordinate) in coordinates.iter().zip(&point) {
                terms.push((plane.normal[k], coordinate));
            }
            let (length, _) = self.algebra.length_and_unit(plane.normal);
            let factor = self.algebra.graph.div(one, length);
            rows.push((terms, plane.normal, factor));
        }

        let mut terms = Vec::new();
        let mut jacobian = vec![vec![zero; count]; count];
        let mut core = Vec::new();
        let mut matrix = Vec::new();
        for (row, (own, slope, factor)) in rows.into_iter().enumerate() {
            terms.extend(own.into_iter().map(|(node, factor)| {
                let mut coefficient = vec![zero; count];
                coefficient[row] = node;
                Term {
                    coefficient,
                    factor,
                }
            }));
            for (column, &(_, k)) in coordinates.iter().enumerate() {
                jacobian[column][row] = slope[k];
            }
            let entries = coordinates.iter();
            matrix.push(
                entries
                    .map(|&(_, k)| self.algebra.graph.mul(factor, slope[k]))
                    .collect(),
            );
            core.push(CoreRow {
                first: row,
                factors: vec![factor],
            });
        }
        // With two coordinates the third row is an axis.
        let missing = (0..3).find(|k| coordinates.iter().all(|(_, component)| component != k));
        let value = match missing {
            Some(1) => self.algebra.graph.neg(volume),
            _ => volume,
        };
        let product = self.algebra.determinant(&matrix);
        let determinant = self.alias("det", value, product);
        self.push_solution(Solution {
            terms,
            jacobian,
            determinant,
            elimination: Some(Elimination {
                rows: core,
                matrix,
                units: vec![one; count],
                privates: Vec::new(),
            }),
        });
    }

    /// `((p - c).(p - c) - r^2)/2`
    fn sphere_terms(&mut self, leg: Space, ball: &Ball) -> Row {
        let mut terms: Row = (0..3)
            .map(|k| (ball.centre[k], self.algebra.graph.neg(leg[k])))
            .collect();
        terms.push((ball.radius, self.algebra.graph.neg(ball.scaled)));
        terms
    }

    /// `a . (p - c) - (a . a + r^2 - r'^2)/2`, where `a` leads from the first sphere's centre `c` to that of the other.
    fn difference_terms(&mut self, leg: Space, base: &Ball, ball: &Ball) -> Row {
        let graph = &mut self.algebra.graph;
        let mut terms = Row::new();
        for (k, leg) in leg.into_iter().enumerate() {
            terms.push((graph.sub(ball.centre[k], base.centre[k]), leg));
            terms.push((base.centre[k], graph.neg(ball.apart[k])));
        }
        terms.push((base.radius, graph.neg(base.scaled)));
        terms.push((ball.radius, ball.scaled));
        terms
    }
}
