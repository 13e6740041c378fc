//! `d`, `velocity`, `acceleration`, `jerk`, `omega`, `alpha`, `sensitivity`, `margin`: known only
//! in the functions of the `impl` block.

use super::input_derivative::{
    listed_inputs, make_derivative, make_unless_error, refuse_several_inputs, type_by_variable,
};
use super::moving_frame::resolve_turning;
use super::variable::{all_scalar_parameters, resolve_listed_parameters, resolve_variable};
use crate::diagnostic::SourceSpan;
use crate::diagnostic::text::count;
use crate::model::expression::call_messages::{refuse_listed_input, refuse_wrong_count};
use crate::model::expression::frame_items::refuse_frame_derivative;
use crate::model::expression::nodes::{error_expr, make_expr};
use crate::model::expression::operators::settle_alone;
use crate::model::symbols::operands::Operands;
use crate::model::symbols::sink::Sink;
use crate::model::types::{Expr, ExprKind, MotionWord, Type, Variable};
use crate::syntax::{self, Word};

/// Most entries of an array, those of inner arrays counted.
const ENTRY_LIMIT: usize = 10_000;

pub(in crate::model) fn resolve_margin(
    sink: &mut Sink,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Expr {
    if !arguments.is_empty() {
        refuse_wrong_count(sink, "margin", &[], arguments.len(), span);
        return error_expr(sink, span);
    }
    make_expr(sink, ExprKind::Margin, Type::NUMBER, span)
}

/// `d(q, x)`, `d(q, x, y)`
pub(in crate::model) fn resolve_derivative(
    operands: Operands,
    sink: &mut Sink,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Expr {
    let Some(([quantity], variables)) = arguments.split_first_chunk::<1>() else {
        refuse_wrong_count(sink, "d", &["quantity", "x"], 0, span);
        return error_expr(sink, span);
    };
    let value = resolve_differentiable(operands, sink, quantity);
    if !(1..=2).contains(&variables.len()) {
        let found = count(variables.len(), "variable");
        let fact = format!("`d` takes a quantity and one or two variables, found {found}");
        let help = "write `d(quantity, x)` or `d(quantity, x, y)`";
        sink.error_with_help(span, fact, help);
        return error_expr(sink, span);
    }
    let variables: Vec<_> = variables
        .iter()
        .map(|variable| resolve_variable(operands, sink, variable))
        .collect();
    let Some(variables) = variables.into_iter().collect::<Option<Vec<_>>>() else {
        return error_expr(sink, span);
    };
    let mut ty = value.ty.clone();
    for variable in &variables {
        ty = type_by_variable(
            &operands.scope.names,
            &operands.scope.values,
            &ty,
            *variable,
        );
    }
    make_unless_error(
        sink,
        ExprKind::Derivative(Box::new(value), variables),
        ty,
        span,
    )
}

pub(in crate::model) fn resolve_sensitivity(
    operands: Operands,
    sink: &mut Sink,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Expr {
    let (quantity, parameters) = match arguments {
        [quantity] => (
            quantity,
            all_scalar_parameters(&operands.scope.names, &operands.scope.values, sink, span),
        ),
        [quantity, list] => (quantity, resolve_listed_parameters(operands, sink, list)),
        _ => {
            let fact = format!(
                "`sensitivity` takes a quantity and perhaps a list of parameters, found {}",
                count(arguments.len(), "argument")
            );
            let help = "write `sensitivity(q)` or `sensitivity(q, [crank, rocker])`";
            sink.error_with_help(span, fact, help);
            return error_expr(sink, span);
        }
    };
    let value = resolve_differentiable(operands, sink, quantity);
    let Some(parameters) = parameters else {
        return error_expr(sink, span);
    };
    if refuse_too_many_entries(sink, &value.ty, parameters.len(), span) {
        return error_expr(sink, span);
    }
    let variables = parameters
        .iter()
        .map(|parameter| Variable::Parameter(*parameter));
    let entries = variables
        .map(|variable| {
            type_by_variable(
                &operands.scope.names,
                &operands.scope.values,
                &value.ty,
                variable,
            )
        })
        .collect();
    let kind = ExprKind::Sensitivity(Box::new(value), parameters);
    make_unless_error(sink, kind, Type::Array(entries), span)
}

pub(in crate::model) fn resolve_input_derivative(
    operands: Operands,
    sink: &mut Sink,
    word: MotionWord,
    inputs: Option<&[usize]>,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Expr {
    let (name, order) = (word.word(), word.order().unwrap_or_default());
    let subject = if word.turns() { "frame" } else { "quantity" };
    let [quantity] = arguments else {
        match arguments {
            [quantity, variable] if !word.turns() => {
                refuse_listed_input(sink, name, order, [quantity, variable], span);
            }
            _ => refuse_wrong_count(sink, name, &[subject], arguments.len(), span),
        }
        return error_expr(sink, span);
    };
    let value = if word.turns() {
        resolve_turning(operands, sink, name, quantity)
    } else {
        resolve_differentiable(operands, sink, quantity)
    };
    // A mistake in the list of inputs has been reported.
    let Some(inputs) = inputs else {
        return error_expr(sink, span);
    };
    let Some(inputs) = listed_inputs(
        &operands.scope.names,
        &operands.scope.values,
        sink,
        name,
        inputs,
        span,
    ) else {
        return error_expr(sink, span);
    };
    if word == MotionWord::Jerk && inputs.len() > 1 {
        let help = "differentiate an entry: `d(acceleration(q)[0][0], x)`";
        refuse_several_inputs(sink, name, inputs.len(), help, span);
        return error_expr(sink, span);
    }
    let entries = inputs.len().pow(u32::from(order));
    if refuse_too_many_entries(sink, &value.ty, entries, span) {
        return error_expr(sink, span);
    }
    make_derivative(
        &operands.scope.names,
        &operands.scope.values,
        sink,
        value,
        &inputs,
        order,
        span,
    )
}

/// Derivatives of arrays multiply the numbers of entries.
fn refuse_too_many_entries(sink: &mut Sink, ty: &Type, factor: usize, span: SourceSpan) -> bool {
    let entries = leaves(ty).saturating_mul(factor);
    if entries > ENTRY_LIMIT {
        let fact = format!("an array of {entries} entries, more than {ENTRY_LIMIT}");
        let help = "differentiate single entries `[0]` or by a list of parameters";
        sink.error_with_help(span, fact, help);
    }
    entries > ENTRY_LIMIT
}

/// The first argument: anything but an array literal or a frame; zero is a number.
fn resolve_differentiable(operands: Operands, sink: &mut Sink, quantity: &syntax::Expr) -> Expr {
    let mut value = operands.resolve(sink, quantity);
    settle_alone(&mut value);
    refuse_frame_derivative(&operands.scope.names, sink, value)
}

fn leaves(ty: &Type) -> usize {
    match ty {
        Type::Array(entries) => entries.iter().map(leaves).sum(),
        Type::Scalar(_)
        | Type::Vector(..)
        | Type::Frame
        | Type::PlaneFrame
        | Type::Zero(_)
        | Type::Error => 1,
    }
}
