//! Frames whose motion functions ask for.

use crate::model::expression::nodes::{error_expr, make_expr};
use crate::model::expression::operators::settle_alone;
use crate::model::symbols::operands::Operands;
use crate::model::symbols::sink::Sink;
use crate::model::types::{ANGLE_PART, Expr, ExprKind, Type, type_of_part};
use crate::syntax::{self};

/// Resolves the frame whose rotation is the quantity.
pub(in crate::model) fn resolve_turning(
    operands: Operands,
    sink: &mut Sink,
    word: &str,
    quantity: &syntax::Expr,
) -> Expr {
    let value = resolve_moving_frame(operands, sink, word, quantity);
    if value.ty == Type::PlaneFrame {
        // It turns by its angle.
        let span = sink.span(value.origin);
        let ty = type_of_part(&value.ty, ANGLE_PART);
        return make_expr(sink, ExprKind::Index(Box::new(value), ANGLE_PART), ty, span);
    }
    value
}

/// Resolves the frame whose motion is the quantity.
pub(in crate::model) fn resolve_moving_frame(
    operands: Operands,
    sink: &mut Sink,
    word: &str,
    quantity: &syntax::Expr,
) -> Expr {
    let mut value = operands.resolve(sink, quantity);
    settle_alone(&mut value);
    if value.ty.is_frame() || value.ty.is_error() {
        return value;
    }
    let fact = format!(
        "`{word}` is about the turning of a frame, found {}",
        value.ty
    );
    let help = "`frame(origin, x, z)` makes a frame, in the plane `frame(origin, x)`; of anything else ask for `velocity` and \
                `acceleration`";
    let span = sink.span(value.origin);
    sink.error_with_help(span, fact, help);
    error_expr(sink, span)
}
