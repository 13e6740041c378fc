//! Splines: their points, how they end, of which degree they are.

use super::arguments::{expect_two_arguments, resolve_argument_and_knots, spans_a_turn};
use super::knots::read_spline_word;
use crate::diagnostic::SourceSpan;
use crate::model::expression::fitting::fit_to_type;
use crate::model::symbols::assumed_units::AssumedUnits;
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::operands::Operands;
use crate::model::symbols::sink::Sink;
use crate::model::types::{
    Ends, Knot, MotionLaw, MotionLawKind, MotionLawWord, Pieces, Repeats, SplineWord, Type,
};
use crate::syntax;

/// The words after the points.
#[derive(Default)]
struct SplineWords {
    ends: Option<Ends>,
    is_quintic: bool,
}

pub(in crate::model) fn resolve_spline(
    operands: Operands,
    sink: &mut Sink,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Option<(MotionLaw, Type)> {
    let (arguments, words) = match arguments.len() {
        3..=4 => arguments.split_at(2),
        _ => (arguments, &[][..]),
    };
    let words = read_spline_words(sink, words)?;
    let [x, list] = expect_two_arguments(sink, MotionLawWord::Spline, arguments, span)?;
    let (argument, mut knots, ty) =
        resolve_argument_and_knots(operands, sink, MotionLawWord::Spline, x, list)?;
    let pieces = choose_pieces(sink, &knots, &words)?;
    fit_slopes(
        &operands.scope.names,
        &operands.scope.units,
        sink,
        &mut knots,
        &ty,
    )?;
    let turn = spans_a_turn(&knots);
    let ends = words
        .ends
        .unwrap_or(if turn { Ends::Periodic } else { Ends::Natural });
    let repeats = match (ends, turn) {
        (Ends::Periodic, true) => Repeats::EachTurn,
        (Ends::Periodic, false) => Repeats::FromLastToFirst,
        (Ends::Natural | Ends::Clamped, _) => Repeats::Never,
    };
    let fact = match (ends, pieces, knots.len()) {
        (Ends::Periodic, _, found @ ..4) => {
            let found = found - 1;
            Some(format!(
                "a periodic spline goes through at least three points, found {found}"
            ))
        }
        (Ends::Natural, Pieces::Quintic, found @ ..3) => Some(format!(
            "a quintic spline with natural ends goes through at least three points, found {found}"
        )),
        _ => None,
    };
    if let Some(fact) = fact {
        let help = match ends {
            Ends::Periodic => "the last point is the first one, a period later",
            Ends::Natural | Ends::Clamped => "two points are joined by a line",
        };
        sink.error_with_help(list.span, fact, help);
        return None;
    }
    refuse_jumps(sink, &knots, ends, pieces)?;
    let course = MotionLaw {
        argument: Box::new(argument),
        knots,
        kind: MotionLawKind::Spline(ends, pieces),
        repeats,
        order: 0,
    };
    Some((course, ty))
}

fn read_spline_words(sink: &mut Sink, list: &[syntax::Expr]) -> Option<SplineWords> {
    let mut words = SplineWords::default();
    for word in list {
        let is_new = match read_spline_word(sink, word)? {
            SplineWord::Ends(ends) => words.ends.replace(ends).is_none(),
            SplineWord::Degree(_) => !std::mem::replace(&mut words.is_quintic, true),
        };
        if !is_new {
            let fact =
                "behind the points of a spline is one word for its ends and one for its degree";
            let help = "leave this one out";
            sink.error_with_help(word.span, fact, help);
            return None;
        }
    }
    Some(words)
}

/// Returns the kind of the pieces. Slopes are given at all points or at none.
fn choose_pieces(sink: &mut Sink, knots: &[Knot], words: &SplineWords) -> Option<Pieces> {
    let worded = knots.iter().find(|knot| knot.law.is_some());
    if let Some(knot) = worded {
        let span = sink.span(knot.origin);
        let fact = "a point of a spline has a place, a value and perhaps a slope, found a law";
        let help = "laws lead from knot to knot in `piecewise`";
        sink.error_with_help(span, fact, help);
        return None;
    }
    let with = knots.iter().filter(|knot| knot.slope.is_some()).count();
    if with == 0 {
        return Some(if words.is_quintic {
            Pieces::Quintic
        } else {
            Pieces::Cubic
        });
    }
    let clamped = words.ends == Some(Ends::Clamped);
    let fault = knots.iter().find(|knot| knot.slope.is_none() || clamped);
    if let Some(knot) = fault {
        let span = sink.span(knot.origin);
        let (fact, help) = if clamped {
            (
                "the slopes at the ends of this spline are given, and `clamped` would give others"
                    .to_owned(),
                "leave `clamped` out: behind its ends it goes on with the slopes given",
            )
        } else {
            (
                format!(
                    "{with} of {} points of this spline have a slope, this one has none",
                    knots.len()
                ),
                "give all points a slope, or none: `(place, value, slope)`",
            )
        };
        sink.error_with_help(span, fact, help);
        return None;
    }
    Some(Pieces::QuinticBySlopes)
}

/// Slopes are values over places.
fn fit_slopes(
    names: &Names,
    units: &AssumedUnits,
    sink: &mut Sink,
    knots: &mut [Knot],
    value: &Type,
) -> Option<()> {
    let abscissa = knots[0].abscissa.ty.dimension()?;
    let wanted = Type::Scalar(value.dimension()?.over(abscissa)?);
    for slope in knots.iter_mut().filter_map(|knot| knot.slope.as_mut()) {
        *slope = fit_to_type(
            names,
            units,
            sink,
            slope.clone(),
            &wanted,
            "the slope at a point of this spline",
        );
    }
    let slopes = knots.iter().filter_map(|knot| knot.slope.as_ref());
    let sound = slopes.into_iter().all(|slope| !slope.ty.is_error());
    sound.then_some(())
}

/// Refuses `jump` where nothing can jump.
fn refuse_jumps(sink: &mut Sink, knots: &[Knot], ends: Ends, pieces: Pieces) -> Option<()> {
    let jumps = ends == Ends::Clamped && pieces == Pieces::Cubic;
    let last = knots.len() - 1;
    let mut numbered = knots.iter().enumerate();
    let refused = numbered.find(|(k, knot)| knot.may_jump && !(jumps && (*k == 0 || *k == last)));
    let Some((_, knot)) = refused else {
        return Some(());
    };
    let span = sink.span(knot.origin);
    let fact = "neither speed nor acceleration of a spline jumps here";
    let help = "leave `jump` out: only where a cubic spline is `clamped` its acceleration jumps";
    sink.error_with_help(span, fact, help);
    None
}
