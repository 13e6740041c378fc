//! Curved slots.

use crate::model::dispatch::resolve_expression;
use crate::model::expression::argument_use::refuse_argument;
use crate::model::expression::clause_values::{check_scalar, refuse_clause};
use crate::model::expression::nodes::make_expr;
use crate::model::symbols::scope::Scope;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::Context;
use crate::model::types::{Arc, Dimension, Expr, ExprKind, Function, Type};
use crate::syntax::{self, ArcItem};

/// `arc NAME: point around point [turned by angle];`
pub(in crate::model) fn resolve_arc(scope: &Scope, sink: &mut Sink, item: &ArcItem) -> Arc {
    Arc {
        name: item.name.to_string(),
        slider: resolve_point(scope, sink, &item.slider, "arc"),
        centre: resolve_point(scope, sink, &item.centre, "around"),
        direction: resolve_direction(scope, sink, item),
    }
}

/// Returns a point of the plane.
fn resolve_point(scope: &Scope, sink: &mut Sink, expr: &syntax::Expr, word: &str) -> Expr {
    let mut value = resolve_expression(scope, sink, expr, Context::MECHANICS);
    refuse_argument(&scope.names, &scope.values, sink, &mut value, "an arc");
    value.settle(&Type::Vector(2, Dimension::LENGTH));
    match &value.ty {
        Type::Vector(2, dimension) if dimension.fits(Dimension::LENGTH) => value,
        _ => refuse_clause(
            &scope.names,
            sink,
            value,
            word,
            "a point of the plane",
            "arc slot: p around c",
        ),
    }
}

/// Returns the unit vector that turns with the link that has the slot.
fn resolve_direction(scope: &Scope, sink: &mut Sink, item: &ArcItem) -> Expr {
    let ty = Type::Vector(2, Dimension::NUMBER);
    let Some(turned) = &item.turned else {
        let span = (&item.name).into();
        let number = Type::Scalar(Dimension::NUMBER);
        let components =
            [1.0, 0.0].map(|value| make_expr(sink, ExprKind::Number(value), number.clone(), span));
        return make_expr(sink, ExprKind::Vector(components.into()), ty, span);
    };
    let mut value = resolve_expression(scope, sink, turned, Context::MECHANICS);
    refuse_argument(&scope.names, &scope.values, sink, &mut value, "an arc");
    let angle = check_scalar(
        &scope.names,
        sink,
        value,
        Dimension::ANGLE,
        "turned by",
        "theta",
    );
    let kind = ExprKind::Call(Function::Dir, vec![angle]);
    make_expr(sink, kind, ty, turned.span)
}
