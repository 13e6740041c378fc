//! What points and links are called.

use crate::model::{BinaryOp, Expr, ExprKind, Function};

use super::chains::Sketch;
use super::marks::Title;

impl Sketch<'_, '_> {
    pub(super) fn name(&mut self, point: usize, rank: u8, expr: &Expr) {
        if let Some(text) = self.spoken(expr) {
            self.call(point, Title { rank, text });
        }
    }

    pub(super) fn call(&mut self, point: usize, title: Title) {
        let name = &mut self.points[point].name;
        if name.as_ref().is_none_or(|known| title.rank < known.rank) {
            *name = Some(title);
        }
    }

    /// A link is called after its length, or else its angle.
    pub(super) fn title(&self, expr: &Expr) -> Option<Title> {
        let rank = |rank: u8| {
            let rank = rank + self.remoteness;
            move |text| Title { rank, text }
        };
        match &expr.kind {
            ExprKind::Name(_) => self.spoken(expr).map(rank(1)),
            ExprKind::Call(Function::Polar, arguments) => {
                let length = self.dimension_in(&arguments[0]).map(rank(2));
                length.or_else(|| self.spoken(&arguments[1]).map(rank(3)))
            }
            ExprKind::Call(Function::Rotate | Function::Turn, arguments) => {
                let length = self.dimension_in(&arguments[0]).map(rank(2));
                length.or_else(|| self.spoken(&arguments[arguments.len() - 1]).map(rank(3)))
            }
            ExprKind::Binary(BinaryOp::Mul, ..) | ExprKind::Vector(_) => {
                self.dimension_in(expr).map(rank(2))
            }
            // Its link gets a number, or the names of what it joins.
            _ => None,
        }
    }

    pub(super) fn spoken(&self, expr: &Expr) -> Option<String> {
        let name = expr.as_name()?;
        Some(self.algebra.mechanism.name(name).to_owned())
    }

    /// The first length that is named in an expression.
    pub(super) fn dimension_in(&self, expr: &Expr) -> Option<String> {
        let mut lengths = expr.parts().filter(|own| {
            let dimension = own.ty.dimension();
            dimension.is_some_and(|own| own.half_lengths == 2)
        });
        lengths.find_map(|own| self.spoken(own))
    }
}
