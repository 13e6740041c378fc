//! Dimensions of the values in a drawing, before names and units are resolved: only as far as
//! messages about joints and links need them.

use super::drawing::Drawing;
use crate::model::types::Function;
use crate::syntax::{BinaryOp, Expr, ExprKind, Word, find_unit};

/// Nested names and operations: more are a mistake, or a circle of names.
const DEPTH: usize = 64;

/// The dimension of a value, or of the components of a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Measure {
    /// A zero without a unit, which is of any dimension.
    Zero,
    Number,
    Length,
    Angle,
    /// Another dimension, or an unknown one.
    Other,
}

/// Returns the dimension of a value.
pub(super) fn measure(drawing: &Drawing, value: &Expr) -> Measure {
    measured(drawing, value, DEPTH)
}

fn measured(drawing: &Drawing, value: &Expr, depth: usize) -> Measure {
    let Some(depth) = depth.checked_sub(1) else {
        return Measure::Other;
    };
    let inner = |value: &Expr| measured(drawing, value, depth);
    match &value.kind {
        ExprKind::Number { text, suffix } => of_number(text, suffix),
        ExprKind::Name(name) => match drawing.value(&name.to_string()) {
            Some(value) => inner(value),
            None if name == "PI" => Measure::Number,
            None => Measure::Other,
        },
        ExprKind::Negate(value) => inner(value),
        ExprKind::Tuple(components) => components.iter().map(inner).fold(Measure::Zero, of_sum),
        ExprKind::Binary(operator, left, right) => {
            let (left, right) = (inner(left), inner(right));
            match operator {
                BinaryOp::Add | BinaryOp::Sub => of_sum(left, right),
                BinaryOp::Mul => match (left, right) {
                    (Measure::Number, other) | (other, Measure::Number) => other,
                    _ => Measure::Other,
                },
                BinaryOp::Div => match (left, right) {
                    (other, Measure::Number) => other,
                    (left, right) if left == right => Measure::Number,
                    _ => Measure::Other,
                },
            }
        }
        ExprKind::Call(function, arguments) => {
            let first = arguments.first().map_or(Measure::Other, inner);
            of_call(&function.to_string(), first)
        }
        ExprKind::Field(..)
        | ExprKind::Index(..)
        | ExprKind::Power(..)
        | ExprKind::List(_)
        | ExprKind::Error => Measure::Other,
    }
}

fn of_number(text: &str, suffix: &str) -> Measure {
    if suffix.is_empty() {
        let is_zero = text.parse::<f64>().is_ok_and(|number| number == 0.0);
        return match is_zero {
            true => Measure::Zero,
            false => Measure::Number,
        };
    }
    let Some(unit) = find_unit(suffix) else {
        return Measure::Other;
    };
    match (unit.kilograms, unit.newtons, unit.metres, unit.seconds) {
        (0, 0, 0, 0) if unit.angle => Measure::Angle,
        (0, 0, 1, 0) => Measure::Length,
        _ => Measure::Other,
    }
}

fn of_sum(left: Measure, right: Measure) -> Measure {
    match (left, right) {
        (Measure::Zero, other) | (other, Measure::Zero) => other,
        (left, right) if left == right => left,
        _ => Measure::Other,
    }
}

/// Returns the dimension of a call by that of its first argument.
fn of_call(function: &str, first: Measure) -> Measure {
    match Function::from_word(function) {
        Some(
            Function::Polar
            | Function::Rotate
            | Function::Turn
            | Function::Norm
            | Function::Abs
            | Function::Distance
            | Function::Hypot
            | Function::Min
            | Function::Max,
        ) => first,
        Some(
            Function::Angle
            | Function::TriangleAngle
            | Function::Asin
            | Function::Acos
            | Function::Atan
            | Function::Atan2,
        ) => Measure::Angle,
        Some(Function::Dir | Function::Unit | Function::Sin | Function::Cos | Function::Tan) => {
            Measure::Number
        }
        Some(
            Function::Sqrt
            | Function::Dot
            | Function::Cross
            | Function::Frame
            | Function::PointIn
            | Function::CoordinatesIn,
        )
        | None => Measure::Other,
    }
}
