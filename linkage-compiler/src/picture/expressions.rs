//! Facts about expressions that depend on the mechanism alone.

use crate::model::{BinaryOp, Dimension, Expr, ExprKind, Loop, Mechanism, Name, Type};
use crate::picture::point_or_vector::Roles;
use crate::picture::weights;

/// The input that is a length in an expression.
pub(super) fn driving(mechanism: &Mechanism, expr: &Expr) -> Option<usize> {
    expr.parts().find_map(|part| match part.as_name()? {
        Name::Input(input) => {
            let is_length = mechanism.inputs[input].dimension.fits(Dimension::LENGTH);
            is_length.then_some(input)
        }
        name => driving(mechanism, mechanism.value_of(name)?),
    })
}

/// True if a loop is one of the plane made of components of vectors of space: it is not known where
/// in space it lies.
pub(super) fn is_anywhere(mechanism: &Mechanism, dimension: usize, equation: &Loop) -> bool {
    let sides = [&equation.left, &equation.right];
    let is_vector = matches!(equation.left.ty, Type::Vector(..));
    is_vector
        && sides.iter().all(|side| is_flat(dimension, side))
        && sides.iter().any(|side| is_projection(mechanism, side))
}

/// True if it lies in a plane of a mechanism of space.
pub(super) fn is_flat(dimension: usize, expr: &Expr) -> bool {
    dimension == 3 && matches!(expr.ty, Type::Vector(2, _) | Type::Zero(_))
}

/// True if a vector of the plane has components of vectors of space: it may lie in any plane.
pub(super) fn is_projection(mechanism: &Mechanism, expr: &Expr) -> bool {
    expr.parts().any(|part| match &part.kind {
        ExprKind::Component(vector, _) => matches!(vector.ty, Type::Vector(3, _)),
        ExprKind::Name(name) => {
            let value = mechanism.value_of(*name);
            value.is_some_and(|value| is_projection(mechanism, value))
        }
        _ => false,
    })
}

/// `p` and `q` of a vector that is written as `p - q`.
pub(super) fn difference<'m>(
    mechanism: &'m Mechanism,
    vector: &'m Expr,
) -> Option<(&'m Expr, &'m Expr)> {
    match &vector.kind {
        ExprKind::Binary(BinaryOp::Sub, p, q) => Some((p, q)),
        ExprKind::Name(Name::Let(index)) => difference(mechanism, &mechanism.lets[*index].value),
        _ => None,
    }
}

/// The names of points in an expression.
pub(super) fn points_in<'m>(mechanism: &Mechanism, roles: &Roles, expr: &'m Expr) -> Vec<&'m Expr> {
    let names = expr.parts().filter(|part| part.as_name().is_some());
    names
        .filter(|name| weights::weight(mechanism, roles, name) == Some(1.0))
        .collect()
}

/// The derived quantity that an unknown frame is, and its name.
pub(super) fn unknown_frame<'m>(
    mechanism: &'m Mechanism,
    frame: &'m Expr,
) -> Option<(usize, String)> {
    let ExprKind::Name(Name::Let(index)) = frame.kind else {
        return None;
    };
    let item = &mechanism.lets[index];
    item.is_unknown_frame.then(|| (index, item.name.clone()))
}

pub(super) fn spoken(mechanism: &Mechanism, expr: &Expr) -> Option<String> {
    let name = expr.as_name()?;
    Some(mechanism.name(name).to_owned())
}

/// The first length that is named in an expression.
pub(super) fn dimension_in(mechanism: &Mechanism, expr: &Expr) -> Option<String> {
    let mut lengths = expr.parts().filter(|part| {
        let dimension = part.ty.dimension();
        dimension.is_some_and(|dimension| dimension.half_lengths == 2)
    });
    lengths.find_map(|length| spoken(mechanism, length))
}
