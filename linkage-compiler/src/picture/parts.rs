//! Parts of what is written as one term: of literals, and of turned sums.

use crate::algebra::calls;
use crate::algebra::translate;
use crate::picture::guides;
use crate::picture::literals;
use crate::picture::terms;
use crate::picture::titles;
use linkage_symbolic::Vn;

use crate::algebra::{Translate, Value};
use crate::model::{Expr, ExprKind, Function};

use super::chains::Sketch;
use super::literals::Piece;
use super::marks::{Term, Title};
use super::point_or_vector::Moves;

/// Lengths that are only turned stand behind all names in derived quantities that loops use.
const CARRIED: u8 = 4;

/// A step within a term.
#[derive(Clone, Debug)]
pub(super) struct Part<'m> {
    pub(super) at: Vn<'m>,
    pub(super) title: Option<Title>,
    /// Along which it changes, if its length does.
    pub(super) slide: Option<Slide<'m>>,
    pub(super) moves: Moves,
    /// In space, from outside to inside.
    pub(super) turns: Vec<Turn<'m>>,
}

/// What turns a step in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Turn<'m> {
    pub(super) along: Vn<'m>,
    /// The angle, where it is written.
    pub(super) by: Option<&'m Expr>,
}

/// How a step changes its length.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slide<'m> {
    /// What it contains across that.
    pub(super) offset: Option<Vn<'m>>,
    /// A unit vector.
    pub(super) along: Vn<'m>,
    /// The input that is its length, or in it.
    pub(super) input: Option<usize>,
}

/// The terms of a literal; false if it is one step.
pub(super) fn literal<'m>(
    sketch: &mut Sketch<'_, 'm>,
    expr: &'m Expr,
    sign: f64,
    name: Option<&str>,
    terms: &mut Vec<Term<'m>>,
) -> bool {
    let ExprKind::Vector(components) = &expr.kind else {
        return false;
    };
    let pieces = literals::pieces(sketch, components);
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

/// The terms of a turned sum, and of what is turned more than once; false if it is one step about one axis.
pub(super) fn turned<'m>(
    sketch: &mut Sketch<'_, 'm>,
    expr: &'m Expr,
    sign: f64,
    name: Option<&str>,
    terms: &mut Vec<Term<'m>>,
) -> bool {
    let ExprKind::Call(function @ (Function::Rotate | Function::Turn), arguments) = &expr.kind
    else {
        return false;
    };
    let mut inner = Vec::new();
    terms::collect_terms(sketch, &arguments[0], 1.0, None, &mut inner);
    let moves = |term: &Term| moves_of(sketch, term) != Moves::Not;
    let has_points = inner
        .iter()
        .any(|term| terms::weight_of(sketch, term) != 0.0);
    let nested = |term: &Term| matches!(term.expr.kind, ExprKind::Call(Function::Turn, _));
    let is_one = match &inner[..] {
        [one] => one.part.is_none() && !nested(one),
        all => !all.iter().any(moves),
    };
    if is_one || has_points {
        return false;
    }
    for own in inner {
        let part = turned_part(sketch, *function, arguments, &own);
        let name = name.filter(|_| part.moves != Moves::Not);
        terms.push(Term {
            sign,
            expr,
            name: name.map(str::to_owned).or(own.name),
            part: Some(part),
        });
    }
    true
}

fn turned_part<'m>(
    sketch: &mut Sketch<'_, 'm>,
    function: Function,
    arguments: &'m [Expr],
    inner: &Term<'m>,
) -> Part<'m> {
    let step = step_of(sketch, inner);
    let step = if inner.sign > 0.0 { step } else { -step };
    let slide = match &inner.part {
        Some(part) => part.slide,
        None => guides::direction_of(sketch, inner.expr),
    };
    let mut turn = |v: Vn<'m>| turned_vector(sketch, function, arguments, v);
    let at = turn(step);
    let slide = slide.map(|own| Slide {
        offset: own.offset.map(&mut turn),
        along: turn(own.along),
        input: own.input,
    });
    let within = turns_of(sketch, inner);
    let mut turns = Vec::new();
    if function == Function::Turn && sketch.moves(&arguments[2]) != Moves::Not {
        turns.push(Turn {
            along: sketch.vector(&arguments[1]),
            by: Some(&arguments[2]),
        });
    }
    turns.extend(within.into_iter().map(|turn| Turn {
        along: turned_vector(sketch, function, arguments, turn.along),
        ..turn
    }));
    let title = match &inner.part {
        Some(part) => part.title.clone(),
        None => titles::title(sketch, inner.expr),
    };
    // What is turned along with a length is called after it only if nothing else is.
    let title = title.map(|title| Title {
        rank: title.rank
            + if moves_of(sketch, inner) == Moves::Not {
                CARRIED
            } else {
                0
            },
        ..title
    });
    let own = arguments[1..].iter().map(|own| sketch.moves(own)).max();
    Part {
        at,
        title,
        slide,
        moves: moves_of(sketch, inner).max(own.unwrap_or(Moves::Not)),
        turns,
    }
}

/// A vector turned as a call turns its first argument.
pub(super) fn turned_vector<'m>(
    sketch: &mut Sketch<'_, 'm>,
    function: Function,
    arguments: &'m [Expr],
    vector: Vn<'m>,
) -> Vn<'m> {
    let mut values = vec![Value::Vector(vector)];
    for own in &arguments[1..] {
        values.push(sketch.algebra.translate(own));
    }
    let value = calls::call(sketch.algebra, function, values);
    translate::vector(sketch.algebra, &value)
}

/// In space: what turns a term, from outside to inside.
pub(super) fn turns_of<'m>(sketch: &mut Sketch<'_, 'm>, term: &Term<'m>) -> Vec<Turn<'m>> {
    if let Some(part) = &term.part {
        return part.turns.clone();
    }
    match &term.expr.kind {
        ExprKind::Call(Function::Turn, arguments) if sketch.moves(&arguments[2]) != Moves::Not => {
            vec![Turn {
                along: sketch.vector(&arguments[1]),
                by: Some(&arguments[2]),
            }]
        }
        // What turns in the plane turns about z.
        ExprKind::Call(Function::Polar | Function::Rotate, arguments)
            if sketch.dimension == 3 && sketch.moves(&arguments[1]) != Moves::Not =>
        {
            vec![Turn {
                along: guides::axis_of(sketch, 2),
                by: Some(&arguments[1]),
            }]
        }
        // Nothing else turns about an axis of its own.
        _ => Vec::new(),
    }
}

pub(super) fn moves_of(sketch: &Sketch<'_, '_>, term: &Term) -> Moves {
    term.part
        .as_ref()
        .map_or_else(|| sketch.moves(term.expr), |part| part.moves)
}

/// The vector that a term adds, its sign aside.
pub(super) fn step_of<'m>(sketch: &mut Sketch<'_, 'm>, term: &Term<'m>) -> Vn<'m> {
    match &term.part {
        Some(part) => part.at,
        None => sketch.vector(term.expr),
    }
}

/// Remembers an axis through a point of space.
pub(super) fn axis<'m>(sketch: &mut Sketch<'_, 'm>, point: usize, along: Vn<'m>) {
    if let Some(along) = along.in_space() {
        let axis = (point, along.unit().into());
        if !sketch.axes.contains(&axis) {
            sketch.axes.push(axis);
        }
    }
}
