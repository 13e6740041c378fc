//! Sums of vectors, term by term.

use crate::model::{BinaryOp, Expr, ExprKind, Function, Name, Type};
use crate::picture::frames;
use crate::picture::parts;

use super::chains::{MANY_TERMS, Sketch};
use super::marks::Term;

/// Terms, named steps taken apart. A step of one term keeps its name.
pub(super) fn collect_terms<'m>(
    sketch: &mut Sketch<'_, 'm>,
    expr: &'m Expr,
    sign: f64,
    name: Option<&str>,
    terms: &mut Vec<Term<'m>>,
) {
    if terms.len() > MANY_TERMS {
        return;
    }
    let sign_of = |adds: bool| if adds { sign } else { -sign };
    if frames::elsewhere(sketch, expr).is_some() {
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
        (ExprKind::Name(own @ Name::Let(index)), _) if sketch.roles.is_step(*own) => {
            let mechanism = sketch.algebra.mechanism;
            let own = &mechanism.lets[*index];
            collect_terms(sketch, &own.value, sign, Some(&own.name), terms);
        }
        (_, [])
            if parts::literal(sketch, expr, sign, name, terms)
                || parts::turned(sketch, expr, sign, name, terms) => {}
        (_, []) => terms.push(Term {
            sign,
            expr,
            name: name.map(str::to_owned),
            part: None,
        }),
        (_, [(adds, only)]) => collect_terms(sketch, only, sign_of(*adds), name, terms),
        (_, all) => {
            for (adds, own) in all {
                collect_terms(sketch, own, sign_of(*adds), None, terms);
            }
        }
    }
}

/// How often a vector counts as a point: 1 for a point, 0 for a difference; `None` if it may be either.
pub(super) fn weight(sketch: &Sketch<'_, '_>, expr: &Expr) -> Option<f64> {
    let is_length = expr.ty.dimension().is_some_and(|own| own.half_lengths == 2);
    match &expr.kind {
        // A direction.
        _ if !is_length => None,
        _ if sketch.algebra.mechanism.standing(expr).is_some() => Some(1.0),
        ExprKind::Name(name @ (Name::Let(_) | Name::Unknown(_))) => {
            Some(if sketch.roles.is_step(*name) {
                0.0
            } else {
                1.0
            })
        }
        ExprKind::Index(..) | ExprKind::Call(Function::PointIn, _) => Some(1.0),
        ExprKind::Negate(a) => weight(sketch, a).map(|weight| -weight),
        ExprKind::Binary(op @ (BinaryOp::Add | BinaryOp::Sub), a, b) => {
            let (a, b) = (weight(sketch, a), weight(sketch, b));
            let sign = if *op == BinaryOp::Add { 1.0 } else { -1.0 };
            match (a, b) {
                (None, None) => None,
                _ => Some(a.unwrap_or(0.0) + sign * b.unwrap_or(0.0)),
            }
        }
        ExprKind::Binary(BinaryOp::Div, a, b) => scaled(sketch, a, |n| 1.0 / n, b),
        ExprKind::Binary(BinaryOp::Mul, a, b) => match a.ty {
            Type::Vector(..) => scaled(sketch, a, |n| n, b),
            _ => scaled(sketch, b, |n| n, a),
        },
        // A step, a mean, a parameter: whatever the others make of it.
        _ => None,
    }
}

/// The weight of a multiple of a vector.
fn scaled(
    sketch: &Sketch<'_, '_>,
    vector: &Expr,
    by: impl Fn(f64) -> f64,
    factor: &Expr,
) -> Option<f64> {
    match (weight(sketch, vector)?, &factor.kind) {
        (0.0, _) => Some(0.0),
        (weight, ExprKind::Number(number)) => Some(weight * by(*number)),
        // No point that chains could begin with.
        _ => Some(f64::NAN),
    }
}

/// How often a term counts as a point.
pub(super) fn weight_of(sketch: &Sketch<'_, '_>, term: &Term) -> f64 {
    if term.part.is_some() {
        return 0.0;
    }
    term.sign * weight(sketch, term.expr).unwrap_or(0.0)
}
