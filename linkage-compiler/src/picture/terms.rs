//! Sums of vectors, term by term.

use crate::model::{BinaryOp, Expr, ExprKind, Function, Name, Type};

use super::chains::{MANY_TERMS, Sketch};
use super::marks::Term;

impl<'m> Sketch<'_, 'm> {
    /// Terms, named steps taken apart. A step of one term keeps its name.
    pub(super) fn terms(
        &mut self,
        expr: &'m Expr,
        sign: f64,
        name: Option<&str>,
        terms: &mut Vec<Term<'m>>,
    ) {
        if terms.len() > MANY_TERMS {
            return;
        }
        let sign_of = |adds: bool| if adds { sign } else { -sign };
        if self.elsewhere(expr).is_some() {
            let (name, part) = (name.map(str::to_owned), None);
            return terms.push(Term {
                sign,
                expr,
                name,
                part,
            });
        }
        match (&expr.kind, &expr.summands()[..]) {
            (ExprKind::Number(0.0), _) => {}
            (ExprKind::Name(own @ Name::Let(index)), _) if self.roles.is_step(*own) => {
                let mechanism = self.algebra.mechanism;
                let own = &mechanism.lets[*index];
                self.terms(&own.value, sign, Some(&own.name), terms);
            }
            (_, [])
                if self.literal(expr, sign, name, terms)
                    || self.turned(expr, sign, name, terms) => {}
            (_, []) => terms.push(Term {
                sign,
                expr,
                name: name.map(str::to_owned),
                part: None,
            }),
            (_, [(adds, only)]) => self.terms(only, sign_of(*adds), name, terms),
            (_, all) => {
                for (adds, own) in all {
                    self.terms(own, sign_of(*adds), None, terms);
                }
            }
        }
    }

    /// How often a vector counts as a point: 1 for a point, 0 for a difference; `None` if it may be either.
    pub(super) fn weight(&self, expr: &Expr) -> Option<f64> {
        let is_length = expr.ty.dimension().is_some_and(|own| own.half_lengths == 2);
        match &expr.kind {
            // A direction.
            _ if !is_length => None,
            _ if self.algebra.mechanism.standing(expr).is_some() => Some(1.0),
            ExprKind::Name(name @ (Name::Let(_) | Name::Unknown(_))) => {
                Some(if self.roles.is_step(*name) { 0.0 } else { 1.0 })
            }
            ExprKind::Index(..) | ExprKind::Call(Function::PointIn, _) => Some(1.0),
            ExprKind::Negate(a) => self.weight(a).map(|weight| -weight),
            ExprKind::Binary(op @ (BinaryOp::Add | BinaryOp::Sub), a, b) => {
                let (a, b) = (self.weight(a), self.weight(b));
                let sign = if *op == BinaryOp::Add { 1.0 } else { -1.0 };
                match (a, b) {
                    (None, None) => None,
                    _ => Some(a.unwrap_or(0.0) + sign * b.unwrap_or(0.0)),
                }
            }
            ExprKind::Binary(BinaryOp::Div, a, b) => self.scaled(a, |n| 1.0 / n, b),
            ExprKind::Binary(BinaryOp::Mul, a, b) => match a.ty {
                Type::Vector(..) => self.scaled(a, |n| n, b),
                _ => self.scaled(b, |n| n, a),
            },
            // A step, a mean, a parameter: whatever the others make of it.
            _ => None,
        }
    }

    /// The weight of a multiple of a vector.
    fn scaled(&self, vector: &Expr, by: impl Fn(f64) -> f64, factor: &Expr) -> Option<f64> {
        match (self.weight(vector)?, &factor.kind) {
            (0.0, _) => Some(0.0),
            (weight, ExprKind::Number(number)) => Some(weight * by(*number)),
            // No point that chains could begin with.
            _ => Some(f64::NAN),
        }
    }

    /// How often a term counts as a point.
    pub(super) fn weight_of(&self, term: &Term) -> f64 {
        if term.part.is_some() {
            return 0.0;
        }
        term.sign * self.weight(term.expr).unwrap_or(0.0)
    }
}
