//! The directions along which terms change their length.

use linkage_symbolic::{Ex, NodeId, Vn};

use crate::algebra::{Algebra, Translate, calls, derivatives::dependence, scalar};
use crate::model::{BinaryOp, Expr, ExprKind, Function, Type};
use crate::picture::marks::Slide;
use crate::picture::{expressions, layout, parts};

/// The unit vector along which a term changes its length, and the part of the term across it.
pub(super) fn direction_of<'m>(
    algebra: &mut Algebra<'m>,
    dimension: usize,
    term: &'m Expr,
) -> Option<Slide<'m>> {
    let input = expressions::driving(algebra.mechanism, term);
    let straight = |along: Vn<'m>| Slide {
        offset: None,
        along,
        input,
    };
    match &term.kind {
        ExprKind::Call(Function::Polar, arguments) => {
            let angle = algebra.translate(&arguments[1]);
            let unit = calls::call(&mut algebra.names, Function::Dir, vec![angle]);
            // In a picture of space, the plane is that of x and y.
            let along = scalar::vector(&algebra.names, &unit).resized(dimension);
            Some(straight(along))
        }
        ExprKind::Binary(BinaryOp::Mul, a, b) => {
            let vector = if matches!(a.ty, Type::Vector(..)) {
                a
            } else {
                b
            };
            Some(straight(layout::vector(algebra, dimension, vector).unit()))
        }
        ExprKind::Vector(components) => {
            let (varying, rest) = varying(algebra, components)?;
            Some(Slide {
                offset: Some(rest),
                along: layout::axis_of(algebra.graph, dimension, varying),
                input,
            })
        }
        ExprKind::Call(function @ (Function::Rotate | Function::Turn), arguments) => {
            let inner = direction_of(algebra, dimension, &arguments[0])?;
            let mut turn = |v| parts::turned_vector(algebra, *function, arguments, v);
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
    algebra: &mut Algebra<'m>,
    components: &'m [Expr],
) -> Option<(usize, Vn<'m>)> {
    let numbers = components.iter();
    let numbers: Vec<Ex> = numbers
        .map(|component| {
            let value = algebra.translate(component);
            scalar::number(&algebra.names, &value)
        })
        .collect();
    let changes = 0..numbers.len();
    let changes: Vec<usize> = changes
        .filter(|&k| {
            !dependence::inputs_below(
                algebra.graph,
                &mut algebra.derivatives.dependence,
                &[numbers[k]],
            )
            .is_empty()
        })
        .collect();
    let [varying] = changes[..] else { return None };
    let mut rest: Vec<NodeId> = numbers.into_iter().map(Ex::id).collect();
    rest[varying] = algebra.graph.zero();
    Some((varying, algebra.graph.components(&rest)))
}
