//! Inputs and unknowns.

use crate::model::dispatch::resolve_expression;
use crate::model::expression::agreement::common_type;
use crate::model::expression::frame_items::refuse_frame_item;
use crate::model::expression::missing_units::note_unitless;
use crate::model::symbols::scope::Scope;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::{Context, Site};
use crate::model::types::{Dimension, Expr, Input, Name, Type, Unknown};
use crate::syntax::{InputItem, UnknownItem};

pub(in crate::model) fn resolve_input(
    scope: &mut Scope,
    sink: &mut Sink,
    item: &InputItem,
    index: usize,
    position: usize,
) -> Input {
    let context = Context {
        site: Site::Input,
        item: position,
    };
    let mut reference = resolve_expression(scope, sink, &item.value, context);
    let mut range = item.range.as_ref().map(|(low, high)| {
        (
            resolve_expression(scope, sink, low, context),
            resolve_expression(scope, sink, high, context),
        )
    });
    refuse_frame_item(sink, &mut reference, "an input is an angle or a length");
    let mut values: Vec<&mut Expr> = vec![&mut reference];
    if let Some((low, high)) = &mut range {
        values.extend([low, high]);
    }
    let ty = common_type(
        &scope.names,
        &scope.units,
        sink,
        &mut values,
        "the reference and the range of an input",
    );
    let bare_zero = values.iter().all(|value| matches!(value.ty, Type::Zero(_)));
    let ty = scope.units.declared(Name::Input(index), &ty);
    values.into_iter().for_each(|value| value.settle(&ty));
    let beside = range.as_ref().map(|_| "the range");
    note_unitless(
        &scope.names,
        &mut scope.units,
        sink,
        Name::Input(index),
        &reference,
        beside,
    );
    let dimension = match &ty {
        Type::Scalar(dimension) => check_coordinate(sink, *dimension, "an input", &item.value),
        Type::Error => None,
        other => {
            let fact = format!("an input is an angle or a length, found {other}");
            let help = "declare one input for each coordinate";
            sink.error_with_help(item.value.span, fact, help);
            None
        }
    };
    let ty = dimension.map_or(Type::Error, Type::Scalar);
    scope.names.set_type(Name::Input(index), ty, bare_zero);
    Input {
        name: item.name.to_string(),
        dimension: dimension.unwrap_or(Dimension::NUMBER),
        reference,
        range,
        speed: scope.values.rates[index][0],
        acceleration: scope.values.rates[index][1],
        origin: sink.add_origin((&item.name).into()),
    }
}

pub(in crate::model) fn resolve_unknown(
    scope: &mut Scope,
    sink: &mut Sink,
    item: &UnknownItem,
    index: usize,
    position: usize,
) -> Unknown {
    let name = Name::Unknown(index);
    let (ty, bare_zero, estimate) = match &item.estimate {
        Some(value) => {
            let context = Context {
                site: Site::Estimate,
                item: position,
            };
            let mut estimate = resolve_expression(scope, sink, value, context);
            refuse_frame_item(
                sink,
                &mut estimate,
                "an unknown is an angle, a length or a point",
            );
            let bare_zero = matches!(estimate.ty, Type::Zero(_));
            let mut ty = scope.units.declared(name, &estimate.ty);
            estimate.settle(&ty);
            note_unitless(&scope.names, &mut scope.units, sink, name, &estimate, None);
            if let Some(dimension) = ty.dimension()
                && check_coordinate(sink, dimension, "an unknown", value).is_none()
            {
                ty = Type::Error;
            }
            (ty, bare_zero, Some(estimate))
        }
        None => (
            scope.units.declared(name, &scope.units.zeros.zero_of(name)),
            true,
            None,
        ),
    };
    scope.names.set_type(name, ty.clone(), bare_zero);
    let origin = sink.add_origin((&item.name).into());
    Unknown {
        name: item.name.to_string(),
        ty,
        estimate,
        of_part: false,
        origin,
    }
}

/// Inputs and unknowns are angles (or numbers) and lengths.
pub(in crate::model) fn check_coordinate(
    sink: &mut Sink,
    dimension: Dimension,
    what: &str,
    value: &crate::syntax::Expr,
) -> Option<Dimension> {
    if dimension.is_number_or_angle() || dimension.fits(Dimension::LENGTH) {
        return Some(dimension);
    }
    let fact = format!("{what} is an angle or a length, found {dimension}");
    sink.error_with_help(value.span, fact, "use another coordinate");
    None
}
