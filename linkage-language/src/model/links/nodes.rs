//! Expressions of the items that joints and links become.

use proc_macro2::{Ident, Span};

use crate::diagnostic::SourceSpan;
use crate::model::types::Function;
use crate::syntax::{BinaryOp, Expr, ExprKind, Item, LinkLoop, LoopItem, Word};

pub(super) fn ident(text: &str, span: Span) -> Ident {
    Ident::new(text, span)
}

fn expr(kind: ExprKind, span: SourceSpan) -> Expr {
    Expr { kind, span }
}

pub(super) fn name(ident: &Ident) -> Expr {
    expr(ExprKind::Name(ident.clone()), ident.into())
}

/// `link.quantity`
pub(super) fn quantity(link: &Ident, quantity: &Ident) -> Expr {
    let field = ExprKind::Field(Box::new(name(link)), quantity.clone());
    expr(field, quantity.into())
}

/// `loop left = right;`, which stands for a joint or a link.
pub(super) fn equation(left: Expr, right: Expr, of: LinkLoop, span: SourceSpan) -> Item {
    Item::Loop(LoopItem {
        redundant: false,
        left,
        right,
        span,
        of: Some(of),
    })
}

/// A number with its unit.
pub(super) fn number(text: &str, unit: &str, span: SourceSpan) -> Expr {
    let (text, suffix) = (text.to_owned(), unit.to_owned());
    expr(ExprKind::Number { text, suffix }, span)
}

pub(super) fn call(function: Function, arguments: Vec<Expr>) -> Expr {
    let span = arguments[0].span;
    let function = ident(function.word(), span.first);
    expr(ExprKind::Call(function, arguments), span)
}

/// `(x, y)`
pub(super) fn pair(x: Expr, y: Expr) -> Expr {
    let span = x.span;
    expr(ExprKind::Tuple(vec![x, y]), span)
}

pub(super) fn negative(value: Expr) -> Expr {
    let span = value.span;
    expr(ExprKind::Negate(Box::new(value)), span)
}

pub(super) fn sum(left: Expr, right: Expr) -> Expr {
    binary(BinaryOp::Add, left, right)
}

pub(super) fn difference(left: Expr, right: Expr) -> Expr {
    binary(BinaryOp::Sub, left, right)
}

pub(super) fn product(left: Expr, right: Expr) -> Expr {
    binary(BinaryOp::Mul, left, right)
}

pub(super) fn quotient(left: Expr, right: Expr) -> Expr {
    binary(BinaryOp::Div, left, right)
}

fn binary(operator: BinaryOp, left: Expr, right: Expr) -> Expr {
    let span = left.span;
    let operands = (Box::new(left), Box::new(right));
    expr(ExprKind::Binary(operator, operands.0, operands.1), span)
}
