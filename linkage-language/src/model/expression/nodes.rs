//! Nodes of resolved expressions.

use crate::diagnostic::SourceSpan;
use crate::model::symbols::sink::Sink;
use crate::model::types::{Expr, ExprKind, Type};

pub(in crate::model) fn make_expr(
    sink: &mut Sink,
    kind: ExprKind,
    ty: Type,
    span: SourceSpan,
) -> Expr {
    Expr {
        kind,
        ty,
        origin: sink.add_origin(span),
    }
}

/// Returns the expression that replaces one with a reported mistake.
pub(in crate::model) fn error_expr(sink: &mut Sink, span: SourceSpan) -> Expr {
    make_expr(sink, ExprKind::Error, Type::Error, span)
}
