//! `rise`, `piecewise` and `spline`: what they are written with.

mod knots;
mod slope;
mod spline;

use std::f64::consts::TAU;

use super::agreement::common_type;
use super::assumed_units::AssumedUnits;
use super::bare::refuse_bare_angle;
use super::functions::CourseWord;
use super::names::Names;
use super::nodes::{error_expr, make_expr};
use super::operands::Operands;
use super::operators::settle_alone;
use super::sink::Sink;
use super::types::{
    BinaryOp, Course, CourseKind, Dimension, Expr, ExprKind, Knot, Repeating, Repeats, Type,
};
use crate::diagnostic::SourceSpan;
use crate::diagnostic::text::count;
use crate::syntax::{self, Word};
use knots::{read_law, read_repeating, resolve_knots};
use slope::resolve_slope;
use spline::resolve_spline;

/// How far knots may be from a turn apart to be meant so: angles are rounded once or twice.
const TURN_ROUNDING: f64 = 4.0 * f64::EPSILON * TAU;

impl CourseWord {
    /// How it is written, in messages.
    pub(super) fn form(self) -> &'static str {
        match self {
            CourseWord::Rise => "rise(x, law)",
            CourseWord::Piecewise => {
                "piecewise(x, [(place, value), (place, value, law)])` or `piecewise(x, [...], periodic)"
            }
            CourseWord::Spline => "spline(x, [(place, value), (place, value)], ends)",
            CourseWord::Slope => "slope(course)",
        }
    }
}

