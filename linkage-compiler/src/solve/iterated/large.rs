//! Newton steps of cores that are too large for cofactors: their bodies turn, and links are taken one by one.
//!
//! A step needs not the equations that derivatives need: any that have the same solutions and, but for constant factors, the same determinant.
//! Where a body carries the end of a link with the vector `V`, half of the square of `V` changes by `arm x V` as the body turns, and the
//! derivatives by the nine components of its directions are not needed. What keeps the directions perpendicular and of length 1 is no equation of a
//! step: they are made so where it begins, and turned.

use crate::algebra::nominal;
use crate::algebra::partial;
use crate::solve::iterated::turns;
use linkage_symbolic::{Ex, V3, Vector};

use crate::algebra::{Bodies, Body, Order, Scheme};
use crate::solve::Solver;
use crate::structure::Core;

use super::equations::{Equations, Place};
use super::state::Part;
use super::turns::{of_square, same};

/// The system that a step solves.
pub(super) struct Large<'m> {
    /// How that of all unknowns is solved, for derivatives.
    pub(super) scheme: Scheme<'m>,
    pub(super) residuals: Vec<Ex<'m>>,
    /// Their derivatives by the freedoms.
    pub(super) matrix: Vec<Vec<Ex<'m>>>,
    pub(super) order: Order,
    /// The determinant of the core over that of this matrix.
    pub(super) share: Ex<'m>,
}

/// A row of a step.
struct Row<'m> {
    residual: Ex<'m>,
    entries: Vec<Ex<'m>>,
    /// What it is over the equation of the core.
    factor: Ex<'m>,
}

impl<'m> Large<'m> {
    fn bodies(&self) -> &[Body<'m>] {
        &self.scheme.bodies.all
    }

    /// Makes the directions of bodies perpendicular and of length 1, but for the square of what they miss, which is returned.
    pub(super) fn straighten(&self, start: &mut [Part<'m>]) -> Vec<Ex<'m>> {
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
    pub(super) fn corrections(&self, start: &[Part<'m>], freedoms: &[Ex<'m>]) -> Vec<Ex<'m>> {
        let mut all = freedoms.to_vec();
        all.resize(start.len(), freedoms[0]);
        let others = &self.scheme.bodies.columns;
        for (&column, &own) in others.iter().zip(freedoms) {
            all[column] = own;
        }
        let turns = freedoms[others.len()..].as_chunks::<3>().0;
        for (body, &turn) in self.bodies().iter().zip(turns) {
            let turn = Vector(turn);
            let half = turn.map(|x| 0.5 * x);
            for (columns, axis) in body.columns.iter().zip(axes(body, start)) {
                let way = turn.cross(axis + half.cross(axis));
                for (&column, x) in columns.iter().zip(way.components()) {
                    all[column] = x;
                }
            }
        }
        all
    }
}

/// The directions of a body in a state.
fn axes<'m>(body: &Body<'m>, state: &[Part<'m>]) -> [V3<'m>; 2] {
    body.columns
        .map(|columns| Vector(columns.map(|column| state[column].number())))
}

/// What the steps of a large core solve, and how its derivatives are found.
pub(super) fn large<'m>(solver: &mut Solver<'_, 'm>, equations: &Equations<'_, 'm>) -> Large<'m> {
    let graph = solver.algebra.graph;
    let unknowns = equations.form.core.iter().map(|core| match *core {
        Core::Angle(_) => None,
        Core::Length { symbol, .. } => Some(graph.ex(graph.symbol_node(symbol))),
    });
    let bodies = Bodies::of(&equations.matrix, &unknowns.collect::<Vec<_>>());
    let freedoms = turns::freedoms(solver, equations, &bodies);
    let order = pivot_order(solver, &freedoms);
    let rows = rows_of_step(solver, equations, &bodies, &freedoms);
    let share = rows
        .iter()
        .fold(solver.algebra.one(), |all, own| all * own.factor);
    let matrix: Vec<Vec<Ex>> = rows.iter().map(|row| row.entries.clone()).collect();
    Large {
        residuals: rows.iter().map(|row| row.residual).collect(),
        order: pivot_order(solver, &matrix),
        matrix,
        share: bodies.sign() / share,
        scheme: Scheme {
            bodies,
            freedoms,
            order,
        },
    }
}

/// The order in which a matrix is eliminated, from what it is where the unknowns are estimated.
fn pivot_order<'m>(solver: &Solver<'_, 'm>, matrix: &[Vec<Ex<'m>>]) -> Order {
    let values = nominal::at_estimates(solver.algebra, solver.nominal, &matrix.concat());
    let values: Vec<Vec<f64>> = values.chunks(matrix.len()).map(<[_]>::to_vec).collect();
    let zero: Vec<Vec<bool>> = matrix
        .iter()
        .map(|row| row.iter().map(|x| x.is_zero()).collect())
        .collect();
    Order::new(&values, &zero)
}

/// `freedoms` are those of the core.
fn rows_of_step<'m>(
    solver: &mut Solver<'_, 'm>,
    equations: &Equations<'_, 'm>,
    bodies: &Bodies<'m>,
    freedoms: &[Vec<Ex<'m>>],
) -> Vec<Row<'m>> {
    let mut freedoms = freedoms.iter();
    let mut rows = Vec::new();
    let mut number = 0;
    for place in equations.places() {
        let own = equations.count(place);
        for row in number..number + own {
            if bodies.rows.contains(&row) {
                let by_freedoms = freedoms.next().expect("a row for each of the core");
                let of_link = row_of_link(solver, equations, bodies, place);
                rows.push(of_link.unwrap_or_else(|| Row {
                    residual: equations.residuals[row],
                    entries: by_freedoms.clone(),
                    factor: solver.algebra.one(),
                }));
            }
        }
        number += own;
    }
    rows
}

/// `(V.V - l^2)/2` of a link that ends on bodies, scaled. The equation of the core is this over the length, less a multiple of another
/// one: neither changes steps.
fn row_of_link<'m>(
    solver: &mut Solver<'_, 'm>,
    equations: &Equations<'_, 'm>,
    bodies: &Bodies<'m>,
    place: Place<'_, 'm>,
) -> Option<Row<'m>> {
    let block = place.block;
    let link = block.distance.as_ref()?;
    if bodies.all.is_empty() || !block.is_length() {
        return None;
    }
    let vector = link.vector.map(|x| equations.scale * x);
    let length = equations.scale * link.length;
    let columns = equations.variables.iter().zip(&equations.form.core);
    let slopes: Vec<V3> = columns
        .map(|(&variable, &core)| {
            let scale = equations.column_scale(block, core);
            link.vector
                .map(|x| scale * partial::partial(solver.algebra, x, variable))
        })
        .collect();
    let by_unknowns: Vec<Ex> = slopes.iter().map(|slope| vector.dot(*slope)).collect();
    let others = bodies.columns.iter().map(|&k| by_unknowns[k]);
    let turns = bodies.all.iter().flat_map(|body| {
        let any = body.by_turns(&by_unknowns);
        let carried = of_square(body, vector).filter(|own| same(*own, any));
        carried.unwrap_or(any).0
    });
    Some(Row {
        residual: 0.5 * (vector.square() - length.square()),
        entries: others.chain(turns).collect(),
        factor: length,
    })
}
