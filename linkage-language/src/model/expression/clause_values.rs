//! Values of clauses, resolved: their types, and the plane or space that they belong to.

use super::hidden_unit::hidden_unit_help;
use super::missing_units::suspect_unit;
use super::nodes::error_expr;
use super::plane_and_space::{lifting_help, vector_components};
use crate::model::symbols::assumed_units::AssumedUnits;
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::sink::Sink;
use crate::model::types::{Dimension, Expr, Type};

/// A resolved scalar of a dimension; zero fits.
pub(in crate::model) fn check_scalar(
    names: &Names,
    sink: &mut Sink,
    mut value: Expr,
    wanted: Dimension,
    word: &str,
    example: &str,
) -> Expr {
    value.settle(&Type::Scalar(wanted));
    match &value.ty {
        Type::Scalar(found) if found.fits(wanted) => value,
        _ => refuse_clause(names, sink, value, word, &wanted.to_string(), example),
    }
}

pub(in crate::model) fn check_vector(
    names: &Names,
    units: &AssumedUnits,
    sink: &mut Sink,
    mut value: Expr,
    wanted: Option<Dimension>,
    word: &str,
    example: &str,
) -> Expr {
    let count = vector_components(&value);
    if let Some(count) = count {
        value.settle(&Type::Vector(count, wanted.unwrap_or(Dimension::NUMBER)));
    }
    match (count, value.ty.dimension()) {
        (Some(count), Some(found)) if wanted.is_none_or(|wanted| found.fits(wanted)) => {
            check_space(names, sink, value, count, word)
        }
        _ => {
            let count = sink.components.or(count);
            if let Some(dimension) = wanted {
                suspect_unit(units, sink, &value, &Type::Scalar(dimension));
            }
            let wanted = match (count, wanted) {
                (Some(count), Some(wanted)) => Type::Vector(count, wanted).to_string(),
                (None, Some(wanted)) => format!("a vector, each component {wanted}"),
                (_, None) => "a vector".to_owned(),
            };
            refuse_clause(names, sink, value, word, &wanted, example)
        }
    }
}

/// The first vector decides whether the mechanics is one of the plane or of space.
pub(in crate::model) fn check_space(
    names: &Names,
    sink: &mut Sink,
    value: Expr,
    count: usize,
    word: &str,
) -> Expr {
    let expected = *sink.components.get_or_insert(count);
    if expected == count {
        return value;
    }
    let (space, help) = match expected {
        2 => (
            "in the plane",
            "leave out the third component: `(v.x, v.y)`".to_owned(),
        ),
        _ => ("in space", lifting_help(names, &value)),
    };
    let fact = format!(
        "`{word}` takes {}, but the bodies before it are {space}",
        value.ty
    );
    let span = sink.span(value.origin);
    sink.error_with_help(span, fact, help);
    error_expr(sink, span)
}

pub(in crate::model) fn refuse_clause(
    names: &Names,
    sink: &mut Sink,
    value: Expr,
    word: &str,
    wanted: &str,
    example: &str,
) -> Expr {
    let span = sink.span(value.origin);
    if value.ty.is_error() {
        return value;
    }
    let fact = format!("`{word}` takes {wanted}, found {}", value.ty);
    let help =
        hidden_unit_help(names, &value).unwrap_or_else(|| format!("write it like `{example}`"));
    sink.error_with_help(span, fact, help);
    error_expr(sink, span)
}
