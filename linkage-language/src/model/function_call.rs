//! Calls: argument counts and dimensions.

use proc_macro2::Ident;

use crate::diagnostic::SourceSpan;
use crate::model::expression::agreement::refuse_compound;
use crate::model::expression::call_messages::{refuse_count_of_arguments, refuse_unknown_function};
use crate::model::expression::function_types::result_type;
use crate::model::expression::nodes::{error_expr, make_expr};
use crate::model::motion_law::motion_law_call::resolve_motion_law;
use crate::model::quantity::quantity_call::resolve_quantity;
use crate::model::symbols::operands::Operands;
use crate::model::symbols::sink::Sink;
use crate::model::types::{Expr, ExprKind, Function, MotionLawWord, QuantityWord};
use crate::syntax::{self, Word};

pub(super) fn resolve_call(
    operands: Operands,
    sink: &mut Sink,
    ident: &Ident,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Expr {
    let name = ident.to_string();
    if let Some(quantity) = QuantityWord::from_word(&name) {
        return resolve_quantity(operands, sink, quantity, ident, arguments, span);
    }
    if let Some(course) = MotionLawWord::from_word(&name) {
        return resolve_motion_law(operands, sink, course, arguments, span);
    }
    let Some(function) = Function::from_word(&name) else {
        refuse_unknown_function(&operands.scope.names, sink, ident);
        operands.resolve_all(sink, arguments);
        return error_expr(sink, span);
    };
    let mut arguments = operands.resolve_all(sink, arguments);
    if !function.takes_count(arguments.len()) {
        refuse_count_of_arguments(sink, function, arguments.len(), span);
        return error_expr(sink, span);
    }
    let refused = arguments
        .iter()
        .filter(|argument| {
            !function.takes(&argument.ty) && refuse_compound(&operands.scope.names, sink, argument)
        })
        .count();
    if refused > 0 || arguments.iter().any(|argument| argument.ty.is_error()) {
        return error_expr(sink, span);
    }
    match result_type(
        &operands.scope.names,
        &operands.scope.units,
        sink,
        function,
        &mut arguments,
        span,
    ) {
        Some(ty) => make_expr(sink, ExprKind::Call(function, arguments), ty, span),
        None => error_expr(sink, span),
    }
}
