//! Vectors, turns and motions of one term.

use linkage_symbolic::Vn;

use crate::algebra::{Translate, Value, calls, scalar};
use crate::model::{Expr, ExprKind, Function};
use crate::picture::marks::{Term, Turn};
use crate::picture::point_or_vector::Moves;
use crate::picture::sketch::{self, Sketch};

/// A vector turned as a call turns its first argument.
pub(super) fn turned_vector<'m>(
    sketch: &mut Sketch<'_, 'm>,
    function: Function,
    arguments: &'m [Expr],
    vector: Vn<'m>,
) -> Vn<'m> {
    let mut values = vec![Value::Vector(vector)];
    for argument in &arguments[1..] {
        values.push(sketch.algebra.translate(argument));
    }
    let value = calls::call(sketch.algebra, function, values);
    scalar::vector(sketch.algebra, &value)
}

/// The rotations of a term in space, from outside to inside.
pub(super) fn turns_of<'m>(sketch: &mut Sketch<'_, 'm>, term: &Term<'m>) -> Vec<Turn<'m>> {
    if let Some(part) = &term.part {
        return part.turns.clone();
    }
    match &term.expr.kind {
        ExprKind::Call(Function::Turn, arguments) if sketch.moves(&arguments[2]) != Moves::Not => {
            vec![Turn {
                along: sketch.vector(&arguments[1]),
                by: Some(&arguments[2]),
            }]
        }
        // What turns in the plane turns about z.
        ExprKind::Call(Function::Polar | Function::Rotate, arguments)
            if sketch.dimension == 3 && sketch.moves(&arguments[1]) != Moves::Not =>
        {
            vec![Turn {
                along: sketch::axis_of(sketch, 2),
                by: Some(&arguments[1]),
            }]
        }
        // Nothing else turns about an axis of its own.
        _ => Vec::new(),
    }
}

pub(super) fn moves_of(sketch: &Sketch<'_, '_>, term: &Term) -> Moves {
    term.part
        .as_ref()
        .map_or_else(|| sketch.moves(term.expr), |part| part.moves)
}

/// The vector that a term adds, its sign aside.
pub(super) fn step_of<'m>(sketch: &mut Sketch<'_, 'm>, term: &Term<'m>) -> Vn<'m> {
    match &term.part {
        Some(part) => part.at,
        None => sketch.vector(term.expr),
    }
}

/// Remembers an axis through a point of space.
pub(super) fn axis<'m>(sketch: &mut Sketch<'_, 'm>, point: usize, along: Vn<'m>) {
    if let Some(along) = along.in_space() {
        let axis = (point, along.unit().into());
        if !sketch.axes.contains(&axis) {
            sketch.axes.push(axis);
        }
    }
}
