//! Slopes of functions of numbers, as expressions of the language.

use crate::model::types::{BinaryOp, Dimension, Expr, ExprKind, Function, Type};

/// Returns the derivatives of a function's value with respect to its arguments; `None` if the
/// language has no expression for them.
pub(in crate::model) fn slopes(
    function: Function,
    arguments: &[Expr],
    value: &Expr,
) -> Option<Vec<Expr>> {
    use BinaryOp::{Add, Div, Mul, Sub};
    let number = |number: f64| Expr {
        kind: ExprKind::Number(number),
        ty: Type::NUMBER,
        origin: value.origin,
    };
    let call = |function, operand: &Expr, ty: Type| Expr {
        kind: ExprKind::Call(function, vec![operand.clone()]),
        ty,
        origin: value.origin,
    };
    let negative = |value: Expr| Expr {
        ty: value.ty.clone(),
        origin: value.origin,
        kind: ExprKind::Negate(Box::new(value)),
    };
    let square = |value: &Expr| of_both(Mul, value.clone(), value.clone());
    let over = |a: Expr, b: Expr| of_both(Div, a, b);
    let [a, b] = [arguments.first()?, arguments.last()?];
    let are_numbers = arguments
        .iter()
        .all(|argument| matches!(argument.ty, Type::Scalar(_)));
    if !are_numbers {
        return None;
    }
    // The root of 1 - a^2, of which the slopes of arc sine and cosine are made.
    let across = || {
        let rest = of_both(Sub, number(1.0), square(a));
        call(Function::Sqrt, &rest, Type::NUMBER)
    };
    Some(match function {
        Function::Sin => vec![call(Function::Cos, a, Type::NUMBER)],
        Function::Cos => vec![negative(call(Function::Sin, a, Type::NUMBER))],
        Function::Tan => vec![of_both(Add, number(1.0), square(value))],
        Function::Asin => vec![over(number(1.0), across())],
        Function::Acos => vec![negative(over(number(1.0), across()))],
        Function::Atan => vec![over(number(1.0), of_both(Add, number(1.0), square(a)))],
        Function::Atan2 => {
            let sum = of_both(Add, square(a), square(b));
            vec![over(b.clone(), sum.clone()), negative(over(a.clone(), sum))]
        }
        Function::Sqrt => vec![over(number(0.5), value.clone())],
        Function::Hypot => vec![
            over(a.clone(), value.clone()),
            over(b.clone(), value.clone()),
        ],
        Function::Abs => vec![over(value.clone(), a.clone())],
        // Functions of vectors, and functions whose slope is no expression of the language.
        Function::Polar
        | Function::Dir
        | Function::Rotate
        | Function::Turn
        | Function::Dot
        | Function::Cross
        | Function::Norm
        | Function::Distance
        | Function::Unit
        | Function::Angle
        | Function::TriangleAngle
        | Function::Min
        | Function::Max
        | Function::Frame
        | Function::PointIn
        | Function::CoordinatesIn => return None,
    })
}

/// Returns a sum, product or quotient of scalars. Their powers occur in some mechanism, so none is
/// too large.
pub(in crate::model) fn of_both(operator: BinaryOp, a: Expr, b: Expr) -> Expr {
    let dimensions = [&a, &b].map(|operand| operand.ty.dimension().unwrap_or(Dimension::NUMBER));
    let [first, second] = dimensions;
    let dimension = match operator {
        BinaryOp::Add | BinaryOp::Sub => Some(first.or(second)),
        BinaryOp::Mul => first.times(second),
        BinaryOp::Div => first.over(second),
    };
    Expr {
        ty: dimension.map_or(Type::Error, Type::Scalar),
        origin: a.origin,
        kind: ExprKind::Binary(operator, Box::new(a), Box::new(b)),
    }
}
