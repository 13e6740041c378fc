//! Locations of parts.

use super::lets::add_let;
use crate::model::dispatch::resolve_expression;
use crate::model::expression::argument_use::refuse_argument;
use crate::model::expression::fitting::fit_to_type;
use crate::model::expression::missing_units::suspect_unit;
use crate::model::expression::nodes::error_expr;
use crate::model::symbols::assumed_units::AssumedUnits;
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::part_scopes::PartBody;
use crate::model::symbols::scope::Scope;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::Context;
use crate::model::types::{Dimension, Expr, ExprKind, Mechanism, Name, Placed, Type};
use crate::syntax::PartItem;

/// Resolves the location of the part.
pub(in crate::model) fn place_part(
    scope: &mut Scope,
    sink: &mut Sink,
    item: &PartItem,
    body: &PartBody,
    context: Context,
    mechanism: &mut Mechanism,
) {
    let at = place_value(
        scope,
        sink,
        item,
        "at",
        context,
        mechanism,
        |scope, sink, value| check_location(&scope.units, sink, value, item, body),
    );
    let turned = place_value(
        scope,
        sink,
        item,
        "turned",
        context,
        mechanism,
        |scope, sink, value| check_rotation(&scope.names, &scope.units, sink, value, item),
    );
    let in_space = |value: &Expr| value.ty.components() == Some(3) || value.ty == Type::Frame;
    if let (Some(at), Some(angle)) = (&at, &turned)
        && in_space(at)
    {
        let help = "write a frame for its place: `at frame(point, x, z)`";
        let fact = "a part in space is turned by its frame, not by an angle";
        let span = sink.span(angle.origin);
        sink.error_with_help(span, fact, help);
    }
    if at.is_some() || turned.is_some() {
        let path = item.name.to_string();
        let first = mechanism.loops.len();
        let loops = first..first + body.mechanism().loops.len();
        scope.parts.placed.push(Placed {
            path,
            at,
            turned,
            loops,
        });
    }
}

/// Resolves `at` or `turned` of a part, a derived quantity; returns its name.
fn place_value(
    scope: &mut Scope,
    sink: &mut Sink,
    item: &PartItem,
    name: &str,
    context: Context,
    mechanism: &mut Mechanism,
    check: impl Fn(&Scope, &mut Sink, Expr) -> Expr,
) -> Option<Expr> {
    let value = if name == "at" { &item.at } else { &item.turned };
    let value = value.as_ref()?;
    let what = format!("where the part `{}` stands", item.name);
    let mut value = resolve_expression(scope, sink, value, context);
    refuse_argument(&scope.names, &scope.values, sink, &mut value, &what);
    let value = check(scope, sink, value);
    let (ty, origin) = (value.ty.clone(), value.origin);
    let kind = ExprKind::Name(Name::Let(mechanism.lets.len()));
    add_let(&mut scope.values, mechanism, item, name, value);
    Some(Expr { kind, ty, origin })
}

/// A point, or a frame in space.
fn check_location(
    units: &AssumedUnits,
    sink: &mut Sink,
    mut value: Expr,
    item: &PartItem,
    body: &PartBody,
) -> Expr {
    if value.ty.is_error() {
        return value;
    }
    let points = components_of_points(body.mechanism());
    if let Type::Zero(count) = value.ty {
        let count = count.max(points.first().copied().unwrap_or(2));
        value.settle(&Type::Vector(count, Dimension::LENGTH));
    }
    let count = match &value.ty {
        Type::Vector(count, dimension) if dimension.fits(Dimension::LENGTH) => *count,
        Type::Frame => 3,
        other => {
            let fact = format!("a part stands at a point or in a frame, found {other}");
            let help = "write it like `at pivot`";
            suspect_unit(units, sink, &value, &Type::Vector(2, Dimension::LENGTH));
            let span = sink.span(value.origin);
            sink.error_with_help(span, fact, help);
            return error_expr(sink, span);
        }
    };
    if let Some(components) = points.iter().find(|components| **components != count) {
        let words = |count| if count == 3 { "space" } else { "the plane" };
        let fact = format!(
            "the part `{}` has vectors of {}, and stands at a place of {}",
            item.name,
            words(*components),
            words(count)
        );
        let help = "place it by a point of its own kind, or write what is asked of it with `point_in`; that a plane cannot be \
                    placed in space is a limit of linkage";
        let span = sink.span(value.origin);
        sink.error_with_help(span, fact, help);
        return error_expr(sink, span);
    }
    value
}

fn check_rotation(
    names: &Names,
    units: &AssumedUnits,
    sink: &mut Sink,
    value: Expr,
    item: &PartItem,
) -> Expr {
    let what = format!("the angle by which the part `{}` is turned", item.name);
    fit_to_type(
        names,
        units,
        sink,
        value,
        &Type::Scalar(Dimension::ANGLE),
        &what,
    )
}

/// Returns the numbers of components of the points of a mechanism: 2, 3, or both.
fn components_of_points(mechanism: &Mechanism) -> Vec<usize> {
    let lets = mechanism.lets.iter().map(|item| &item.value.ty);
    let unknowns = mechanism.unknowns.iter().map(|unknown| &unknown.ty);
    let parameters = mechanism.parameters.iter().map(|parameter| &parameter.ty);
    let mut counts: Vec<usize> = lets
        .chain(unknowns)
        .chain(parameters)
        .filter_map(|ty| match ty {
            Type::Vector(count, _) => Some(*count),
            Type::Frame => Some(3),
            Type::PlaneFrame => Some(2),
            Type::Scalar(_) | Type::Array(_) | Type::Zero(_) | Type::Error => None,
        })
        .collect();
    counts.sort_unstable();
    counts.dedup();
    counts
}
