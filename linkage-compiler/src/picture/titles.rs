//! What points and links are called.

use crate::model::{BinaryOp, Expr, ExprKind, Function};

use super::chains::Sketch;
use super::marks::Title;

pub(super) fn name(sketch: &mut Sketch<'_, '_>, point: usize, rank: u8, expr: &Expr) {
    if let Some(text) = spoken(sketch, expr) {
        call(sketch, point, Title { rank, text });
    }
}

pub(super) fn call(sketch: &mut Sketch<'_, '_>, point: usize, title: Title) {
    let name = &mut sketch.points[point].name;
    if name.as_ref().is_none_or(|known| title.rank < known.rank) {
        *name = Some(title);
    }
}

/// A link is called after its length, or else its angle.
pub(super) fn title(sketch: &Sketch<'_, '_>, expr: &Expr) -> Option<Title> {
    let rank = |rank: u8| {
        let rank = rank + sketch.remoteness;
        move |text| Title { rank, text }
    };
    match &expr.kind {
        ExprKind::Name(_) => spoken(sketch, expr).map(rank(1)),
        ExprKind::Call(Function::Polar, arguments) => {
            let length = dimension_in(sketch, &arguments[0]).map(rank(2));
            length.or_else(|| spoken(sketch, &arguments[1]).map(rank(3)))
        }
        ExprKind::Call(Function::Rotate | Function::Turn, arguments) => {
            let length = dimension_in(sketch, &arguments[0]).map(rank(2));
            length.or_else(|| spoken(sketch, &arguments[arguments.len() - 1]).map(rank(3)))
        }
        ExprKind::Binary(BinaryOp::Mul, ..) | ExprKind::Vector(_) => {
            dimension_in(sketch, expr).map(rank(2))
        }
        // Its link gets a number, or the names of what it joins.
        _ => None,
    }
}

pub(super) fn spoken(sketch: &Sketch<'_, '_>, expr: &Expr) -> Option<String> {
    let name = expr.as_name()?;
    Some(sketch.algebra.mechanism.name(name).to_owned())
}

/// The first length that is named in an expression.
pub(super) fn dimension_in(sketch: &Sketch<'_, '_>, expr: &Expr) -> Option<String> {
    let mut lengths = expr.parts().filter(|own| {
        let dimension = own.ty.dimension();
        dimension.is_some_and(|own| own.half_lengths == 2)
    });
    lengths.find_map(|own| spoken(sketch, own))
}
