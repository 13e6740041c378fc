//! UniqueNames of points and links.

use crate::model::{BinaryOp, Expr, ExprKind, Function};
use crate::picture::expressions;
use crate::picture::marks::Title;
use crate::picture::sketch::Sketch;

pub(super) fn name(sketch: &mut Sketch<'_, '_>, point: usize, rank: u8, expr: &Expr) {
    if let Some(text) = expressions::spoken(sketch.algebra.mechanism, expr) {
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
        ExprKind::Name(_) => expressions::spoken(sketch.algebra.mechanism, expr).map(rank(1)),
        ExprKind::Call(Function::Polar, arguments) => {
            let length =
                expressions::dimension_in(sketch.algebra.mechanism, &arguments[0]).map(rank(2));
            length.or_else(|| {
                expressions::spoken(sketch.algebra.mechanism, &arguments[1]).map(rank(3))
            })
        }
        ExprKind::Call(Function::Rotate | Function::Turn, arguments) => {
            let length =
                expressions::dimension_in(sketch.algebra.mechanism, &arguments[0]).map(rank(2));
            length.or_else(|| {
                expressions::spoken(sketch.algebra.mechanism, &arguments[arguments.len() - 1])
                    .map(rank(3))
            })
        }
        ExprKind::Binary(BinaryOp::Mul, ..) | ExprKind::Vector(_) => {
            expressions::dimension_in(sketch.algebra.mechanism, expr).map(rank(2))
        }
        // Its link gets a number, or the names of what it joins.
        _ => None,
    }
}
