//! Numbers without a unit next to lengths: the declarations that they come from are suspects.

use std::ops::RangeInclusive;

use crate::model::symbols::assumed_units::{AssumedUnits, Unitless};
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::sink::Sink;
use crate::model::types::{Dimension, Expr, ExprKind, Name, Type};

/// A vector of such a length can be a direction, which is a vector of numbers: estimates of
/// directions are rough.
const LENGTHS_OF_DIRECTIONS: RangeInclusive<f64> = 0.5..=2.0;

/// Remembers of a declared value whether its unit may be missing, or whose.
pub(in crate::model) fn note_unitless(
    names: &Names,
    units: &mut AssumedUnits,
    sink: &mut Sink,
    name: Name,
    value: &Expr,
    beside: Option<&'static str>,
) {
    let lacking = match with_unit(value, units.length.name()) {
        Some(length) => {
            let text = names.symbol(name);
            units.unitless.push(Unitless {
                name,
                text: text.map_or_else(String::new, |symbol| symbol.text.clone()),
                number: with_unit(value, "").unwrap_or_default(),
                length,
                beside,
                span: sink.span(value.origin),
            });
            vec![name]
        }
        None => units.lacking_unit(value),
    };
    units.set_lacking(name, lacking);
}

/// Adds the names that may lack a unit, if one of two values is a number and the other one contains
/// lengths.
pub(in crate::model) fn suspect_unit(
    units: &AssumedUnits,
    sink: &mut Sink,
    left: &Expr,
    right: &Type,
) {
    let number = |ty: &Type| ty.dimension() == Some(Dimension::NUMBER);
    let length = |ty: &Type| {
        let dimension = ty.dimension().filter(|dimension| dimension.is_geometric());
        dimension.is_some_and(|dimension| dimension.half_lengths > 0)
    };
    if number(&left.ty) && length(right) {
        let lacking = units.lacking_unit(left);
        sink.suspects.extend(lacking);
    }
}

/// Calls [`suspect_unit`] both ways.
pub(in crate::model) fn suspect_both_units(
    units: &AssumedUnits,
    sink: &mut Sink,
    left: &Expr,
    right: &Expr,
) {
    suspect_unit(units, sink, left, &right.ty);
    suspect_unit(units, sink, right, &left.ty);
}

/// A number without a unit, or a vector of such and zeros that is no direction, written with one.
fn with_unit(value: &Expr, unit: &str) -> Option<String> {
    if let Some(number) = value.bare_number() {
        return Some(format!("{number}{unit}"));
    }
    let ExprKind::Vector(components) = &value.kind else {
        return None;
    };
    let zero = |component: &Expr| matches!(component.kind, ExprKind::Number(0.0));
    let numbers = components.iter().map(|component| {
        if zero(component) {
            Some(0.0)
        } else {
            component.bare_number()
        }
    });
    let numbers: Vec<f64> = numbers.collect::<Option<_>>()?;
    let length = numbers
        .iter()
        .fold(0.0, |length: f64, number| length.hypot(*number));
    if length == 0.0 || LENGTHS_OF_DIRECTIONS.contains(&length) {
        return None;
    }
    let written = numbers.iter().map(|number| match number {
        0.0 => "0".to_owned(),
        number => format!("{number}{unit}"),
    });
    let written: Vec<String> = written.collect();
    Some(format!("({})", written.join(", ")))
}
