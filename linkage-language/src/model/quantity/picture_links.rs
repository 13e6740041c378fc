//! `picture()`: a quantity that cannot be part of an expression.

use crate::diagnostic::SourceSpan;
use crate::model::expression::nodes::{error_expr, make_expr};
use crate::model::symbols::operands::Operands;
use crate::model::symbols::sink::Sink;
use crate::model::types::{Dimension, EvaluatorDef, Expr, ExprKind, MotionWord, Name, Type};
use crate::syntax::{self, Word};

const LINKS_HELP: &str = "write each link as a list of points: `picture([a, b], [c, d, e])`";

/// A quantity that is a picture as a whole; `None` for any other.
pub(in crate::model) fn resolve_picture(
    operands: Operands,
    sink: &mut Sink,
    expr: &syntax::Expr,
) -> Option<Expr> {
    let syntax::ExprKind::Call(name, links) = &expr.kind else {
        return None;
    };
    if name != MotionWord::Picture.word() {
        return None;
    }
    let links = links.iter().map(|link| resolve_link(operands, sink, link));
    let links: Vec<Option<Vec<Expr>>> = links.collect();
    // The number of points is computed later.
    let ty = Type::Array(Vec::new());
    Some(match links.into_iter().collect() {
        Some(links) => make_expr(sink, ExprKind::Picture(links), ty, expr.span),
        None => error_expr(sink, expr.span),
    })
}

/// A list of at least two points.
fn resolve_link(operands: Operands, sink: &mut Sink, link: &syntax::Expr) -> Option<Vec<Expr>> {
    let syntax::ExprKind::List(points) = &link.kind else {
        let fact = "expected a link, found no list";
        sink.error_with_help(link.span, fact, LINKS_HELP);
        return None;
    };
    if points.len() < 2 {
        let fact = "a link joins at least two points";
        sink.error_with_help(link.span, fact, LINKS_HELP);
        return None;
    }
    let points = points
        .iter()
        .map(|point| resolve_link_point(operands, sink, point));
    let points: Vec<Option<Expr>> = points.collect();
    points.into_iter().collect()
}

fn resolve_link_point(operands: Operands, sink: &mut Sink, point: &syntax::Expr) -> Option<Expr> {
    let value = operands.resolve(sink, point);
    match &value.ty {
        Type::Error => None,
        _ if !is_position(&value) => {
            let fact = "a link joins points, found what is no position";
            let help = "write points with lengths and angles of the mechanism alone, without derivatives, forces and arguments";
            sink.error_with_help(point.span, fact, help);
            None
        }
        Type::Vector(_, dimension) if dimension.fits(Dimension::LENGTH) => Some(value),
        Type::Zero(2 | 3) => Some(value),
        other => {
            let fact = format!("a link joins points, found {other}");
            sink.error_with_help(point.span, fact, LINKS_HELP);
            None
        }
    }
}

/// Reports a picture within an expression.
pub(in crate::model) fn refuse_inner_picture(sink: &mut Sink, span: SourceSpan) -> Expr {
    let fact = "`picture` within an expression";
    let help = "it is a quantity as a whole: write `shape: picture()`";
    sink.error_with_help(span, fact, help);
    error_expr(sink, span)
}

/// A mechanism has one picture.
pub(in crate::model) fn check_one_picture(sink: &mut Sink, functions: &[EvaluatorDef]) {
    let quantities = functions.iter().flat_map(|function| &function.quantities);
    let mut pictures = quantities.filter(|quantity| quantity.is_picture());
    let first = pictures.next().map(|quantity| quantity.field.clone());
    let Some(first) = first else { return };
    for again in pictures {
        let fact = "a mechanism has one picture";
        let help = format!("leave this one out: `{first}` shows all links");
        let span = sink.span(again.origin);
        sink.error_with_help(span, fact, &help);
    }
}

/// Returns true for an expression of positions: no quantity of motion, no load.
fn is_position(expr: &Expr) -> bool {
    expr.parts()
        .all(|part| !part.is_quantity() && !matches!(part.as_name(), Some(Name::Argument(_))))
}
