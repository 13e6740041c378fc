//! Courses as expressions: one law of each kind, whose coefficients are chosen by the place, so that a course of many pieces costs
//! little more than one piece.
//!
//! A piece from place `a` to `b` and from value `p` to `q` is `p + (q - p) s(x)` with `x = (u - a) / (b - a)`; where nothing moves the
//! rate `1 / (b - a)` is 0, so that `x` and `s` are, and whatever else the piece might choose is left as its neighbour has it. At a
//! knot the piece behind it counts.

use linkage_symbolic::Ex;
use linkage_symbolic::program::Unary;

use super::choice::Choice;
use super::law::profile;
use crate::model::{Law, MotionLaw, MotionLawKind, Pieces, Repeats};

mod blocks;
mod quintic;
mod spline;

pub(crate) use spline::clamped_curvatures;

/// A turn in two parts, the first one so short that its products with whole numbers are exact, in single precision, too.
const TURN_HIGH: f64 = 6.28125;
/// The rest: `2 pi - TURN_HIGH`.
const TURN_LOW: f64 = 1.935_307_179_586_476_9e-3;

/// The value of a course at `argument`, or its derivative by that, its knots given as places and values, those of some splines as slopes, too.
pub(super) fn value<'m>(
    argument: Ex<'m>,
    course: &MotionLaw,
    knots: &[(Ex<'m>, Ex<'m>)],
    slopes: &[Ex<'m>],
) -> Ex<'m> {
    let along = if_ordered(wound(argument, course.repeats, knots), knots);
    let order = usize::from(course.order);
    match course.kind {
        MotionLawKind::Rise | MotionLawKind::Laws => {
            let laws: Vec<Option<Law>> = course.knots.iter().map(|own| own.law).collect();
            by_laws(along, knots, &laws, course.repeats, order)
        }
        MotionLawKind::Spline(ends, Pieces::Cubic) => spline::value(along, knots, ends, order),
        MotionLawKind::Spline(ends, Pieces::Quintic) => {
            quintic::value(along, knots, None, ends, order)
        }
        MotionLawKind::Spline(ends, Pieces::QuinticBySlopes) => {
            quintic::value(along, knots, Some(slopes), ends, order)
        }
    }
}

/// The argument within the first period. It is as it was where it is there already, and its rate is the same everywhere.
fn wound<'m>(argument: Ex<'m>, repeats: Repeats, knots: &[(Ex<'m>, Ex<'m>)]) -> Ex<'m> {
    let (first, last) = (knots[0].0, knots[knots.len() - 1].0);
    match repeats {
        Repeats::Never => argument,
        Repeats::EachTurn => {
            let turns = periods(argument, first, argument.number(std::f64::consts::TAU));
            (argument - turns * TURN_HIGH) - turns * TURN_LOW
        }
        Repeats::FromLastToFirst => {
            let period = last - first;
            argument - periods(argument, first, period) * period
        }
    }
}

/// How many whole periods lie between `first` and `argument`: the nearest number of them, less one if that is too many.
fn periods<'m>(argument: Ex<'m>, first: Ex<'m>, period: Ex<'m>) -> Ex<'m> {
    let from_first = argument - first;
    let frequency = 1.0 / period;
    let nearest = (from_first * frequency).whole();
    let rest = from_first - nearest * period;
    // As a sign, since a choice between neighbouring numbers becomes a branch.
    (nearest - 0.5) + 0.5 * rest.unary(Unary::Sign)
}

/// What a piece is made of; `None` where nothing moves.
struct Moving<'m> {
    from: Ex<'m>,
    rate: Ex<'m>,
    height: Ex<'m>,
    law: Law,
}

fn by_laws<'m>(
    along: Ex<'m>,
    knots: &[(Ex<'m>, Ex<'m>)],
    laws: &[Option<Law>],
    repeats: Repeats,
    order: usize,
) -> Ex<'m> {
    let places: Vec<Ex> = knots.iter().map(|own| own.0).collect();
    let mut bases: Vec<Ex> = Vec::new();
    let mut pieces: Vec<Option<Moving>> = Vec::new();
    for (ends, law) in knots.windows(2).zip(&laws[1..]) {
        let [(from, before), (to, after)] = [ends[0], ends[1]];
        let width = to - from;
        bases.push(before);
        pieces.push(law.map(|law| Moving {
            from,
            rate: 1.0 / width,
            height: after - before,
            law,
        }));
    }
    let borders = match repeats {
        Repeats::EachTurn | Repeats::FromLastToFirst => &places[1..places.len() - 1],
        Repeats::Never => {
            // Before the first knot and from the last one on it rests.
            bases.insert(0, knots[0].1);
            pieces.insert(0, None);
            bases.push(knots[knots.len() - 1].1);
            pieces.push(None);
            &places[..]
        }
    };
    let choice = Choice::new(along, borders);
    let base = match order {
        0 => choice.of(&bases),
        // Values of which each piece has another are no part of a slope.
        _ => along.number(0.0),
    };
    let Some(some) = pieces.iter().flatten().next() else {
        return base;
    };
    let rest = along.number(0.0);
    let rates: Vec<Ex> = pieces
        .iter()
        .map(|own| own.as_ref().map_or(rest, |own| own.rate))
        .collect();
    let with_neighbour = filled(&pieces, some);
    let from = choice.of(&with_neighbour
        .iter()
        .map(|own| own.from)
        .collect::<Vec<_>>());
    let height = choice.of(&with_neighbour
        .iter()
        .map(|own| own.height)
        .collect::<Vec<_>>());
    let laws: Vec<Law> = with_neighbour.iter().map(|own| own.law).collect();
    let way = along - from;
    let rate = choice.of(&rates);
    let x = way * rate;
    // Each derivative by the place brings the rate once more.
    let height = (0..order).fold(height, |height, _| height * rate);
    base + height * profile(x, &choice, &laws)[order]
}

/// What pieces have; those that have nothing have what the last one before them has, or else the first one of all.
pub(super) fn filled<'p, T>(pieces: &'p [Option<T>], first: &'p T) -> Vec<&'p T> {
    let mut last = first;
    let next = |own: &'p Option<T>| {
        last = own.as_ref().unwrap_or(last);
        last
    };
    pieces.iter().map(next).collect()
}

/// The place, or NaN if knots that are no numbers are out of order, which other dimensions may lead to: that is found in `assemble()`.
fn if_ordered<'m>(along: Ex<'m>, knots: &[(Ex<'m>, Ex<'m>)]) -> Ex<'m> {
    let widths = knots.windows(2).map(|own| own[1].0 - own[0].0);
    let open = widths.filter(|own| own.constant_value().is_none());
    match open.reduce(Ex::min) {
        Some(least) => along + least.select(along.number(0.0), along.number(f64::NAN)),
        None => along,
    }
}
