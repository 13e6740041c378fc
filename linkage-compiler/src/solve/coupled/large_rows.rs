//! Newton steps of cores that are too large for cofactors: bodies turn, and links are taken one by
//! one.
//!
//! A step does not need the equations that derivatives need. Any equations with the same solutions
//! and, up to constant factors, the same determinant suffice. If a body carries the end of a link
//! with the vector `V`, half of the square of `V` changes by `arm x V` as the body turns, and the
//! derivatives with respect to the nine components of its directions are not needed. No equation of
//! a step keeps the directions perpendicular and of length 1: they are made so at its start, and
//! turned.

use linkage_symbolic::{Ex, V3};

use crate::algebra::{Algebra, Bodies, Order, Scheme, derivatives::partial, nominal};
use crate::solve::coupled::rotation_variation;
use crate::solve::group_context::GroupContext;
use crate::structure::Core;

use super::equations::{BlockAtRow, Equations};
use super::large_system::LargeSystem;
use super::rotation_variation::{of_square, same};

/// A row of a step.
struct StepRow<'m> {
    residual: Ex<'m>,
    entries: Vec<Ex<'m>>,
    /// The row over the equation of the core.
    factor: Ex<'m>,
}

/// Builds the system for the steps of a large core, and the scheme for its derivatives.
pub(super) fn large_system<'m>(
    algebra: &mut Algebra<'m>,
    group: &GroupContext<'_, 'm>,
    equations: &Equations<'_, 'm>,
) -> LargeSystem<'m> {
    let graph = algebra.graph;
    let unknowns = equations.form.core.iter().map(|core| match *core {
        Core::Angle(_) => None,
        Core::Length { symbol, .. } => Some(graph.ex(graph.symbol_node(symbol))),
    });
    let bodies = Bodies::in_matrix(&equations.matrix, &unknowns.collect::<Vec<_>>());
    let freedoms = rotation_variation::freedoms(equations, &bodies);
    let order = pivot_order(algebra, group, &freedoms);
    let rows = rows_of_step(algebra, equations, &bodies, &freedoms);
    let share = rows
        .iter()
        .fold(algebra.one(), |product, row| product * row.factor);
    let matrix: Vec<Vec<Ex>> = rows.iter().map(|row| row.entries.clone()).collect();
    LargeSystem {
        residuals: rows.iter().map(|row| row.residual).collect(),
        order: pivot_order(algebra, group, &matrix),
        matrix,
        share: bodies.sign() / share,
        scheme: Scheme {
            bodies,
            freedoms,
            order,
        },
    }
}

/// The order in which a matrix is eliminated, found from its values at the estimates of the
/// unknowns.
fn pivot_order<'m>(
    algebra: &Algebra<'m>,
    group: &GroupContext<'_, 'm>,
    matrix: &[Vec<Ex<'m>>],
) -> Order {
    let values = nominal::at_estimates(&algebra.names, group.nominal, &matrix.concat());
    let values: Vec<Vec<f64>> = values.chunks(matrix.len()).map(<[_]>::to_vec).collect();
    let zero: Vec<Vec<bool>> = matrix
        .iter()
        .map(|row| row.iter().map(|x| x.is_zero()).collect())
        .collect();
    Order::new(&values, &zero)
}

/// `freedoms` are those of the core.
fn rows_of_step<'m>(
    algebra: &mut Algebra<'m>,
    equations: &Equations<'_, 'm>,
    bodies: &Bodies<'m>,
    freedoms: &[Vec<Ex<'m>>],
) -> Vec<StepRow<'m>> {
    let mut freedoms = freedoms.iter();
    let mut rows = Vec::new();
    let mut number = 0;
    for loop_rows in equations.blocks_with_rows() {
        let count = equations.count(loop_rows);
        for row in number..number + count {
            if bodies.rows.contains(&row) {
                let by_freedoms = freedoms.next().expect("a row for each of the core");
                let of_link = row_of_link(algebra, equations, bodies, loop_rows);
                rows.push(of_link.unwrap_or_else(|| StepRow {
                    residual: equations.residuals[row],
                    entries: by_freedoms.clone(),
                    factor: algebra.one(),
                }));
            }
        }
        number += count;
    }
    rows
}

/// Returns `(V.V - l^2)/2` for a link that ends on bodies, scaled. The equation of the core is this
/// over the length, less a multiple of another one: neither changes steps.
fn row_of_link<'m>(
    algebra: &mut Algebra<'m>,
    equations: &Equations<'_, 'm>,
    bodies: &Bodies<'m>,
    loop_rows: BlockAtRow<'_, 'm>,
) -> Option<StepRow<'m>> {
    let block = loop_rows.block;
    let link = block.distance.as_ref()?;
    if bodies.list.is_empty() || !block.is_length() {
        return None;
    }
    let vector = link.vector.map(|x| equations.scale * x);
    let length = equations.scale * link.length;
    let columns = equations.variables.iter().zip(&equations.form.core);
    let slopes: Vec<V3> = columns
        .map(|(&variable, &core)| {
            let scale = equations.column_scale(block, core);
            link.vector
                .map(|x| scale * partial::partial(algebra, x, variable))
        })
        .collect();
    let by_unknowns: Vec<Ex> = slopes.iter().map(|slope| vector.dot(*slope)).collect();
    let others = bodies.columns.iter().map(|&k| by_unknowns[k]);
    let turns = bodies.list.iter().flat_map(|body| {
        let any = body.by_turns(&by_unknowns);
        let carried = of_square(body, vector).filter(|carried| same(*carried, any));
        carried.unwrap_or(any).0
    });
    Some(StepRow {
        residual: 0.5 * (vector.square() - length.square()),
        entries: others.chain(turns).collect(),
        factor: length,
    })
}
