//! Vectors, their components, and entries of arrays.

use super::agreement::{common_type, refuse_compound};
use super::frame_parts::{PARTS_HELP, PLANE_PARTS_HELP, make_frame_part};
use super::nodes::{error_expr, make_expr};
use super::plane_and_space::nested_help;
use crate::diagnostic::SourceSpan;
use crate::model::symbols::assumed_units::AssumedUnits;
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::sink::Sink;
use crate::model::types::{COMPONENTS, Expr, ExprKind, Type};
use crate::syntax::{self, is_unit};

pub(in crate::model) fn make_vector(
    names: &Names,
    units: &AssumedUnits,
    sink: &mut Sink,
    mut components: Vec<Expr>,
    span: SourceSpan,
) -> Expr {
    if !(2..=3).contains(&components.len()) {
        let found = components.len();
        let fact = format!("a vector has two or three components, found {found}");
        sink.error_with_help(span, fact, "write `(x, y)` or `(x, y, z)`");
        return error_expr(sink, span);
    }
    if let Some(inner) = components.iter().find(|component| {
        matches!(component.ty, Type::Vector(..)) || matches!(component.ty, Type::Zero(2..))
    }) {
        let fact = format!("a component must be a scalar, found {}", inner.ty);
        let span = sink.span(inner.origin);
        let help = nested_help(names, &components);
        sink.error_with_help(span, fact, help);
        return error_expr(sink, span);
    }
    let mut values: Vec<&mut Expr> = components.iter_mut().collect();
    let ty = match common_type(
        names,
        units,
        sink,
        &mut values,
        "the components of a vector",
    ) {
        Type::Scalar(dimension) => Type::Vector(components.len(), dimension),
        Type::Zero(_) => Type::Zero(components.len()),
        _ => return error_expr(sink, span),
    };
    if let Type::Vector(_, dimension) = ty {
        let component = Type::Scalar(dimension);
        components
            .iter_mut()
            .for_each(|value| value.settle(&component));
    }
    make_expr(sink, ExprKind::Vector(components), ty, span)
}

pub(in crate::model) fn make_component(
    names: &Names,
    sink: &mut Sink,
    value: Expr,
    field: &proc_macro2::Ident,
    span: SourceSpan,
) -> Expr {
    if value.ty.is_frame() {
        return make_frame_part(sink, value, field, span);
    }
    if value.ty.is_error() || refuse_compound(names, sink, &value) {
        return error_expr(sink, span);
    }
    let index = COMPONENTS.iter().position(|component| field == component);
    let count = value.ty.components().unwrap_or(1);
    let ty = match &value.ty {
        Type::Vector(_, dimension) => Type::Scalar(*dimension),
        _ => Type::Zero(1),
    };
    match index {
        Some(index) if index < count && count > 1 => {
            make_expr(sink, ExprKind::Component(Box::new(value), index), ty, span)
        }
        _ => {
            let fact = format!("{} has no component `{field}`", value.ty);
            let help = match count {
                1 if is_unit(&field.to_string()) => {
                    format!("a value in another unit is a quotient: `... / 1{field}`")
                }
                1 => "only vectors have components".to_owned(),
                2 if field == COMPONENTS[2] => {
                    "components are `.x`, `.y`; a space vector is written `(x, y, z)`".to_owned()
                }
                _ => format!("components are `.{}`", COMPONENTS[..count].join("`, `.")),
            };
            sink.error_with_help(field.into(), fact, help);
            error_expr(sink, span)
        }
    }
}

/// `value[index]`
pub(in crate::model) fn make_entry(
    sink: &mut Sink,
    value: Expr,
    index: &syntax::Expr,
    span: SourceSpan,
) -> Expr {
    if value.ty.is_error() {
        return error_expr(sink, span);
    }
    let Type::Array(entries) = &value.ty else {
        let fact = format!("{} has no entries", value.ty);
        let help = match value.ty {
            Type::Frame => PARTS_HELP,
            Type::PlaneFrame => PLANE_PARTS_HELP,
            _ => "components of a vector are `.x`, `.y` and `.z`",
        };
        sink.error_with_help(span, fact, help);
        return error_expr(sink, span);
    };
    let count = entries.len();
    match entry_number(index) {
        Some(number) if number < count => {
            let ty = entries[number].clone();
            make_expr(sink, ExprKind::Index(Box::new(value), number), ty, span)
        }
        Some(number) => {
            let fact = format!("entry {number} of {}", value.ty);
            let help = match count {
                1 => "write `[0]`".to_owned(),
                _ => format!("write a number from 0 to {}", count.saturating_sub(1)),
            };
            sink.error_with_help(index.span, fact, help);
            error_expr(sink, span)
        }
        None if matches!(index.kind, syntax::ExprKind::Error) => error_expr(sink, span),
        None => {
            let fact = "an index must be a whole number";
            sink.error_with_help(index.span, fact, "write `[0]`");
            error_expr(sink, span)
        }
    }
}

pub(in crate::model) fn entry_number(index: &syntax::Expr) -> Option<usize> {
    match &index.kind {
        syntax::ExprKind::Number { text, suffix } if suffix.is_empty() => text.parse().ok(),
        _ => None,
    }
}
