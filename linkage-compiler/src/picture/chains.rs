//! Sums of vectors as chains: from a point, each term is a step to the next.

use linkage_symbolic::Vn;

use crate::algebra::Algebra;
use crate::model::{Expr, ExprKind, Function, Mechanism, Name, Type};
use crate::picture::layout::Layout;
use crate::picture::marks::{Mean, Segment, Shape, Spot, Term, Title, Turn};
use crate::picture::point_or_vector::Moves;
use crate::picture::sketch::Sketch;
use crate::picture::statement::{ASIDE, Statement};
use crate::picture::terms::MANY_TERMS;
use crate::picture::{expressions, frames, layout, parts, sketch, terms, titles, weights};

pub(super) fn point_of<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    sketch: &mut Sketch<'m>,
    statement: Statement<'_>,
    expr: &'m Expr,
) -> Option<usize> {
    if !is_vector(algebra.mechanism, layout.dimension, expr) {
        return None;
    }
    let terms = terms::terms_of(algebra, layout, statement.remoteness, expr);
    chain(algebra, layout, sketch, statement, terms)
}

pub(super) fn chain<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    sketch: &mut Sketch<'m>,
    statement: Statement<'_>,
    mut terms: Vec<Term<'m>>,
) -> Option<usize> {
    let total: f64 = terms
        .iter()
        .map(|term| weights::weight_of(algebra.mechanism, &layout.roles, term))
        .sum();
    let is_weighted =
        |term: &Term| weights::weight_of(algebra.mechanism, &layout.roles, term) != 0.0;
    let weighted: Vec<usize> = (0..terms.len())
        .filter(|&k| is_weighted(&terms[k]))
        .collect();
    let start = match weighted[..] {
        _ if terms.len() > MANY_TERMS => return None,
        [] => fixed_start(algebra, layout, sketch, statement.frames, &mut terms),
        [one] if total == 1.0 => {
            let term = terms.remove(one);
            start(algebra, layout, sketch, statement, term.expr)
        }
        // A mean of points is a point without a chain.
        _ if total == 1.0 => {
            return Some(sum(
                algebra,
                layout,
                &mut sketch.points,
                statement.frames,
                &terms,
            ));
        }
        _ => return None,
    };
    Some(terms.into_iter().fold(start, |from, term| {
        step(algebra, layout, sketch, statement, from, term)
    }))
}

fn fixed_start<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    sketch: &mut Sketch<'m>,
    frames: &[usize],
    terms: &mut Vec<Term<'m>>,
) -> usize {
    let (moving, fixed): (Vec<_>, Vec<_>) = std::mem::take(terms)
        .into_iter()
        .partition(|term| parts::moves_of(&layout.roles, term) != Moves::Not);
    *terms = moving;
    let point = sum(algebra, layout, &mut sketch.points, frames, &fixed);
    if let [term] = &fixed[..]
        && term.sign > 0.0
        && term.part.is_none()
        && let ExprKind::Name(Name::Parameter(_) | Name::Const(_)) = term.expr.kind
    {
        titles::name(algebra.mechanism, &mut sketch.points[point], 2, term.expr);
    }
    frames::carried(algebra, layout, sketch, frames, point);
    point
}

fn sum<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    points: &mut Vec<Spot<'m>>,
    frames: &[usize],
    terms: &[Term<'m>],
) -> usize {
    let start = algebra.graph.zeros(layout.dimension);
    let sum = terms.iter().fold(start, |sum, term| {
        let step = parts::step_of(algebra, layout.dimension, term);
        moved(sum, step, term.sign)
    });
    sketch::point(algebra, layout, points, frames, sum)
}

