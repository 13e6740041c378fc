//! Parts of a frame: origin, axes, angle.

use proc_macro2::Ident;

use super::nodes::{error_expr, make_expr};
use crate::diagnostic::SourceSpan;
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::sink::Sink;
use crate::model::types::{Dimension, Expr, ExprKind, Type};

/// What a frame consists of, in this order.
pub(crate) const PARTS: [&str; 4] = ["origin", "x", "y", "z"];

pub(in crate::model) const PARTS_HELP: &str = "parts of a frame are `.origin`, `.x`, `.y` and `.z`";

/// What a frame of the plane consists of, in this order.
pub(crate) const PLANE_PARTS: [&str; 4] = ["origin", "x", "y", "angle"];

/// Which of them is its angle, behind so many vectors: as a quantity it is these.
pub(in crate::model) const ANGLE_PART: usize = 3;

pub(crate) const VECTORS_OF_PLANE: usize = ANGLE_PART;

pub(in crate::model) const PLANE_PARTS_HELP: &str =
    "parts of a frame of the plane are `.origin`, `.x`, `.y` and `.angle`";

/// The type of a part of a frame.
pub(in crate::model) fn type_of_part(frame: &Type, part: usize) -> Type {
    match (frame, part) {
        (Type::PlaneFrame, 0) => Type::Vector(2, Dimension::LENGTH),
        (Type::PlaneFrame, 3) => Type::Scalar(Dimension::ANGLE),
        (Type::PlaneFrame, _) => Type::Vector(2, Dimension::NUMBER),
        (_, 0) => Type::Vector(3, Dimension::LENGTH),
        _ => Type::Vector(3, Dimension::NUMBER),
    }
}

/// `.origin`, `.x`, `.y`, and `.z` or `.angle` of a frame.
pub(in crate::model) fn make_frame_part(
    sink: &mut Sink,
    frame: Expr,
    field: &Ident,
    span: SourceSpan,
) -> Expr {
    let (parts, help) = match frame.ty {
        Type::PlaneFrame => (PLANE_PARTS, PLANE_PARTS_HELP),
        _ => (PARTS, PARTS_HELP),
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

/// What to write for a frame where a vector is needed, its name filled in.
pub(in crate::model) fn frame_parts_help(names: &Names, verb: &str, frame: &Expr) -> String {
    let name = match &frame.kind {
        ExprKind::Name(name) => names.symbol(*name).map(|symbol| symbol.text.as_str()),
        _ => None,
    };
    let name = name.unwrap_or("body");
    format!("{verb} `{name}.origin`, an axis like `{name}.x`, or `point_in({name}, v)`")
}
