//! The coordinates in which names, loops and placed parts are written.

use crate::model::{Expr, Name, Placed};
use crate::picture::marks::Shape;
use crate::picture::point_or_vector::Moves;
use crate::picture::pose::Frames;
use crate::picture::sketch::{self, Sketch};

/// A point of a part that stands elsewhere, the coordinates that it is written in, and how.
pub(super) fn elsewhere<'m>(sketch: &Sketch<'_, 'm>, expr: &'m Expr) -> Option<(Frames, &'m Expr)> {
    let (index, inner) = sketch.algebra.mechanism.standing(expr)?;
    Some((frames_from(sketch, index), inner))
}

/// The coordinates of a placed part, and those around it.
fn frames_from(sketch: &Sketch<'_, '_>, index: usize) -> Frames {
    let path = &sketch.algebra.mechanism.placed[index].path;
    frames_around(sketch, |placed| path == &placed.path || is_in(path, placed))
}

/// The coordinates that a name is written in. Where a part stands is written around it.
pub(super) fn frames_of(sketch: &Sketch<'_, '_>, name: Name) -> Frames {
    let text = sketch.algebra.mechanism.name(name);
    let places = |placed: &Placed| {
        let mut both = placed.at.iter().chain(&placed.turned);
        both.any(|expr| expr.as_name() == Some(name))
    };
    frames_around(sketch, |placed| is_in(text, placed) && !places(placed))
}

pub(super) fn frames_of_loop(sketch: &Sketch<'_, '_>, index: usize) -> Frames {
    frames_around(sketch, |placed| placed.loops.contains(&index))
}

fn frames_around(sketch: &Sketch<'_, '_>, has: impl Fn(&Placed) -> bool) -> Frames {
    let placed = &sketch.algebra.mechanism.placed;
    let mut frames: Frames = (0..placed.len())
        .filter(|&index| has(&placed[index]))
        .collect();
    frames.sort_by_key(|&index| std::cmp::Reverse(placed[index].path.len()));
    frames
}

/// Draws a point that rests in moving coordinates as a point of their carrier.
pub(super) fn carried(sketch: &mut Sketch<'_, '_>, point: usize) {
    let moves = |&frame: &usize| sketch.poses[frame].moves != Moves::Not;
    let Some(moving) = sketch.frames.iter().position(moves) else {
        return;
    };
    let around = sketch.frames[moving..].to_vec();
    let origin = sketch::within(sketch, around, |sketch| {
        let zero = sketch.algebra.graph.zeros(sketch.dimension);
        sketch.point(zero)
    });
    // The part that the moving one is a part of, if it is one itself.
    let mechanism = sketch.algebra.mechanism;
    let path = &mechanism.placed[sketch.frames[moving]].path;
    let mut parts = mechanism.parts.iter();
    let carrier = parts.position(|part| {
        let rest = path.strip_prefix(&part.name);
        rest.is_some_and(|rest| rest.starts_with('.'))
    });
    sketch.segment(origin, point, None, Shape::Base(carrier));
}

/// True if a name is that of something in a placed part.
fn is_in(name: &str, placed: &Placed) -> bool {
    let rest = name.strip_prefix(&placed.path);
    rest.is_some_and(|rest| rest.starts_with('.'))
}
