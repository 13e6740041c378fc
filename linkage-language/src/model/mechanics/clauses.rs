//! Values of clauses: scalars, points, vectors.

use crate::model::dispatch::resolve_expression;
use crate::model::expression::argument_use::refuse_argument;
use crate::model::expression::clause_values::{check_scalar, check_vector};
use crate::model::symbols::scope::Scope;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::Context;
use crate::model::types::{Dimension, Expr};
use crate::syntax;

/// A scalar of a dimension.
pub(in crate::model) fn resolve_scalar(
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
pub(in crate::model) fn resolve_point(scope: &Scope, sink: &mut Sink, expr: &syntax::Expr) -> Expr {
    let mut value = resolve_vector(scope, sink, expr, Some(Dimension::LENGTH), "at", "(0, 0)");
    refuse_argument(&scope.names, &scope.values, sink, &mut value, "a point");
    value
}

/// The guide of a slide, an axis: of any length.
pub(in crate::model) fn resolve_direction(
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
pub(in crate::model) fn resolve_vector(
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
