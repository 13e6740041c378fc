//! `rise` and `piecewise`: laws of motion from knot to knot.

use super::arguments::{expect_two_arguments, resolve_argument_and_knots, spans_a_turn};
use super::knots::{read_law, read_repeating};
use crate::diagnostic::SourceSpan;
use crate::model::expression::nodes::make_expr;
use crate::model::expression::operators::settle_alone;
use crate::model::symbols::operands::Operands;
use crate::model::symbols::sink::Sink;
use crate::model::types::{
    Dimension, ExprKind, Knot, MotionLaw, MotionLawKind, MotionLawWord, Repeating, Repeats, Type,
};
use crate::syntax::{self};

pub(in crate::model) fn resolve_rise(
    operands: Operands,
    sink: &mut Sink,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Option<(MotionLaw, Type)> {
    let [x, law] = expect_two_arguments(sink, MotionLawWord::Rise, arguments, span)?;
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
        let [abscissa, value] =
            [0; 2].map(|_| make_expr(sink, ExprKind::Number(at), number.clone(), span));
        let origin = sink.add_origin(span);
        Knot {
            abscissa,
            value,
            slope: None,
            law,
            may_jump: true,
            origin,
        }
    };
    let knots = vec![knot(0.0, None), knot(1.0, Some(law?))];
    let course = MotionLaw {
        argument: Box::new(argument),
        knots,
        kind: MotionLawKind::Rise,
        repeats: Repeats::Never,
        order: 0,
    };
    Some((course, Type::NUMBER))
}

pub(in crate::model) fn resolve_piecewise(
    operands: Operands,
    sink: &mut Sink,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Option<(MotionLaw, Type)> {
    let word = MotionLawWord::Piecewise;
    let (arguments, repeating) = match arguments {
        [before @ .., last] if arguments.len() == 3 => (before, Some(read_repeating(sink, last)?)),
        arguments => (arguments, None),
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
        MotionLaw {
            argument,
            knots,
            kind: MotionLawKind::Laws,
            repeats,
            order: 0,
        },
        ty,
    ))
}
