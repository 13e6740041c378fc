//! Parts of a frame: origin, axes, angle.

use proc_macro2::Ident;

use super::nodes::{error_expr, make_expr};
use crate::diagnostic::SourceSpan;
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::sink::Sink;
use crate::model::types::{Expr, ExprKind, FRAME_PARTS, PLANE_PARTS, Type, type_of_part};

pub(in crate::model) const PARTS_HELP: &str = "parts of a frame are `.origin`, `.x`, `.y` and `.z`";

pub(in crate::model) const PLANE_PARTS_HELP: &str =
    "parts of a frame of the plane are `.origin`, `.x`, `.y` and `.angle`";

/// `.origin`, `.x`, `.y`, and `.z` or `.angle` of a frame.
pub(in crate::model) fn make_frame_part(
    sink: &mut Sink,
    frame: Expr,
    field: &Ident,
    span: SourceSpan,
) -> Expr {
    let (parts, help) = match frame.ty {
        Type::PlaneFrame => (PLANE_PARTS, PLANE_PARTS_HELP),
        _ => (FRAME_PARTS, PARTS_HELP),
    };
    match parts.iter().position(|part| field == part) {
        Some(index) => {
            let ty = type_of_part(&frame.ty, index);
            let kind = ExprKind::Index(Box::new(frame), index);
            make_expr(sink, kind, ty, span)
        }
        None => {
            let fact = format!("{} has no part `{field}`", frame.ty);
            sink.error_with_help(field.into(), fact, help);
            error_expr(sink, span)
        }
    }
}

/// Returns a help with the text to write for a frame where a vector is needed.
pub(in crate::model) fn frame_parts_help(names: &Names, verb: &str, frame: &Expr) -> String {
    let name = match &frame.kind {
        ExprKind::Name(name) => names.symbol(*name).map(|symbol| symbol.text.as_str()),
        _ => None,
    };
    let name = name.unwrap_or("body");
    format!("{verb} `{name}.origin`, an axis like `{name}.x`, or `point_in({name}, v)`")
}
