//! Frames where none can be: values of items, sides of loops, operands of derivatives.

use super::frame_parts::frame_parts_help;
use super::nodes::error_expr;
use crate::diagnostic::SourceSpan;
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::sink::Sink;
use crate::model::types::{Expr, Type};

/// A frame as the value of an item that is no `let`: reported, and then an error.
pub(in crate::model) fn refuse_frame_item(sink: &mut Sink, value: &mut Expr, rule: &str) {
    if value.ty.is_frame() {
        let span = sink.span(value.origin);
        let help = "declare what it consists of, and the frame with `let`";
        sink.error_with_help(span, format!("{rule}, found a frame"), help);
        *value = error_expr(sink, span);
    }
}

/// Frames as sides of a loop are one mistake.
pub(in crate::model) fn refuse_frame_loop(
    sink: &mut Sink,
    left: &mut Expr,
    right: &mut Expr,
    span: SourceSpan,
) {
    if left.ty.is_frame() || right.ty.is_frame() {
        let fact = "the sides of a loop are scalars or vectors, found a frame";
        let help = "write a loop for `.origin`, and loops for what the axes do, such as `dot(a.x, b.x) = 0`";
        sink.error_with_help(span, fact, help);
        [*left, *right] = [error_expr(sink, span), error_expr(sink, span)];
    }
}

/// Refuses derivatives of a frame: its parts have derivatives.
pub(in crate::model) fn refuse_frame_derivative(
    names: &Names,
    sink: &mut Sink,
    value: Expr,
) -> Expr {
    if !value.ty.is_frame() {
        return value;
    }
    let span = sink.span(value.origin);
    let help = frame_parts_help(names, "differentiate", &value);
    let help = match value.ty {
        Type::PlaneFrame => {
            format!("{help}, or `.angle`; `omega` and `alpha` say how it turns")
        }
        _ => format!("{help}; `omega` and `alpha` say how it turns"),
    };
    sink.error_with_help(span, "a frame has no derivative", help);
    error_expr(sink, span)
}
