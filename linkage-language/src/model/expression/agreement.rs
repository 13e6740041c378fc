//! Values that must have one dimension: their common type, and messages where there is none.

use std::fmt::Display;

use super::frame_parts::frame_parts_help;
use super::hidden_unit::hidden_unit_help;
use super::missing_units::suspect_unit;
use super::plane_and_space::{lifting_help, plane_beside_space, vector_components};
use crate::diagnostic::SourceSpan;
use crate::model::symbols::assumed_units::AssumedUnits;
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::sink::Sink;
use crate::model::types::{Dimension, Expr, ExprKind, Name, Type};

/// The type of all together; reports the first that differs from those before it.
pub(in crate::model) fn common_type(
    names: &Names,
    units: &AssumedUnits,
    sink: &mut Sink,
    values: &mut [&mut Expr],
    what: &str,
) -> Type {
    let mut ty = Type::Zero(1);
    for index in 0..values.len() {
        if values[index].ty.is_error() || refuse_compound(names, sink, values[index]) {
            return Type::Error;
        }
        match Type::common(&ty, &values[index].ty) {
            Some(common) => ty = common,
            None => {
                suspect_unit(units, sink, values[index], &ty);
                for before in &values[..index] {
                    suspect_unit(units, sink, before, &values[index].ty);
                }
                let fact = format!("{what} differ in dimension: {ty} and {}", values[index].ty);
                let span = sink.span(values[index].origin);
                let [left, right] = [&*values[index - 1], &*values[index]];
                refuse_mismatch(names, units, sink, [left, right], fact, span);
                return Type::Error;
            }
        }
    }
    ty
}

/// Reports two values that do not fit.
pub(in crate::model) fn refuse_mismatch(
    names: &Names,
    units: &AssumedUnits,
    sink: &mut Sink,
    [left, right]: [&Expr; 2],
    fact: impl Display,
    span: SourceSpan,
) {
    let help = mismatch_help(names, units, left, right);
    let number = bare_length(units, left, right).map(|(value, text)| {
        let span = sink.span(value.origin);
        (span, text)
    });
    let message = sink.error_with_help(span, fact, help);
    if let Some((span, text)) = number {
        message.suggest(format!("write `{text}`"), span, text);
    }
}

/// Returns the value that is a number without a unit if the other one is a length, and this number
/// in the unit of the mechanism.
fn bare_length<'e>(
    units: &AssumedUnits,
    left: &'e Expr,
    right: &'e Expr,
) -> Option<(&'e Expr, String)> {
    let mut pairs = [(left, right), (right, left)].into_iter();
    pairs.find_map(|(value, other)| {
        let number = value.bare_number()?;
        let is_length = other.ty == Type::Scalar(Dimension::LENGTH);
        is_length.then(|| (value, format!("{number}{}", units.length.name())))
    })
}

fn mismatch_help(names: &Names, units: &AssumedUnits, left: &Expr, right: &Expr) -> String {
    for value in [left, right] {
        let ExprKind::Name(name @ (Name::Parameter(_) | Name::Input(_) | Name::Unknown(_))) =
            &value.kind
        else {
            continue;
        };
        let symbol = names.symbol(*name);
        if let Some(symbol) = symbol.filter(|symbol| symbol.bare_zero) {
            let unit = units.length.name();
            return format!("declare `{}` with a unit: `0{unit}` or `0deg`", symbol.text);
        }
    }
    for (value, other) in [(left, right), (right, left)] {
        if let Some(help) = bare_declaration_help(names, units, value, &other.ty) {
            return help;
        }
    }
    let hidden = [left, right].map(|value| hidden_unit_help(names, value));
    if let Some(help) = hidden.into_iter().flatten().next() {
        return help;
    }
    if let Some(plane) = plane_beside_space(left, right) {
        return lifting_help(names, plane);
    }
    let components = [left, right].map(vector_components);
    if components[0] != components[1] {
        let vector = if components.contains(&Some(3)) {
            "(x, y, z)"
        } else {
            "(x, y)"
        };
        return format!("write a vector `{vector}` on both sides, or take a component `.x`");
    }
    if let Some((_, length)) = bare_length(units, left, right) {
        return format!("give the number its unit: `{length}`");
    }
    "both must have the same dimension".to_owned()
}

/// Returns a help for a number that is declared without the unit of the other value: `argument load
/// = 500` next to newtons.
fn bare_declaration_help(
    names: &Names,
    units: &AssumedUnits,
    value: &Expr,
    other: &Type,
) -> Option<String> {
    let name = match &value.kind {
        ExprKind::Negate(value) => value.as_name()?,
        _ => value.as_name()?,
    };
    let has_value = matches!(
        name,
        Name::Argument(_) | Name::Parameter(_) | Name::Const(_)
    );
    let unit = other.dimension()?.unit(units.length);
    if !has_value || value.ty != Type::NUMBER || unit.is_empty() {
        return None;
    }
    let symbol = names.symbol(name)?;
    let (_, kind) = symbol.kind().split_once(' ')?;
    Some(format!(
        "`{}` is a number: give the value of this {kind} its unit, `{unit}`",
        symbol.text
    ))
}

/// Refuses arrays and frames. They consist of values of different dimensions, so there is no
/// arithmetic with them.
pub(in crate::model) fn refuse_compound(names: &Names, sink: &mut Sink, value: &Expr) -> bool {
    let help = match &value.ty {
        Type::Array(_) => "take one entry: `[0]`".to_owned(),
        Type::Frame | Type::PlaneFrame => frame_parts_help(names, "take", value),
        Type::Scalar(_) | Type::Vector(..) | Type::Zero(_) | Type::Error => return false,
    };
    if !value.ty.is_error() {
        let fact = format!("{} cannot be used in an expression", value.ty);
        let span = sink.span(value.origin);
        sink.error_with_help(span, fact, help);
    }
    true
}
