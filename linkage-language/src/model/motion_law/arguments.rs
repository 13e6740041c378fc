//! Arguments of courses: the number along which a course goes, and its knots.

use std::f64::consts::TAU;

use super::knots::resolve_knots;
use crate::diagnostic::SourceSpan;
use crate::diagnostic::text::count;
use crate::model::expression::agreement::common_type;
use crate::model::expression::bare_numbers::refuse_bare_angle;
use crate::model::symbols::assumed_units::AssumedUnits;
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::operands::Operands;
use crate::model::symbols::sink::Sink;
use crate::model::types::{BinaryOp, Dimension, Expr, ExprKind, Knot, MotionLawWord, Type};
use crate::syntax::{self, Word};

/// The greatest rounding error of knots that are a turn apart: angles are rounded once or twice.
pub(in crate::model) const TURN_ROUNDING: f64 = 4.0 * f64::EPSILON * TAU;

/// The two arguments of a function.
pub(in crate::model) fn expect_two_arguments<'e>(
    sink: &mut Sink,
    word: MotionLawWord,
    arguments: &'e [syntax::Expr],
    span: SourceSpan,
) -> Option<[&'e syntax::Expr; 2]> {
    if let [x, second] = arguments {
        return Some([x, second]);
    }
    let found = count(arguments.len(), "argument");
    let fact = format!(
        "`{}` is written with an argument and what it is to become, found {found}",
        word.word()
    );
    sink.error_with_help(span, fact, format!("write `{}`", word.form()));
    None
}

/// The argument and the knots, with the type of the values.
pub(in crate::model) fn resolve_argument_and_knots(
    operands: Operands,
    sink: &mut Sink,
    word: MotionLawWord,
    x: &syntax::Expr,
    list: &syntax::Expr,
) -> Option<(Expr, Vec<Knot>, Type)> {
    let mut argument = operands.resolve(sink, x);
    let knots = resolve_knots(operands, sink, word, list);
    let mut knots = knots.filter(|_| !argument.ty.is_error())?;
    let mut along: Vec<&mut Expr> = vec![&mut argument];
    along.extend(knots.iter_mut().map(|knot| &mut knot.abscissa));
    let what = format!(
        "the argument of `{}` and the places of its knots",
        word.word()
    );
    let abscissa = common_scalar(
        &operands.scope.names,
        &operands.scope.units,
        sink,
        &mut along,
        word,
        &what,
    )?;
    let mut values: Vec<&mut Expr> = knots.iter_mut().map(|knot| &mut knot.value).collect();
    let what = format!("the values of `{}`", word.word());
    let value = common_scalar(
        &operands.scope.names,
        &operands.scope.units,
        sink,
        &mut values,
        word,
        &what,
    )?;
    if let Type::Scalar(Dimension { angle: true, .. }) = abscissa {
        let before = sink.diagnostics.len();
        knots
            .iter()
            .for_each(|knot| refuse_bare_angle(sink, &knot.abscissa, "the place of a knot"));
        if sink.diagnostics.len() > before {
            return None;
        }
    }
    Some((argument, knots, value))
}

/// The type of scalars that belong together.
pub(in crate::model) fn common_scalar(
    names: &Names,
    units: &AssumedUnits,
    sink: &mut Sink,
    values: &mut [&mut Expr],
    word: MotionLawWord,
    what: &str,
) -> Option<Type> {
    let ty = common_type(names, units, sink, values, what).settled();
    values.iter_mut().for_each(|value| value.settle(&ty));
    match ty {
        Type::Scalar(_) => Some(ty),
        Type::Error => None,
        _ => {
            let fact = format!("`{}` takes scalars, found {ty}", word.word());
            let span = sink.span(values[0].origin);
            let help = "take a component `.x`; a vector has a course for each component";
            sink.error_with_help(span, fact, help);
            None
        }
    }
}

/// Returns true if the last knot is a turn after the first one for all dimensions: both are
/// numbers, or the last one is written as the first one plus `360deg`.
pub(in crate::model) fn spans_a_turn(knots: &[Knot]) -> bool {
    let (Some(first), Some(last)) = (knots.first(), knots.last()) else {
        return false;
    };
    let (first, last) = (&first.abscissa, &last.abscissa);
    if !matches!(first.ty, Type::Scalar(dimension) if dimension.angle) {
        return false;
    }
    let turn = |x: f64| (x - TAU).abs() <= TURN_ROUNDING;
    if let (Some(first), Some(last)) = (number(first), number(last)) {
        return turn(last - first);
    }
    match &last.kind {
        ExprKind::Binary(BinaryOp::Add, a, b) => {
            (**a == *first && number(b).is_some_and(turn))
                || (**b == *first && number(a).is_some_and(turn))
        }
        // Other forms may be a turn apart for some dimensions alone.
        _ => false,
    }
}

/// A number as it is written, with signs.
pub(in crate::model) fn number(expr: &Expr) -> Option<f64> {
    match &expr.kind {
        ExprKind::Number(value) => Some(*value),
        ExprKind::Negate(inner) => number(inner).map(|value| -value),
        _ => None,
    }
}
