//! Vectors, turns and motions of one term.

use linkage_symbolic::Vn;

use crate::algebra::{Algebra, Translate, Value, calls, scalar};
use crate::model::{Expr, ExprKind, Function};
use crate::picture::layout::{self, Layout};
use crate::picture::marks::{Term, Turn};
use crate::picture::point_or_vector::{Moves, Roles};

/// A vector turned as a call turns its first argument.
pub(super) fn turned_vector<'m>(
    algebra: &mut Algebra<'m>,
    function: Function,
    arguments: &'m [Expr],
    vector: Vn<'m>,
) -> Vn<'m> {
    let mut values = vec![Value::Vector(vector)];
    for argument in &arguments[1..] {
        values.push(algebra.translate(argument));
    }
    let value = calls::call(&mut algebra.names, function, values);
    scalar::vector(&algebra.names, &value)
}

/// The rotations of a term in space, from outside to inside.
pub(super) fn turns_of<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    term: &Term<'m>,
) -> Vec<Turn<'m>> {
    if let Some(part) = &term.part {
        return part.turns.clone();
    }
    match &term.expr.kind {
        ExprKind::Call(Function::Turn, arguments)
            if layout.roles.moves(&arguments[2]) != Moves::Not =>
        {
            vec![Turn {
                along: layout::vector(algebra, layout.dimension, &arguments[1]),
                by: Some(&arguments[2]),
            }]
        }
        // What turns in the plane turns about z.
        ExprKind::Call(Function::Polar | Function::Rotate, arguments)
            if layout.dimension == 3 && layout.roles.moves(&arguments[1]) != Moves::Not =>
        {
            vec![Turn {
                along: layout::axis_of(algebra.graph, layout.dimension, 2),
                by: Some(&arguments[1]),
            }]
        }
        // Nothing else turns about an axis of its own.
        _ => Vec::new(),
    }
}

pub(super) fn moves_of(roles: &Roles, term: &Term) -> Moves {
    term.part
        .as_ref()
        .map_or_else(|| roles.moves(term.expr), |part| part.moves)
}

/// The vector that a term adds, its sign aside.
pub(super) fn step_of<'m>(algebra: &mut Algebra<'m>, dimension: usize, term: &Term<'m>) -> Vn<'m> {
    match &term.part {
        Some(part) => part.at,
        None => layout::vector(algebra, dimension, term.expr),
    }
}

/// Remembers an axis through a point of space.
pub(super) fn axis<'m>(axes: &mut Vec<(usize, Vn<'m>)>, point: usize, along: Vn<'m>) {
    if let Some(along) = along.in_space() {
        let axis = (point, along.unit().into());
        if !axes.contains(&axis) {
            axes.push(axis);
        }
    }
}
