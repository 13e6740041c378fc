//! Values that are given where a type is wanted.

use super::bare_numbers::refuse_bare_angle;
use super::hidden_unit::hidden_unit_help;
use super::missing_units::suspect_unit;
use super::nodes::error_expr;
use crate::model::symbols::assumed_units::AssumedUnits;
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::sink::Sink;
use crate::model::types::{Expr, Type};

/// An expression of the type that something of a part has; another is reported.
pub(in crate::model) fn fit_to_type(
    names: &Names,
    units: &AssumedUnits,
    sink: &mut Sink,
    mut value: Expr,
    wanted: &Type,
    what: &str,
) -> Expr {
    if value.ty.is_error() {
        return value;
    }
    if Type::common(&value.ty, wanted).is_some() {
        value.settle(wanted);
        if wanted.dimension().is_some_and(|dimension| dimension.angle) {
            refuse_bare_angle(sink, &value, what);
        }
        return value;
    }
    suspect_unit(units, sink, &value, wanted);
    let fact = format!("{what} is {wanted}, found {}", value.ty);
    let help = hidden_unit_help(names, &value).unwrap_or_else(|| format!("give it {wanted}"));
    let span = sink.span(value.origin);
    sink.error_with_help(span, fact, help);
    error_expr(sink, span)
}
