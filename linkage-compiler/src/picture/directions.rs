//! The directions along which terms change their length.

use linkage_symbolic::{Ex, NodeId, Vn};

use crate::algebra::{Translate, calls, derivatives::dependence, scalar};
use crate::model::{BinaryOp, Expr, ExprKind, Function, Type};
use crate::picture::marks::Slide;
use crate::picture::sketch::Sketch;
use crate::picture::{expressions, parts, sketch};

/// The unit vector along which a term changes its length, and the part of the term across it.
pub(super) fn direction_of<'m>(sketch: &mut Sketch<'_, 'm>, term: &'m Expr) -> Option<Slide<'m>> {
    let input = expressions::driving(sketch.algebra.mechanism, term);
    let straight = |along: Vn<'m>| Slide {
        offset: None,
        along,
        input,
    };
    match &term.kind {
        ExprKind::Call(Function::Polar, arguments) => {
            let angle = sketch.algebra.translate(&arguments[1]);
            let unit = calls::call(sketch.algebra, Function::Dir, vec![angle]);
            // In a picture of space, the plane is that of x and y.
            let along = scalar::vector(sketch.algebra, &unit).resized(sketch.dimension);
            Some(straight(along))
        }
        ExprKind::Binary(BinaryOp::Mul, a, b) => {
            let vector = if matches!(a.ty, Type::Vector(..)) {
                a
            } else {
                b
            };
            Some(straight(sketch.vector(vector).unit()))
        }
        ExprKind::Vector(components) => {
            let (varying, rest) = varying(sketch, components)?;
            Some(Slide {
                offset: Some(rest),
                along: sketch::axis_of(sketch, varying),
                input,
            })
        }
        ExprKind::Call(function @ (Function::Rotate | Function::Turn), arguments) => {
            let inner = direction_of(sketch, &arguments[0])?;
            let mut turn = |v| parts::turned_vector(sketch, *function, arguments, v);
            Some(Slide {
                offset: inner.offset.map(&mut turn),
                along: turn(inner.along),
                input,
            })
        }
        // Of anything else nobody knows along what it changes.
        _ => None,
    }
}

/// The one component that changes, and the vector without it.
pub(super) fn varying<'m>(
    sketch: &mut Sketch<'_, 'm>,
    components: &'m [Expr],
) -> Option<(usize, Vn<'m>)> {
    let numbers = components.iter();
    let numbers: Vec<Ex> = numbers
        .map(|component| {
            let value = sketch.algebra.translate(component);
            scalar::number(sketch.algebra, &value)
        })
        .collect();
    let changes = 0..numbers.len();
    let changes: Vec<usize> = changes
        .filter(|&k| !dependence::inputs_below(sketch.algebra, &[numbers[k]]).is_empty())
        .collect();
    let [varying] = changes[..] else { return None };
    let mut rest: Vec<NodeId> = numbers.into_iter().map(Ex::id).collect();
    rest[varying] = sketch.algebra.graph.zero();
    Some((varying, sketch.algebra.graph.components(&rest)))
}
