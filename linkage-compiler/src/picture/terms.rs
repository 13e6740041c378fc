//! Sums of vectors, term by term, with literals and turned sums taken apart.

use linkage_symbolic::Vn;

use crate::algebra::Algebra;
use crate::model::{Expr, ExprKind, Function, Name};
use crate::picture::layout::Layout;
use crate::picture::literals::Piece;
use crate::picture::marks::{Slide, StepPart, Term, Title, Turn};
use crate::picture::point_or_vector::Moves;
use crate::picture::{directions, frames, layout, literals, parts, titles, weights};

/// Longer sums are not looked at.
pub(super) const MANY_TERMS: usize = 200;

/// Lengths that are only turned stand behind all names in derived quantities that loops use.
pub(super) const CARRIED: u8 = 4;

/// The terms of a literal; none if it is one step.
fn literal<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    remoteness: u8,
    whole: &Term<'m>,
) -> Vec<Term<'m>> {
    let ExprKind::Vector(components) = &whole.expr.kind else {
        return Vec::new();
    };
    let pieces = literals::pieces(algebra, layout, remoteness, components);
    let terms = pieces.into_iter().map(|piece| match piece {
        Piece::Point(point) => Term {
            sign: whole.sign,
            expr: point,
            name: None,
            part: None,
        },
        Piece::Part(part) => Term {
            sign: whole.sign,
            expr: whole.expr,
            name: whole.name.clone().filter(|_| part.moves != Moves::Not),
            part: Some(part),
        },
    });
    terms.collect()
}

/// The terms of a turned sum, and of vectors that are turned more than once; none if it is one step
/// about one axis.
fn turned<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    remoteness: u8,
    whole: &Term<'m>,
) -> Vec<Term<'m>> {
    let ExprKind::Call(function @ (Function::Rotate | Function::Turn), arguments) =
        &whole.expr.kind
    else {
        return Vec::new();
    };
    let inner = terms_of(algebra, layout, remoteness, &arguments[0]);
    let moves = |term: &Term| parts::moves_of(&layout.roles, term) != Moves::Not;
    let has_points = inner
        .iter()
        .any(|term| weights::weight_of(algebra.mechanism, &layout.roles, term) != 0.0);
    let nested = |term: &Term| matches!(term.expr.kind, ExprKind::Call(Function::Turn, _));
    let is_one = match &inner[..] {
        [one] => one.part.is_none() && !nested(one),
        terms => !terms.iter().any(moves),
    };
    if is_one || has_points {
        return Vec::new();
    }
    let terms = inner.into_iter().map(|term| {
        let part = turned_part(algebra, layout, remoteness, *function, arguments, &term);
        let name = whole.name.clone().filter(|_| part.moves != Moves::Not);
        Term {
            sign: whole.sign,
            expr: whole.expr,
            name: name.or(term.name),
            part: Some(part),
        }
    });
    terms.collect()
}

/// The part that a term within a turned sum becomes.
fn turned_part<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    remoteness: u8,
    function: Function,
    arguments: &'m [Expr],
    inner: &Term<'m>,
) -> StepPart<'m> {
    let step = parts::step_of(algebra, layout.dimension, inner);
    let step = if inner.sign > 0.0 { step } else { -step };
    let slide = match &inner.part {
        Some(part) => part.slide,
        None => directions::direction_of(algebra, layout.dimension, inner.expr),
    };
    let mut turn = |v: Vn<'m>| parts::turned_vector(algebra, function, arguments, v);
    let at = turn(step);
    let slide = slide.map(|slide| Slide {
        offset: slide.offset.map(&mut turn),
        along: turn(slide.along),
        input: slide.input,
    });
    let within = parts::turns_of(algebra, layout, inner);
    let mut turns = Vec::new();
    if function == Function::Turn && layout.roles.moves(&arguments[2]) != Moves::Not {
        turns.push(Turn {
            along: layout::vector(algebra, layout.dimension, &arguments[1]),
            by: Some(&arguments[2]),
        });
    }
    turns.extend(within.into_iter().map(|turn| Turn {
        along: parts::turned_vector(algebra, function, arguments, turn.along),
        ..turn
    }));
    let title = match &inner.part {
        Some(part) => part.title.clone(),
        None => titles::title(algebra.mechanism, remoteness, inner.expr),
    };
    // What is turned along with a length is called after it only if nothing else is.
    let title = title.map(|title| Title {
        rank: title.rank
            + if parts::moves_of(&layout.roles, inner) == Moves::Not {
                CARRIED
            } else {
                0
            },
        ..title
    });
    let moves = arguments[1..]
        .iter()
        .map(|argument| layout.roles.moves(argument))
        .max();
    StepPart {
        at,
        title,
        slide,
        moves: parts::moves_of(&layout.roles, inner).max(moves.unwrap_or(Moves::Not)),
        turns,
    }
}

/// The terms of a sum, named steps taken apart.
pub(super) fn terms_of<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    remoteness: u8,
    expr: &'m Expr,
) -> Vec<Term<'m>> {
    let whole = Term {
        sign: 1.0,
        expr,
        name: None,
        part: None,
    };
    let mut terms = Vec::new();
    collect_terms(algebra, layout, remoteness, whole, &mut terms);
    terms
}

/// Collects the terms of one term, named steps taken apart. A step of one term keeps its name.
fn collect_terms<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    remoteness: u8,
    whole: Term<'m>,
    terms: &mut Vec<Term<'m>>,
) {
    if terms.len() > MANY_TERMS {
        return;
    }
    let (sign, expr) = (whole.sign, whole.expr);
    let sign_of = |adds: bool| if adds { sign } else { -sign };
    if frames::elsewhere(algebra.mechanism, expr).is_some() {
        return terms.push(whole);
    }
    match (&expr.kind, &expr.summands()[..]) {
        (ExprKind::Number(0.0), _) => {}
        (ExprKind::Name(name @ Name::Let(index)), _) if layout.roles.is_step(*name) => {
            let item = &algebra.mechanism.lets[*index];
            let named = Term {
                expr: &item.value,
                name: Some(item.name.clone()),
                ..whole
            };
            collect_terms(algebra, layout, remoteness, named, terms);
        }
        (_, []) => {
            let mut within = literal(algebra, layout, remoteness, &whole);
            if within.is_empty() {
                within = turned(algebra, layout, remoteness, &whole);
            }
            if within.is_empty() {
                terms.push(whole);
            } else {
                terms.extend(within);
            }
        }
        (_, [(adds, only)]) => {
            let only = Term {
                sign: sign_of(*adds),
                expr: only,
                ..whole
            };
            collect_terms(algebra, layout, remoteness, only, terms);
        }
        (_, summands) => {
            for (adds, summand) in summands {
                let summand = Term {
                    sign: sign_of(*adds),
                    expr: summand,
                    name: None,
                    part: None,
                };
                collect_terms(algebra, layout, remoteness, summand, terms);
            }
        }
    }
}
