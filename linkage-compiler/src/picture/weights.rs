//! The number of times that a vector counts as a point.

use crate::model::{BinaryOp, Expr, ExprKind, Function, Mechanism, Name, Type};
use crate::picture::marks::Term;
use crate::picture::point_or_vector::Roles;

/// The number of times that a vector counts as a point: 1 for a point, 0 for a difference; `None`
/// if it may be either.
pub(super) fn weight(mechanism: &Mechanism, roles: &Roles, expr: &Expr) -> Option<f64> {
    let is_length = expr
        .ty
        .dimension()
        .is_some_and(|dimension| dimension.half_lengths == 2);
    match &expr.kind {
        // A direction.
        _ if !is_length => None,
        _ if mechanism.standing(expr).is_some() => Some(1.0),
        ExprKind::Name(name @ (Name::Let(_) | Name::Unknown(_))) => {
            Some(if roles.is_step(*name) { 0.0 } else { 1.0 })
        }
        ExprKind::Index(..) | ExprKind::Call(Function::PointIn, _) => Some(1.0),
        ExprKind::Negate(a) => weight(mechanism, roles, a).map(|weight| -weight),
        ExprKind::Binary(op @ (BinaryOp::Add | BinaryOp::Sub), a, b) => {
            let (a, b) = (weight(mechanism, roles, a), weight(mechanism, roles, b));
            let sign = if *op == BinaryOp::Add { 1.0 } else { -1.0 };
            match (a, b) {
                (None, None) => None,
                _ => Some(a.unwrap_or(0.0) + sign * b.unwrap_or(0.0)),
            }
        }
        ExprKind::Binary(BinaryOp::Div, a, b) => scaled(mechanism, roles, a, |n| 1.0 / n, b),
        ExprKind::Binary(BinaryOp::Mul, a, b) => match a.ty {
            Type::Vector(..) => scaled(mechanism, roles, a, |n| n, b),
            _ => scaled(mechanism, roles, b, |n| n, a),
        },
        // A step, a mean, a parameter: whatever the others make of it.
        _ => None,
    }
}

/// The weight of a multiple of a vector.
pub(super) fn scaled(
    mechanism: &Mechanism,
    roles: &Roles,
    vector: &Expr,
    by: impl Fn(f64) -> f64,
    factor: &Expr,
) -> Option<f64> {
    match (weight(mechanism, roles, vector)?, &factor.kind) {
        (0.0, _) => Some(0.0),
        (weight, ExprKind::Number(number)) => Some(weight * by(*number)),
        // No point that chains could begin with.
        _ => Some(f64::NAN),
    }
}

/// The number of times that a term counts as a point.
pub(super) fn weight_of(mechanism: &Mechanism, roles: &Roles, term: &Term) -> f64 {
    if term.part.is_some() {
        return 0.0;
    }
    term.sign * weight(mechanism, roles, term.expr).unwrap_or(0.0)
}
