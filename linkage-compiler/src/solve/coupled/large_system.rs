//! The system that steps of a large core solve, in the freedoms of its bodies.

use linkage_symbolic::{Ex, V3, Vector};

use crate::algebra::{Body, Order, Scheme};

use super::state::StatePart;

/// The system that a step solves.
pub(super) struct LargeSystem<'m> {
    /// The scheme that solves the system of all unknowns, for derivatives.
    pub(super) scheme: Scheme<'m>,
    pub(super) residuals: Vec<Ex<'m>>,
    /// Their derivatives by the freedoms.
    pub(super) matrix: Vec<Vec<Ex<'m>>>,
    pub(super) order: Order,
    /// The determinant of the core over that of this matrix.
    pub(super) share: Ex<'m>,
}

impl<'m> LargeSystem<'m> {
    fn bodies(&self) -> &[Body<'m>] {
        &self.scheme.bodies.list
    }

    /// Makes the directions of bodies perpendicular and of length 1, up to the square of their
    /// errors. Returns the errors.
    pub(super) fn straighten(&self, start: &mut [StatePart<'m>]) -> Vec<Ex<'m>> {
        let mut missed = Vec::new();
        for body in self.bodies() {
            let [u, w] = axes(body, start);
            let [p, q] = [u, w].map(|axis| 0.5 * (axis.square() - 1.0));
            let half = 0.5 * u.dot(w);
            let straight = [u - (p * u + half * w), w - (q * w + half * u)];
            for (columns, axis) in body.columns.iter().zip(straight) {
                for (&column, x) in columns.iter().zip(axis.components()) {
                    start[column] = start[column].with(x);
                }
            }
            missed.extend([p, q, 2.0 * half]);
        }
        missed
    }

    /// The corrections of all unknowns from those of the freedoms: bodies turn to second order.
    pub(super) fn corrections(&self, start: &[StatePart<'m>], freedoms: &[Ex<'m>]) -> Vec<Ex<'m>> {
        let mut corrections = freedoms.to_vec();
        corrections.resize(start.len(), freedoms[0]);
        let others = &self.scheme.bodies.columns;
        for (&column, &freedom) in others.iter().zip(freedoms) {
            corrections[column] = freedom;
        }
        let turns = freedoms[others.len()..].as_chunks::<3>().0;
        for (body, &turn) in self.bodies().iter().zip(turns) {
            let turn = Vector(turn);
            let half = turn.map(|x| 0.5 * x);
            for (columns, axis) in body.columns.iter().zip(axes(body, start)) {
                let way = turn.cross(axis + half.cross(axis));
                for (&column, x) in columns.iter().zip(way.components()) {
                    corrections[column] = x;
                }
            }
        }
        corrections
    }
}

/// The directions of a body in a state.
fn axes<'m>(body: &Body<'m>, state: &[StatePart<'m>]) -> [V3<'m>; 2] {
    body.columns
        .map(|columns| Vector(columns.map(|column| state[column].number())))
}