fn step<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    sketch: &mut Sketch<'m>,
    statement: Statement<'_>,
    from: usize,
    term: Term<'m>,
) -> usize {
    let step = parts::step_of(algebra, layout.dimension, &term);
    let (way, start) = (
        layout.seen_way(algebra, statement.frames, step),
        &sketch.points[from],
    );
    let at = moved(start.at, way, term.sign);
    let written = moved(start.written, step, term.sign);
    let to = sketch::spot(&mut sketch.points, statement.frames, at, written);
    for turn in parts::turns_of(algebra, layout, &term) {
        let along = layout.seen_way(algebra, statement.frames, turn.along);
        let turn = Turn { along, ..turn };
        // What turns with the step before does not turn against it.
        if !sketch.turns.contains(&(from, turn)) {
            parts::axis(&mut sketch.axes, from, turn.along);
        }
        sketch.turns.push((to, turn));
    }
    let text = |rank: u8| move |text| Title { rank, text };
    let (title, shape) = match (term.name, term.part) {
        (Some(name), None) => (
            Some(text(1 + statement.remoteness)(name)),
            Shape::Term(term.sign, term.expr),
        ),
        (None, None) => (
            titles::title(algebra.mechanism, statement.remoteness, term.expr),
            Shape::Term(term.sign, term.expr),
        ),
        (name, Some(part)) => {
            let named = name.map(text(1 + statement.remoteness));
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
            frames: statement.frames.to_vec(),
            is_aside: statement.remoteness == ASIDE,
        });
    }
    to
}

fn is_vector(mechanism: &Mechanism, dimension: usize, expr: &Expr) -> bool {
    match &expr.ty {
        Type::Vector(count, unit) => {
            let is_flat = (*count, dimension) == (2, 3);
            let is_drawn =
                *count == dimension || is_flat && !expressions::is_projection(mechanism, expr);
            is_drawn && unit.half_lengths == 2
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
pub(super) fn start<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    sketch: &mut Sketch<'m>,
    statement: Statement<'_>,
    expr: &'m Expr,
) -> usize {
    if let Some((frames, inner)) = frames::elsewhere(algebra.mechanism, expr)
        && let Some(point) = point_of(algebra, layout, sketch, statement.within(&frames), inner)
    {
        return point;
    }
    let at = layout::vector(algebra, layout.dimension, expr);
    let point = sketch::point(algebra, layout, &mut sketch.points, statement.frames, at);
    if let ExprKind::Call(Function::PointIn, arguments) = &expr.kind
        && let Some((origin, first)) = frame_of(algebra, layout, sketch, statement, &arguments[0])
    {
        match expressions::unknown_frame(algebra.mechanism, &arguments[0]) {
            Some((index, text)) => {
                let title = Some(Title { rank: 1, text });
                sketch.segment(
                    statement.frames,
                    [origin, point],
                    title,
                    Shape::Frame(index),
                );
            }
            None => sketch.segment(statement.frames, [origin, point], None, Shape::Body(None)),
        }
        // An axis of the frame may be the line from one point of a link to another one.
        let ends = expressions::difference(algebra.mechanism, first).map(|(to, from)| [from, to]);
        let ends = ends.and_then(|ends| {
            let [from, to] = ends.map(|end| point_of(algebra, layout, sketch, statement, end));
            Some(vec![from?, to?])
        });
        sketch
            .means
            .extend(ends.map(|sources| Mean { point, sources }));
    }
    if let ExprKind::Binary(..) = expr.kind {
        let points = expressions::points_in(algebra.mechanism, &layout.roles, expr)
            .into_iter()
            .map(|point| {
                let at = layout::vector(algebra, layout.dimension, point);
                sketch::point(algebra, layout, &mut sketch.points, statement.frames, at)
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
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    sketch: &mut Sketch<'m>,
    statement: Statement<'_>,
    frame: &'m Expr,
) -> Option<(usize, &'m Expr)> {
    let mechanism = algebra.mechanism;
    match &frame.kind {
        ExprKind::Name(name) => frame_of(
            algebra,
            layout,
            sketch,
            statement,
            mechanism.value_of(*name)?,
        ),
        ExprKind::Call(Function::Frame, arguments) => Some((
            point_of(algebra, layout, sketch, statement, &arguments[0])?,
            &arguments[1],
        )),
        // Nothing else is a frame.
        _ => None,
    }
}
