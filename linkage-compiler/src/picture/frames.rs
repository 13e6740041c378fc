//! Parts of a machine that stand elsewhere: where the coordinates that they are written in are in the drawing.

use crate::algebra::calls;
use crate::algebra::translate;
use linkage_symbolic::{Ex, NodeId, Vector, Vn};

use crate::algebra::{Algebra, Translate, Value};
use crate::model::{Expr, Function, Name, Placed};

use super::chains::Sketch;
use super::marks::Shape;
use super::point_or_vector::{Moves, Roles};

/// Coordinates within others, by their numbers among the placed parts, the innermost first; none are the drawing's.
pub(super) type Frames = Vec<usize>;

/// Where a placed part stands in what is around it.
#[derive(Clone, Debug)]
pub(super) struct Pose<'m> {
    place: Option<Place<'m>>,
    turned: Option<Value<'m>>,
    moves: Moves,
}

#[derive(Clone, Debug)]
enum Place<'m> {
    Point(Vn<'m>),
    /// Of space: its value, and its axes.
    Frame(Value<'m>, [Vn<'m>; 3]),
}

impl<'m> Pose<'m> {
    pub(super) fn of(placed: &Placed, algebra: &mut Algebra<'m>, roles: &Roles) -> Self {
        let both = placed.at.iter().chain(&placed.turned);
        let moves = both.map(|own| roles.moves(own)).max();
        let place = placed.at.as_ref().map(|at| match algebra.translate(at) {
            Value::Array(parts) => {
                let axes = [1, 2, 3].map(|axis| translate::vector(algebra, &parts[axis]));
                Place::Frame(Value::Array(parts), axes)
            }
            value => Place::Point(translate::vector(algebra, &value)),
        });
        Self {
            place,
            turned: placed.turned.as_ref().map(|own| algebra.translate(own)),
            moves: moves.unwrap_or(Moves::Not),
        }
    }

    fn point(&self, own: Vn<'m>, algebra: &mut Algebra<'m>) -> Vn<'m> {
        match &self.place {
            None => self.way(own, algebra),
            Some(Place::Point(at)) => at.resized(own.len()) + self.way(own, algebra),
            Some(Place::Frame(frame, _)) => {
                let seen = calls::call(algebra, Function::PointIn, vec![frame.clone(), own.into()]);
                translate::vector(algebra, &seen)
            }
        }
    }

    /// A step or a direction.
    fn way(&self, own: Vn<'m>, algebra: &mut Algebra<'m>) -> Vn<'m> {
        match (&self.turned, &self.place) {
            (Some(angle), _) => {
                let turned =
                    calls::call(algebra, Function::Rotate, vec![own.into(), angle.clone()]);
                let turned = translate::vector(algebra, &turned);
                // In a picture of space it turns about z.
                let third = own.iter().skip(2);
                let components: Vec<NodeId> = turned.iter().chain(third).map(Ex::id).collect();
                algebra.graph.components(&components)
            }
            (None, Some(Place::Frame(_, axes))) => {
                let component = |k: usize| {
                    let axes = axes.map(|axis| axis.at(k));
                    own.dot(Vector(axes).into()).id()
                };
                algebra.graph.components(&[0, 1, 2].map(component))
            }
            (None, _) => own,
        }
    }
}

/// Looks at something that is written in other coordinates.
pub(super) fn within<'m, T>(
    sketch: &mut Sketch<'_, 'm>,
    frames: Frames,
    look: impl FnOnce(&mut Sketch<'_, 'm>) -> T,
) -> T {
    let before = std::mem::replace(&mut sketch.frames, frames);
    let found = look(sketch);
    sketch.frames = before;
    found
}

/// A point of a part that stands elsewhere, the coordinates that it is written in, and how.
pub(super) fn elsewhere<'m>(sketch: &Sketch<'_, 'm>, expr: &'m Expr) -> Option<(Frames, &'m Expr)> {
    let (index, own) = sketch.algebra.mechanism.standing(expr)?;
    Some((frames_from(sketch, index), own))
}

/// The coordinates of a placed part, and those around it.
fn frames_from(sketch: &Sketch<'_, '_>, index: usize) -> Frames {
    let path = &sketch.algebra.mechanism.placed[index].path;
    frames_around(sketch, |own| path == &own.path || is_in(path, own))
}

/// The coordinates that a name is written in. Where a part stands is written around it.
pub(super) fn frames_of(sketch: &Sketch<'_, '_>, name: Name) -> Frames {
    let text = sketch.algebra.mechanism.name(name);
    let places = |placed: &Placed| {
        let mut both = placed.at.iter().chain(&placed.turned);
        both.any(|own| own.as_name() == Some(name))
    };
    frames_around(sketch, |own| is_in(text, own) && !places(own))
}

pub(super) fn frames_of_loop(sketch: &Sketch<'_, '_>, index: usize) -> Frames {
    frames_around(sketch, |own| own.loops.contains(&index))
}

fn frames_around(sketch: &Sketch<'_, '_>, has: impl Fn(&Placed) -> bool) -> Frames {
    let placed = &sketch.algebra.mechanism.placed;
    let mut frames: Frames = (0..placed.len()).filter(|&own| has(&placed[own])).collect();
    frames.sort_by_key(|&own| std::cmp::Reverse(placed[own].path.len()));
    frames
}

/// Where a point of the present coordinates is in the drawing.
pub(super) fn seen_point<'m>(sketch: &mut Sketch<'_, 'm>, own: Vn<'m>) -> Vn<'m> {
    let poses = sketch.frames.iter().map(|&frame| &sketch.poses[frame]);
    poses.fold(own, |own, pose| pose.point(own, sketch.algebra))
}

/// Where a step or a direction of the present coordinates leads in the drawing.
pub(super) fn seen_way<'m>(sketch: &mut Sketch<'_, 'm>, own: Vn<'m>) -> Vn<'m> {
    let poses = sketch.frames.iter().map(|&frame| &sketch.poses[frame]);
    poses.fold(own, |own, pose| pose.way(own, sketch.algebra))
}

/// What does not move in coordinates that do is a point of what carries them.
pub(super) fn carried(sketch: &mut Sketch<'_, '_>, point: usize) {
    let moves = |&frame: &usize| sketch.poses[frame].moves != Moves::Not;
    let Some(moving) = sketch.frames.iter().position(moves) else {
        return;
    };
    let around = sketch.frames[moving..].to_vec();
    let origin = within(sketch, around, |sketch| {
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

/// Whether a name is that of something in a placed part.
fn is_in(name: &str, placed: &Placed) -> bool {
    let rest = name.strip_prefix(&placed.path);
    rest.is_some_and(|rest| rest.starts_with('.'))
}
