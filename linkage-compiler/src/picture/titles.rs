//! Names of points and links.

use crate::model::{BinaryOp, Expr, ExprKind, Function, Mechanism};
use crate::picture::expressions;
use crate::picture::marks::{Spot, Title};

/// Names a point as an expression that is a name.
pub(super) fn name(mechanism: &Mechanism, point: &mut Spot, rank: u8, expr: &Expr) {
    if let Some(text) = expressions::spoken(mechanism, expr) {
        call(point, Title { rank, text });
    }
}

/// Gives a point a name, if it is better than the known one.
pub(super) fn call(point: &mut Spot, title: Title) {
    let name = &mut point.name;
    if name.as_ref().is_none_or(|known| title.rank < known.rank) {
        *name = Some(title);
    }
}

/// A link is called after its length, or else its angle.
pub(super) fn title(mechanism: &Mechanism, remoteness: u8, expr: &Expr) -> Option<Title> {
    let rank = |rank: u8| {
        let rank = rank + remoteness;
        move |text| Title { rank, text }
    };
    match &expr.kind {
        ExprKind::Name(_) => expressions::spoken(mechanism, expr).map(rank(1)),
        ExprKind::Call(Function::Polar, arguments) => {
            let length = expressions::dimension_in(mechanism, &arguments[0]).map(rank(2));
            length.or_else(|| expressions::spoken(mechanism, &arguments[1]).map(rank(3)))
        }
        ExprKind::Call(Function::Rotate | Function::Turn, arguments) => {
            let length = expressions::dimension_in(mechanism, &arguments[0]).map(rank(2));
            length.or_else(|| {
                expressions::spoken(mechanism, &arguments[arguments.len() - 1]).map(rank(3))
            })
        }
        ExprKind::Binary(BinaryOp::Mul, ..) | ExprKind::Vector(_) => {
            expressions::dimension_in(mechanism, expr).map(rank(2))
        }
        // Its link gets a number, or the names of what it joins.
        _ => None,
    }
}
