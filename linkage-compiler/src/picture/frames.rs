//! The coordinates in which names, loops and placed parts are written.

use crate::algebra::Algebra;
use crate::model::{Expr, Mechanism, Name, Placed};
use crate::picture::layout::Layout;
use crate::picture::marks::Shape;
use crate::picture::point_or_vector::Moves;
use crate::picture::pose::Frames;
use crate::picture::sketch::{self, Sketch};

/// A point of a part that stands elsewhere, the coordinates that it is written in, and how.
pub(super) fn elsewhere<'m>(
    mechanism: &'m Mechanism,
    expr: &'m Expr,
) -> Option<(Frames, &'m Expr)> {
    let (index, inner) = mechanism.standing(expr)?;
    Some((frames_from(mechanism, index), inner))
}

/// The coordinates of a placed part, and those around it.
fn frames_from(mechanism: &Mechanism, index: usize) -> Frames {
    let path = &mechanism.placed[index].path;
    frames_around(mechanism, |placed| {
        path == &placed.path || is_in(path, placed)
    })
}

/// The coordinates that a name is written in. Where a part stands is written around it.
pub(super) fn frames_of(mechanism: &Mechanism, name: Name) -> Frames {
    let text = mechanism.name(name);
    let places = |placed: &Placed| {
        let mut both = placed.at.iter().chain(&placed.turned);
        both.any(|expr| expr.as_name() == Some(name))
    };
    frames_around(mechanism, |placed| is_in(text, placed) && !places(placed))
}

pub(super) fn frames_of_loop(mechanism: &Mechanism, index: usize) -> Frames {
    frames_around(mechanism, |placed| placed.loops.contains(&index))
}

fn frames_around(mechanism: &Mechanism, has: impl Fn(&Placed) -> bool) -> Frames {
    let placed = &mechanism.placed;
    let mut frames: Frames = (0..placed.len())
        .filter(|&index| has(&placed[index]))
        .collect();
    frames.sort_by_key(|&index| std::cmp::Reverse(placed[index].path.len()));
    frames
}

/// Draws a point that rests in moving coordinates as a point of their carrier.
pub(super) fn carried<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    sketch: &mut Sketch<'m>,
    frames: &[usize],
    point: usize,
) {
    let moves = |&frame: &usize| layout.poses[frame].moves != Moves::Not;
    let Some(moving) = frames.iter().position(moves) else {
        return;
    };
    let zero = algebra.graph.zeros(layout.dimension);
    let origin = sketch::point(algebra, layout, &mut sketch.points, &frames[moving..], zero);
    // The part that the moving one is a part of, if it is one itself.
    let mechanism = algebra.mechanism;
    let path = &mechanism.placed[frames[moving]].path;
    let mut parts = mechanism.parts.iter();
    let carrier = parts.position(|part| {
        let rest = path.strip_prefix(&part.name);
        rest.is_some_and(|rest| rest.starts_with('.'))
    });
    sketch.segment(frames, [origin, point], None, Shape::Base(carrier));
}

/// True if a name is that of something in a placed part.
fn is_in(name: &str, placed: &Placed) -> bool {
    let rest = name.strip_prefix(&placed.path);
    rest.is_some_and(|rest| rest.starts_with('.'))
}
