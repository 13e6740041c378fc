//! Expressions: everything but calls, which `function_call` resolves.

use super::function_call::resolve_call;
use crate::model::expression::composite::{make_component, make_entry, make_vector};
use crate::model::expression::link_messages::{refuse_misspelt_link, refuse_unknown_quantity};
use crate::model::expression::literal::resolve_number;
use crate::model::expression::look_up::look_up_name;
use crate::model::expression::nodes::{error_expr, make_expr};
use crate::model::expression::operators::{make_binary, make_negation};
use crate::model::expression::part_member::resolve_member;
use crate::model::expression::products::{refuse_lonely_power, resolve_product};
use crate::model::symbols::operands::Operands;
use crate::model::symbols::scope::Scope;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::Context;
use crate::model::types::{BinaryOp, Expr, ExprKind};
use crate::syntax;

/// Returns the operands of an expression in this place.
pub(super) fn operands<'a>(scope: &'a Scope, context: Context<'a>) -> Operands<'a> {
    Operands {
        scope,
        context,
        expression: resolve_expression,
    }
}

/// Resolves an expression of the syntax tree: names, types, units.
pub(super) fn resolve_expression(
    scope: &Scope,
    sink: &mut Sink,
    expr: &syntax::Expr,
    context: Context,
) -> Expr {
    let span = expr.span;
    let operands = operands(scope, context);
    match &expr.kind {
        syntax::ExprKind::Number { text, suffix } => {
            resolve_number(&scope.units, sink, text, suffix, span)
        }
        syntax::ExprKind::Name(ident) => match look_up_name(scope, sink, ident, context) {
            Some((name, ty)) => make_expr(sink, ExprKind::Name(name), ty, span),
            None => error_expr(sink, span),
        },
        syntax::ExprKind::Tuple(components) => {
            let components = operands.resolve_all(sink, components);
            make_vector(&scope.names, &scope.units, sink, components, span)
        }
        syntax::ExprKind::Field(value, field) => match scope.parts.owner_of(value, field) {
            Some(path) => resolve_member(
                &scope.names,
                &scope.parts,
                sink,
                &path,
                field,
                context,
                span,
            ),
            None => {
                if let syntax::ExprKind::Name(link) = &value.kind
                    && scope.names.find(&link.to_string()).is_none()
                {
                    let (parts, links) = (&scope.parts, &scope.members.links);
                    if refuse_unknown_quantity(parts, links, sink, link, field)
                        || refuse_misspelt_link(parts, links, sink, link, field)
                    {
                        return error_expr(sink, span);
                    }
                }
                let value = resolve_expression(scope, sink, value, context);
                make_component(&scope.names, sink, value, field, span)
            }
        },
        syntax::ExprKind::Index(value, index) => {
            let value = resolve_expression(scope, sink, value, context);
            make_entry(sink, value, index, span)
        }
        syntax::ExprKind::Negate(value) => {
            let value = resolve_expression(scope, sink, value, context);
            make_negation(&scope.names, sink, value, span)
        }
        syntax::ExprKind::Binary(syntax::BinaryOp::Mul | syntax::BinaryOp::Div, ..) => {
            resolve_product(operands, sink, expr)
        }
        syntax::ExprKind::Binary(..) => resolve_sum(scope, sink, expr, context),
        syntax::ExprKind::Call(function, arguments) => {
            resolve_call(operands, sink, function, arguments, span)
        }
        syntax::ExprKind::List(_) => {
            let fact = "a list in brackets cannot stand here";
            let help = "write a vector as `(x, y)`; a list is the second argument of \
                        `sensitivity`";
            sink.error_with_help(span, fact, help);
            error_expr(sink, span)
        }
        syntax::ExprKind::Power(base, power) => {
            refuse_lonely_power(&scope.names, &scope.members, sink, base, *power, span)
        }
        syntax::ExprKind::Error => error_expr(sink, span),
    }
}

/// Resolves a sum term by term, from the left.
fn resolve_sum(scope: &Scope, sink: &mut Sink, sum: &syntax::Expr, context: Context) -> Expr {
    // Terms are collected first: a recursion as deep as a long sum would not fit the stack.
    let mut terms = Vec::new();
    let mut first = sum;
    while let syntax::ExprKind::Binary(
        operator @ (syntax::BinaryOp::Add | syntax::BinaryOp::Sub),
        left,
        right,
    ) = &first.kind
    {
        terms.push((BinaryOp::from(*operator), right, first.span));
        first = left;
    }
    let first = resolve_expression(scope, sink, first, context);
    terms
        .into_iter()
        .rev()
        .fold(first, |left, (operator, right, span)| {
            let right = resolve_expression(scope, sink, right, context);
            let (names, units) = (&scope.names, &scope.units);
            make_binary(names, units, sink, operator, left, right, span)
        })
}

impl From<syntax::BinaryOp> for BinaryOp {
    fn from(operator: syntax::BinaryOp) -> Self {
        match operator {
            syntax::BinaryOp::Add => BinaryOp::Add,
            syntax::BinaryOp::Sub => BinaryOp::Sub,
            syntax::BinaryOp::Mul => BinaryOp::Mul,
            syntax::BinaryOp::Div => BinaryOp::Div,
        }
    }
}
