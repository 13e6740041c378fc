//! The unknowns of loops of the plane as joints and bodies.

use crate::algebra::partial;
use linkage_symbolic::{Ex, SymbolId, V2, Vector, numerically_equal};

use crate::solve::Solver;
use crate::structure::Core;

use super::super::equations::Equations;

/// How much of a joint's direction each loop contains.
pub(super) type Shares<'m> = Vec<Ex<'m>>;

/// A column of the loops, scaled.
type Column<'m> = Vec<V2<'m>>;

/// What the unknowns move.
pub(super) struct Parts<'m> {
    /// Those with one direction in all loops, the private unknowns among them.
    pub(super) joints: Vec<Shares<'m>>,
    /// The product of the lengths of the core's joints.
    pub(super) size: Ex<'m>,
    /// The columns of the others.
    pub(super) bodies: Vec<Column<'m>>,
}

/// The unknowns of a core and those that are private to loops.
pub(super) fn parts<'m>(solver: &mut Solver<'_, 'm>, equations: &Equations<'_, 'm>) -> Parts<'m> {
    let form = equations.form;
    let loops = form.blocks.len();
    let private = (0..loops).filter(|&own| form.blocks[own].private.is_some());
    let mut parts = Parts {
        joints: private.map(|own| unit(solver, own, loops)).collect(),
        size: solver.algebra.one(),
        bodies: Vec::new(),
    };
    let columns = absolute_columns(solver, equations);
    let shares: Vec<_> = columns
        .iter()
        .map(|column| shares_of(solver, column))
        .collect();
    for (own, column) in columns.into_iter().enumerate() {
        match &shares[own] {
            Some((length, joint)) if !is_half_of_point(&form.core, &shares, own) => {
                parts.size = parts.size * *length;
                parts.joints.push(joint.clone());
            }
            _ => parts.bodies.push(column),
        }
    }
    parts
}

/// Shares of a joint that is in one loop alone.
pub(super) fn unit<'m>(solver: &Solver<'_, 'm>, own: usize, loops: usize) -> Shares<'m> {
    let (zero, one) = (solver.algebra.zero(), solver.algebra.one());
    (0..loops)
        .map(|k| if k == own { one } else { zero })
        .collect()
}

/// The columns of the core, as if no angle were measured from another: of two angles that turn with each other, the column of the one
/// measured from is without that of the other.
fn absolute_columns<'m>(
    solver: &mut Solver<'_, 'm>,
    equations: &Equations<'_, 'm>,
) -> Vec<Column<'m>> {
    let core = &equations.form.core;
    let mut columns: Vec<Column> = (0..core.len())
        .map(|own| column(solver, equations, own))
        .collect();
    let angles: Vec<usize> = (0..core.len())
        .filter(|&own| matches!(core[own], Core::Angle(_)))
        .collect();
    for &relative in &angles {
        let variable = equations.variables[relative];
        let bend = slope_of(solver, &columns[relative], variable);
        for &base in angles.iter().filter(|&&base| base != relative) {
            let shared = slope_of(solver, &columns[base], variable);
            if shared.iter().all(|v| v.is_zero()) {
                continue;
            }
            for sign in [1.0, -1.0] {
                let signed = |v: V2<'m>| v.map(|x| sign * x);
                if shared.iter().zip(&bend).all(|(&v, &w)| same(v, signed(w))) {
                    let relative = columns[relative].clone();
                    for (v, w) in columns[base].iter_mut().zip(relative) {
                        *v = *v - signed(w);
                    }
                    break;
                }
            }
        }
    }
    columns
}

/// The derivative of every loop by an unknown of the core, scaled as its column is.
fn column<'m>(
    solver: &mut Solver<'_, 'm>,
    equations: &Equations<'_, 'm>,
    own: usize,
) -> Column<'m> {
    let (core, variable) = (equations.form.core[own], equations.variables[own]);
    let column = equations.form.blocks.iter().map(|block| {
        let rows = Vector([block.rows[0], block.rows[1]]);
        let slope = rows.map(|x| partial::partial(solver.algebra, x, variable));
        equations.column_scale(block, core) * slope
    });
    column.collect()
}

fn slope_of<'m>(
    solver: &mut Solver<'_, 'm>,
    column: &Column<'m>,
    variable: SymbolId,
) -> Column<'m> {
    let slopes = column.iter();
    slopes
        .map(|v| v.map(|x| partial::partial(solver.algebra, x, variable)))
        .collect()
}

/// Length and shares of a column that has one direction in all of its loops.
fn shares_of<'m>(solver: &Solver<'_, 'm>, column: &Column<'m>) -> Option<(Ex<'m>, Shares<'m>)> {
    let (zero, one) = (solver.algebra.zero(), solver.algebra.one());
    let nothing = Vector([zero; 2]);
    let first = *column.iter().find(|&&v| !same(v, nothing))?;
    let shares = column.iter().map(|&v| match v {
        v if same(v, nothing) => Some(zero),
        v if same(v, first) => Some(one),
        v if same(-v, first) => Some(-one),
        v if numerically_equal(v[0] * first[1], v[1] * first[0]) => {
            Some(v.dot(first) / first.square())
        }
        _ => None,
    });
    let shares = shares.collect::<Option<Shares>>()?;
    Some((first.length(), shares))
}

fn same(v: V2<'_>, w: V2<'_>) -> bool {
    numerically_equal(v[0], w[0]) && numerically_equal(v[1], w[1])
}

/// Two lengths that are in the same loops are no guides: together they are a point that is free.
fn is_half_of_point(core: &[Core], shares: &[Option<(Ex<'_>, Shares<'_>)>], own: usize) -> bool {
    let is_length = |k: usize| matches!(core[k], Core::Length { .. });
    let of = |k: usize| shares[k].as_ref().map(|(_, shares)| shares);
    let alike = |a: &Shares, b: &Shares| {
        let places = 0..a.len();
        let mut pairs = places
            .clone()
            .flat_map(|j| places.clone().map(move |k| (j, k)));
        pairs.all(|(j, k)| numerically_equal(a[j] * b[k], a[k] * b[j]))
    };
    let mut others = (0..core.len()).filter(|&other| other != own && is_length(other));
    is_length(own)
        && others.any(|other| match (of(own), of(other)) {
            (Some(a), Some(b)) => alike(a, b),
            _ => false,
        })
}
