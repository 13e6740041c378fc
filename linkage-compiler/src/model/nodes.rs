//! Nodes of resolved expressions.

use super::sink::Sink;
use super::types::{Expr, ExprKind, Type};
use crate::diagnostic::SourceSpan;

pub(super) fn make_expr(sink: &mut Sink, kind: ExprKind, ty: Type, span: SourceSpan) -> Expr {
    Expr {
        kind,
        ty,
        origin: sink.add_origin(span),
    }
}

/// What a reported mistake leaves.
pub(super) fn error_expr(sink: &mut Sink, span: SourceSpan) -> Expr {
    make_expr(sink, ExprKind::Error, Type::Error, span)
}
