//! Values of clauses: scalars, points, vectors.

use super::super::argument::refuse_argument;
use super::super::expression::resolve_expression;
use super::super::place::Context;
use super::super::scope::Scope;
use super::super::sink::Sink;
use super::super::types::{Dimension, Expr};
use super::clause_values::{check_scalar, check_vector};
use crate::syntax;

/// A scalar of a dimension.
pub(super) fn resolve_scalar(
    scope: &Scope,
    sink: &mut Sink,
    expr: &syntax::Expr,
    wanted: Dimension,
    word: &str,
    example: &str,
) -> Expr {
    let value = resolve_expression(scope, sink, expr, Context::MECHANICS);
    check_scalar(&scope.names, sink, value, wanted, word, example)
}

/// The point where something is; it moves with the mechanism alone.
pub(super) fn resolve_point(scope: &Scope, sink: &mut Sink, expr: &syntax::Expr) -> Expr {
    let mut value = resolve_vector(scope, sink, expr, Some(Dimension::LENGTH), "at", "(0, 0)");
    refuse_argument(&scope.names, &scope.values, sink, &mut value, "a point");
    value
}

/// The guide of a slide, an axis: of any length.
pub(super) fn resolve_direction(
    scope: &Scope,
    sink: &mut Sink,
    expr: &syntax::Expr,
    word: &str,
) -> Expr {
    let mut value = resolve_vector(scope, sink, expr, None, word, "dir(phi)");
    refuse_argument(&scope.names, &scope.values, sink, &mut value, "a direction");
    value
}

/// A vector of a dimension, if one is given, and of as many components as all points have.
pub(super) fn resolve_vector(
    scope: &Scope,
    sink: &mut Sink,
    expr: &syntax::Expr,
    wanted: Option<Dimension>,
    word: &str,
    example: &str,
) -> Expr {
    let value = resolve_expression(scope, sink, expr, Context::MECHANICS);
    check_vector(
        &scope.names,
        &scope.units,
        sink,
        value,
        wanted,
        word,
        example,
    )
}
