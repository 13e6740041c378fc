//! Numbers without a unit as angles: nobody means 30 radians by `30`.

use std::collections::BTreeSet;

use crate::model::symbols::declared_names::Names;
use crate::model::symbols::sink::Sink;
use crate::model::types::{Expr, Mechanism, Name, Type, angles};

/// Reports references, ranges and estimates of angles that lack a unit. An input or unknown is an
/// angle if it is used as one: it can be a number as well.
pub(in crate::model) fn refuse_bare_coordinates(
    names: &Names,
    sink: &mut Sink,
    mechanism: &Mechanism,
) {
    let values = values_of_coordinates(mechanism);
    if values
        .iter()
        .all(|coordinate| coordinate.value.bare_number().is_none())
    {
        return;
    }
    let used = angles(mechanism);
    for CoordinateValue { name, role, value } in values {
        if is_angle_name(names, name, &used) {
            let what = format!("the {role} of the angle `{}`", mechanism.name(name));
            refuse_bare_angle(sink, value, &what);
        }
    }
}

/// Returns true if a scalar is given in a unit of angles or used as an angle.
fn is_angle_name(names: &Names, name: Name, used: &BTreeSet<Name>) -> bool {
    let symbol = names.symbol(name);
    match symbol.map(|symbol| &symbol.ty) {
        Some(Type::Scalar(dimension)) => {
            dimension.is_number_or_angle() && (dimension.angle || used.contains(&name))
        }
        _ => false,
    }
}

pub(in crate::model) fn refuse_bare_angle(sink: &mut Sink, value: &Expr, what: &str) {
    if let Some(number) = value.bare_number() {
        let fact = format!("{what} has no unit: `{number}` would be {number} rad");
        let help = format!("write `{number}deg`, or `{number}rad`");
        let span = sink.span(value.origin);
        sink.error_with_help(span, fact, help).suggest(
            format!("write `{number}deg`"),
            span,
            format!("{number}deg"),
        );
    }
}

/// A number that is declared with an input or unknown.
struct CoordinateValue<'m> {
    name: Name,
    role: &'static str,
    value: &'m Expr,
}

fn values_of_coordinates(mechanism: &Mechanism) -> Vec<CoordinateValue<'_>> {
    let mut list = Vec::new();
    for (index, input) in mechanism.inputs.iter().enumerate() {
        let mut add = |role, value| {
            let name = Name::Input(index);
            list.push(CoordinateValue { name, role, value });
        };
        add("reference", &input.reference);
        if let Some((low, high)) = &input.range {
            add("lower end of the range", low);
            add("upper end of the range", high);
        }
    }
    let unknowns = mechanism.unknowns.iter().enumerate();
    list.extend(unknowns.filter_map(|(index, unknown)| {
        Some(CoordinateValue {
            name: Name::Unknown(index),
            role: "estimate",
            value: unknown.estimate.as_ref()?,
        })
    }));
    list
}
