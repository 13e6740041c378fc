//! Sums, products, and the dimension that zero takes from its surroundings.

use super::agreement::{refuse_compound, refuse_mismatch};
use super::missing_units::suspect_both_units;
use super::nodes::{error_expr, make_expr};
use super::plane_and_space::both_types;
use crate::diagnostic::SourceSpan;
use crate::model::symbols::assumed_units::AssumedUnits;
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::sink::Sink;
use crate::model::types::{BinaryOp, Dimension, Expr, ExprKind, Type};

pub(in crate::model) fn make_negation(
    names: &Names,
    sink: &mut Sink,
    value: Expr,
    span: SourceSpan,
) -> Expr {
    if refuse_compound(names, sink, &value) {
        return error_expr(sink, span);
    }
    let ty = value.ty.clone();
    make_expr(sink, ExprKind::Negate(Box::new(value)), ty, span)
}

pub(in crate::model) fn make_binary(
    names: &Names,
    units: &AssumedUnits,
    sink: &mut Sink,
    operator: BinaryOp,
    mut left: Expr,
    mut right: Expr,
    span: SourceSpan,
) -> Expr {
    let refused = [
        refuse_compound(names, sink, &left),
        refuse_compound(names, sink, &right),
    ]
    .contains(&true);
    if refused || left.ty.is_error() || right.ty.is_error() {
        return error_expr(sink, span);
    }
    let ty = match operator {
        BinaryOp::Add | BinaryOp::Sub => {
            sum_type(names, units, sink, operator, &mut left, &mut right, span)
        }
        BinaryOp::Mul => product_type(sink, &mut left, &mut right, span),
        BinaryOp::Div => quotient_type(sink, &mut left, &mut right, span),
    };
    match ty {
        Some(ty) => {
            let kind = ExprKind::Binary(operator, Box::new(left), Box::new(right));
            make_expr(sink, kind, ty, span)
        }
        None => error_expr(sink, span),
    }
}

fn sum_type(
    names: &Names,
    units: &AssumedUnits,
    sink: &mut Sink,
    operator: BinaryOp,
    left: &mut Expr,
    right: &mut Expr,
    span: SourceSpan,
) -> Option<Type> {
    if let Some(ty) = Type::common(&left.ty, &right.ty) {
        left.settle(&ty);
        right.settle(&ty);
        return Some(ty);
    }
    suspect_both_units(units, sink, left, right);
    let (first, second) = both_types(names, left, right);
    let fact = match operator {
        BinaryOp::Sub => format!("cannot subtract {second} from {first}"),
        _ => format!("cannot add {first} and {second}"),
    };
    refuse_mismatch(names, units, sink, [left, right], fact, span);
    None
}

fn product_type(
    sink: &mut Sink,
    left: &mut Expr,
    right: &mut Expr,
    span: SourceSpan,
) -> Option<Type> {
    settle_alone(left);
    settle_alone(right);
    if let (Type::Vector(left_count, _), Type::Vector(right_count, _)) = (&left.ty, &right.ty) {
        let fact = format!("a product of two vectors ({left_count} and {right_count} components)");
        sink.error_with_help(span, fact, "write `dot(a, b)` or `cross(a, b)`");
        return None;
    }
    let shape = if matches!(left.ty, Type::Vector(..)) {
        &left.ty
    } else {
        &right.ty
    };
    let dimension = left.ty.dimension()?.times(right.ty.dimension()?);
    let dimension = dimension.map(Dimension::of_arithmetic);
    check_power_range(sink, dimension.map(|dimension| shape.with(dimension)), span)
}

fn quotient_type(
    sink: &mut Sink,
    left: &mut Expr,
    right: &mut Expr,
    span: SourceSpan,
) -> Option<Type> {
    settle_alone(left);
    settle_alone(right);
    if matches!(right.ty, Type::Vector(..)) {
        let help = "divide by `norm(v)` or by a component";
        sink.error_with_help(span, "cannot divide by a vector", help);
        return None;
    }
    let dimension = left.ty.dimension()?.over(right.ty.dimension()?);
    let dimension = dimension.map(Dimension::of_arithmetic);
    check_power_range(
        sink,
        dimension.map(|dimension| left.ty.with(dimension)),
        span,
    )
}

pub(in crate::model) fn check_power_range(
    sink: &mut Sink,
    ty: Option<Type>,
    span: SourceSpan,
) -> Option<Type> {
    if ty.is_none() {
        let fact = "the power of length is beyond 32 or not a multiple of one half";
        sink.error_with_help(span, fact, "divide by a length first");
    }
    ty
}

/// Makes zero a number where nothing gives it another dimension.
pub(in crate::model) fn settle_alone(value: &mut Expr) {
    let ty = value.ty.settled();
    value.settle(&ty);
}
