//! Sums of vectors as chains: from a point, each term is a step to the next.

use linkage_symbolic::Vn;

use crate::model::{Expr, ExprKind, Function, Name, Type};
use crate::picture::marks::{Mean, Segment, Shape, Term, Title, Turn};
use crate::picture::point_or_vector::Moves;
use crate::picture::sketch::Sketch;
use crate::picture::terms::MANY_TERMS;
use crate::picture::{expressions, frames, parts, sketch, terms, titles, weights};

pub(super) fn point_of<'m>(sketch: &mut Sketch<'_, 'm>, expr: &'m Expr) -> Option<usize> {
    if !is_vector(sketch, expr) {
        return None;
    }
    let mut terms = Vec::new();
    terms::collect_terms(sketch, expr, 1.0, None, &mut terms);
    chain(sketch, terms)
}

pub(super) fn chain<'m>(sketch: &mut Sketch<'_, 'm>, mut terms: Vec<Term<'m>>) -> Option<usize> {
    let total: f64 = terms
        .iter()
        .map(|term| weights::weight_of(sketch, term))
        .sum();
    let is_weighted = |term: &Term| weights::weight_of(sketch, term) != 0.0;
    let weighted: Vec<usize> = (0..terms.len())
        .filter(|&k| is_weighted(&terms[k]))
        .collect();
    let start = match weighted[..] {
        _ if terms.len() > MANY_TERMS => return None,
        [] => fixed_start(sketch, &mut terms),
        [one] if total == 1.0 => {
            let term = terms.remove(one);
            start(sketch, term.expr)
        }
        // A mean of points is a point without a chain.
        _ if total == 1.0 => return Some(sum(sketch, &terms)),
        _ => return None,
    };
    Some(
        terms
            .into_iter()
            .fold(start, |from, term| step(sketch, from, term)),
    )
}

fn fixed_start<'m>(sketch: &mut Sketch<'_, 'm>, terms: &mut Vec<Term<'m>>) -> usize {
    let (moving, fixed): (Vec<_>, Vec<_>) = std::mem::take(terms)
        .into_iter()
        .partition(|term| parts::moves_of(sketch, term) != Moves::Not);
    *terms = moving;
    let point = sum(sketch, &fixed);
    if let [term] = &fixed[..]
        && term.sign > 0.0
        && term.part.is_none()
        && let ExprKind::Name(Name::Parameter(_) | Name::Const(_)) = term.expr.kind
    {
        titles::name(sketch, point, 2, term.expr);
    }
    frames::carried(sketch, point);
    point
}

fn sum<'m>(sketch: &mut Sketch<'_, 'm>, terms: &[Term<'m>]) -> usize {
    let start = sketch.algebra.graph.zeros(sketch.dimension);
    let sum = terms.iter().fold(start, |sum, term| {
        let step = parts::step_of(sketch, term);
        moved(sum, step, term.sign)
    });
    sketch.point(sum)
}

fn step<'m>(sketch: &mut Sketch<'_, 'm>, from: usize, term: Term<'m>) -> usize {
    let step = parts::step_of(sketch, &term);
    let (way, start) = (sketch::seen_way(sketch, step), &sketch.points[from]);
    let to = sketch.spot(
        moved(start.at, way, term.sign),
        moved(start.written, step, term.sign),
    );
    for turn in parts::turns_of(sketch, &term) {
        let along = sketch::seen_way(sketch, turn.along);
        let turn = Turn { along, ..turn };
        // What turns with the step before does not turn against it.
        if !sketch.turns.contains(&(from, turn)) {
            parts::axis(sketch, from, turn.along);
        }
        sketch.turns.push((to, turn));
    }
    let text = |rank: u8| move |text| Title { rank, text };
    let (title, shape) = match (term.name, term.part) {
        (Some(name), None) => (
            Some(text(1 + sketch.remoteness)(name)),
            Shape::Term(term.sign, term.expr),
        ),
        (None, None) => (
            titles::title(sketch, term.expr),
            Shape::Term(term.sign, term.expr),
        ),
        (name, Some(part)) => {
            let named = name.map(text(1 + sketch.remoteness));
            let title = named.or(part.title);
            (title, Shape::Part(term.sign, part.slide))
        }
    };
    if from != to {
        sketch.segments.push(Segment {
            from,
            to,
            title,
            shape,
            step,
            frames: sketch.frames.clone(),
        });
    }
    to
}

fn is_vector<'m>(sketch: &Sketch<'_, 'm>, expr: &Expr) -> bool {
    match &expr.ty {
        Type::Vector(count, dimension) => {
            let is_flat = (*count, sketch.dimension) == (2, 3);
            let is_drawn = *count == sketch.dimension
                || is_flat && !expressions::is_projection(sketch.algebra.mechanism, expr);
            is_drawn && dimension.half_lengths == 2
        }
        Type::Zero(_) => true,
        Type::Scalar(_) | Type::Array(_) | Type::Frame | Type::PlaneFrame | Type::Error => false,
    }
}

/// The end of a step.
fn moved<'m>(from: Vn<'m>, step: Vn<'m>, sign: f64) -> Vn<'m> {
    if sign > 0.0 { from + step } else { from - step }
}

/// A term that is a point.
pub(super) fn start<'m>(sketch: &mut Sketch<'_, 'm>, expr: &'m Expr) -> usize {
    if let Some((frames, inner)) = frames::elsewhere(sketch, expr)
        && let Some(point) = sketch::within(sketch, frames, |sketch| point_of(sketch, inner))
    {
        return point;
    }
    let at = sketch.vector(expr);
    let point = sketch.point(at);
    if let ExprKind::Call(Function::PointIn, arguments) = &expr.kind
        && let Some((origin, first)) = frame_of(sketch, &arguments[0])
    {
        match expressions::unknown_frame(sketch.algebra.mechanism, &arguments[0]) {
            Some((index, text)) => {
                let title = Some(Title { rank: 1, text });
                sketch.segment(origin, point, title, Shape::Frame(index));
            }
            None => sketch.segment(origin, point, None, Shape::Body(None)),
        }
        // An axis of the frame may be the line from one point of a link to another one.
        let ends =
            expressions::difference(sketch.algebra.mechanism, first).map(|(to, from)| [from, to]);
        let ends = ends.and_then(|ends| {
            let [from, to] = ends.map(|end| point_of(sketch, end));
            Some(vec![from?, to?])
        });
        sketch
            .means
            .extend(ends.map(|sources| Mean { point, sources }));
    }
    if let ExprKind::Binary(..) = expr.kind {
        let points = expressions::points_in(sketch, expr)
            .into_iter()
            .map(|point| {
                let at = sketch.vector(point);
                sketch.point(at)
            });
        let points = points.collect();
        sketch.means.push(Mean {
            point,
            sources: points,
        });
    }
    point
}

/// The point that a frame has its origin in, and the vector along its first axis.
pub(super) fn frame_of<'m>(
    sketch: &mut Sketch<'_, 'm>,
    frame: &'m Expr,
) -> Option<(usize, &'m Expr)> {
    let mechanism = sketch.algebra.mechanism;
    match &frame.kind {
        ExprKind::Name(name) => frame_of(sketch, mechanism.value_of(*name)?),
        ExprKind::Call(Function::Frame, arguments) => {
            Some((point_of(sketch, &arguments[0])?, &arguments[1]))
        }
        // Nothing else is a frame.
        _ => None,
    }
}
