//! Numbers as they are written, with or without a unit.

use super::nodes::{error_expr, make_expr};
use crate::diagnostic::SourceSpan;
use crate::model::symbols::assumed_units::AssumedUnits;
use crate::model::symbols::sink::Sink;
use crate::model::types::{Expr, ExprKind, Type};
use crate::model::units::conversion::{Literal, convert};

pub(in crate::model) fn resolve_number(
    units: &AssumedUnits,
    sink: &mut Sink,
    text: &str,
    suffix: &str,
    span: SourceSpan,
) -> Expr {
    let converted = convert(text, suffix, units.length);
    make_literal(sink, converted, &format!("`{text}{suffix}`"), span)
}

/// A converted number; `what` it is in messages.
pub(in crate::model) fn make_literal(
    sink: &mut Sink,
    converted: Literal,
    what: &str,
    span: SourceSpan,
) -> Expr {
    let problem = match converted {
        Literal::BareZero => return make_expr(sink, ExprKind::Number(0.0), Type::Zero(1), span),
        Literal::Value(value, dimension) => {
            return make_expr(sink, ExprKind::Number(value), Type::Scalar(dimension), span);
        }
        Literal::TooLarge => "too large for a 64-bit number",
        Literal::TooSmall => "so small that it becomes zero",
        Literal::Beyond => "in a power of a unit beyond all use",
        Literal::Malformed => "not a number with a unit",
    };
    let fact = format!("{what} is {problem}");
    sink.error_with_help(span, fact, "check the exponent and the unit");
    error_expr(sink, span)
}