pub(super) fn resolve_course(
    operands: Operands,
    sink: &mut Sink,
    word: CourseWord,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Expr {
    let course = match word {
        CourseWord::Rise => resolve_rise(operands, sink, arguments, span),
        CourseWord::Piecewise => resolve_piecewise(operands, sink, arguments, span),
        CourseWord::Spline => resolve_spline(operands, sink, arguments, span),
        CourseWord::Slope => resolve_slope(operands, sink, arguments, span),
    };
    match course {
        Some((course, ty)) => make_expr(sink, ExprKind::Course(course), ty, span),
        None => error_expr(sink, span),
    }
}

fn resolve_rise(
    operands: Operands,
    sink: &mut Sink,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Option<(Course, Type)> {
    let [x, law] = expect_two_arguments(sink, CourseWord::Rise, arguments, span)?;
    let mut argument = operands.resolve(sink, x);
    let law = read_law(sink, law);
    settle_alone(&mut argument);
    let number = Type::Scalar(Dimension::NUMBER);
    if !argument.ty.is_error() && argument.ty != number {
        let fact = format!(
            "`rise` takes a number that goes from 0 to 1, found {}",
            argument.ty
        );
        let help = match argument.ty {
            Type::Scalar(_) => "divide by the whole way: `rise((phi - 30deg) / 90deg, law)`",
            _ => "take a component `.x` or the length `norm(v)`",
        };
        sink.error_with_help(x.span, fact, help);
        return None;
    }
    if argument.ty.is_error() {
        return None;
    }
    let mut knot = |at: f64, law| {
        let [place, value] =
            [0; 2].map(|_| make_expr(sink, ExprKind::Number(at), number.clone(), span));
        let origin = sink.add_origin(span);
        Knot {
            place,
            value,
            slope: None,
            law,
            may_jump: true,
            origin,
        }
    };
    let knots = vec![knot(0.0, None), knot(1.0, Some(law?))];
    let course = Course {
        argument: Box::new(argument),
        knots,
        kind: CourseKind::Rise,
        repeats: Repeats::Never,
        order: 0,
    };
    Some((course, Type::NUMBER))
}

fn resolve_piecewise(
    operands: Operands,
    sink: &mut Sink,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Option<(Course, Type)> {
    let word = CourseWord::Piecewise;
    let (arguments, repeating) = match arguments {
        [before @ .., last] if arguments.len() == 3 => (before, Some(read_repeating(sink, last)?)),
        all => (all, None),
    };
    let [x, list] = expect_two_arguments(sink, word, arguments, span)?;
    let (argument, knots, ty) = resolve_argument_and_knots(operands, sink, word, x, list)?;
    if knots[0].law.is_some() {
        let span = sink.span(knots[0].origin);
        let fact = "no piece leads to the first knot, so it has no law";
        let help = "the law of a piece stands with the knot at its end";
        sink.error_with_help(span, fact, help);
        return None;
    }
    let repeats = match (spans_a_turn(&knots), repeating) {
        (true, _) => Repeats::EachTurn,
        (false, Some(Repeating::Periodic)) => Repeats::FromLastToFirst,
        (false, None) => Repeats::Never,
    };
    let argument = Box::new(argument);
    Some((
        Course {
            argument,
            knots,
            kind: CourseKind::Laws,
            repeats,
            order: 0,
        },
        ty,
    ))
}

/// The two arguments of a function.
fn expect_two_arguments<'e>(
    sink: &mut Sink,
    word: CourseWord,
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
fn resolve_argument_and_knots(
    operands: Operands,
    sink: &mut Sink,
    word: CourseWord,
    x: &syntax::Expr,
    list: &syntax::Expr,
) -> Option<(Expr, Vec<Knot>, Type)> {
    let mut argument = operands.resolve(sink, x);
    let knots = resolve_knots(operands, sink, word, list);
    let mut knots = knots.filter(|_| !argument.ty.is_error())?;
    let mut along: Vec<&mut Expr> = vec![&mut argument];
    along.extend(knots.iter_mut().map(|own| &mut own.place));
    let what = format!(
        "the argument of `{}` and the places of its knots",
        word.word()
    );
    let place = common_scalar(
        &operands.scope.names,
        &operands.scope.units,
        sink,
        &mut along,
        word,
        &what,
    )?;
    let mut values: Vec<&mut Expr> = knots.iter_mut().map(|own| &mut own.value).collect();
    let what = format!("the values of `{}`", word.word());
    let value = common_scalar(
        &operands.scope.names,
        &operands.scope.units,
        sink,
        &mut values,
        word,
        &what,
    )?;
    if let Type::Scalar(Dimension { angle: true, .. }) = place {
        let before = sink.diagnostics.len();
        knots
            .iter()
            .for_each(|own| refuse_bare_angle(sink, &own.place, "the place of a knot"));
        if sink.diagnostics.len() > before {
            return None;
        }
    }
    Some((argument, knots, value))
}

/// The type of scalars that belong together.
fn common_scalar(
    names: &Names,
    units: &AssumedUnits,
    sink: &mut Sink,
    all: &mut [&mut Expr],
    word: CourseWord,
    what: &str,
) -> Option<Type> {
    let ty = common_type(names, units, sink, all, what).settled();
    all.iter_mut().for_each(|own| own.settle(&ty));
    match ty {
        Type::Scalar(_) => Some(ty),
        Type::Error => None,
        _ => {
            let fact = format!("`{}` takes scalars, found {ty}", word.word());
            let span = sink.span(all[0].origin);
            let help = "take a component `.x`; a vector has a course for each component";
            sink.error_with_help(span, fact, help);
            None
        }
    }
}

/// Whether the last knot stands a turn behind the first one, whatever the dimensions are: both are numbers, or the last one is
/// written as the first one and `360deg`.
fn spans_a_turn(knots: &[Knot]) -> bool {
    let (Some(first), Some(last)) = (knots.first(), knots.last()) else {
        return false;
    };
    let (first, last) = (&first.place, &last.place);
    if !matches!(first.ty, Type::Scalar(own) if own.angle) {
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
fn number(expr: &Expr) -> Option<f64> {
    match &expr.kind {
        ExprKind::Number(value) => Some(*value),
        ExprKind::Negate(inner) => number(inner).map(|value| -value),
        _ => None,
    }
}
