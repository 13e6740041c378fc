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

/// The terms of a literal; false if it is one step.
pub(super) fn literal<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    remoteness: u8,
    expr: &'m Expr,
    sign: f64,
    name: Option<&str>,
    terms: &mut Vec<Term<'m>>,
) -> bool {
    let ExprKind::Vector(components) = &expr.kind else {
        return false;
    };
    let pieces = literals::pieces(algebra, layout, remoteness, components);
    let are_pieces = !pieces.is_empty();
    terms.extend(pieces.into_iter().map(|piece| match piece {
        Piece::Point(point) => Term {
            sign,
            expr: point,
            name: None,
            part: None,
        },
        Piece::Part(part) => Term {
            sign,
            expr,
            name: name.filter(|_| part.moves != Moves::Not).map(str::to_owned),
            part: Some(part),
        },
    }));
    are_pieces
}

/// The terms of a turned sum, and of vectors that are turned more than once; false if it is one
/// step about one axis.
pub(super) fn turned<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    remoteness: u8,
    expr: &'m Expr,
    sign: f64,
    name: Option<&str>,
    terms: &mut Vec<Term<'m>>,
) -> bool {
    let ExprKind::Call(function @ (Function::Rotate | Function::Turn), arguments) = &expr.kind
    else {
        return false;
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
        return false;
    }
    for term in inner {
        let part = turned_part(algebra, layout, remoteness, *function, arguments, &term);
        let name = name.filter(|_| part.moves != Moves::Not);
        terms.push(Term {
            sign,
            expr,
            name: name.map(str::to_owned).or(term.name),
            part: Some(part),
        });
    }
    true
}

pub(super) fn turned_part<'m>(
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
    let mut terms = Vec::new();
    collect_terms(algebra, layout, remoteness, expr, 1.0, None, &mut terms);
    terms
}

/// Collects terms, named steps taken apart. A step of one term keeps its name.
fn collect_terms<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    remoteness: u8,
    expr: &'m Expr,
    sign: f64,
    name: Option<&str>,
    terms: &mut Vec<Term<'m>>,
) {
    if terms.len() > MANY_TERMS {
        return;
    }
    let sign_of = |adds: bool| if adds { sign } else { -sign };
    if frames::elsewhere(algebra.mechanism, expr).is_some() {
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
        (ExprKind::Name(name @ Name::Let(index)), _) if layout.roles.is_step(*name) => {
            let mechanism = algebra.mechanism;
            let item = &mechanism.lets[*index];
            collect_terms(
                algebra,
                layout,
                remoteness,
                &item.value,
                sign,
                Some(&item.name),
                terms,
            );
        }
        (_, [])
            if literal(algebra, layout, remoteness, expr, sign, name, terms)
                || turned(algebra, layout, remoteness, expr, sign, name, terms) => {}
        (_, []) => terms.push(Term {
            sign,
            expr,
            name: name.map(str::to_owned),
            part: None,
        }),
        (_, [(adds, only)]) => collect_terms(
            algebra,
            layout,
            remoteness,
            only,
            sign_of(*adds),
            name,
            terms,
        ),
        (_, summands) => {
            for (adds, summand) in summands {
                collect_terms(
                    algebra,
                    layout,
                    remoteness,
                    summand,
                    sign_of(*adds),
                    None,
                    terms,
                );
            }
        }
    }
}
