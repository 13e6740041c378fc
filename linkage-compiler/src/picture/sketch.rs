//! The sketch: points and the segments between them, as they are found.

use linkage_symbolic::Vn;
use linkage_symbolic::lookup::Set;

use crate::algebra::{Algebra, Translate, scalar};
use crate::model::{Expr, JointKind};
use crate::picture::marks::{Asked, Line, Mean, Plane, Segment, Shape, Spot, Title, Turn};
use crate::picture::point_or_vector::{Moves, Roles};
use crate::picture::pose::{Frames, Pose};

/// The unit vector along a coordinate axis.
pub(super) fn axis_of<'m>(sketch: &Sketch<'_, 'm>, component: usize) -> Vn<'m> {
    let graph = sketch.algebra.graph;
    let mut axis = vec![graph.zero(); sketch.dimension];
    axis[component] = graph.one();
    graph.components(&axis)
}

/// Points and the segments between them, as they are found; several may be one and the same.
pub(super) struct Sketch<'a, 'm> {
    pub(super) algebra: &'a mut Algebra<'m>,
    pub(super) roles: Roles<'m>,
    /// The positions of placed parts.
    pub(super) poses: Vec<Pose<'m>>,
    /// The coordinates of the current expression.
    pub(super) frames: Frames,
    pub(super) dimension: usize,
    pub(super) points: Vec<Spot<'m>>,
    pub(super) segments: Vec<Segment<'m>>,
    pub(super) means: Vec<Mean>,
    /// Guides that are no terms of a chain.
    pub(super) lines: Vec<Line<'m>>,
    /// In space: planes on which points stay, two of which are a guide.
    pub(super) planes: Vec<Plane<'m>>,
    /// In space: points and directions of axes.
    pub(super) axes: Vec<(usize, Vn<'m>)>,
    /// The rotations in space of the steps that end in points.
    pub(super) turns: Vec<(usize, Turn<'m>)>,
    /// Points at which the program has joints.
    pub(super) joints: Vec<(usize, JointKind)>,
    /// Links that the user named, each by its points.
    pub(super) asked: Vec<Asked>,
    /// Added to the ranks of names: those in loops are better.
    pub(super) remoteness: u8,
    /// Loops that are not drawn, by number from 1.
    pub(super) undrawn: Vec<usize>,
    /// Derived names in which rods have been looked for.
    pub(super) searched: Set<usize>,
}

impl<'a, 'm> Sketch<'a, 'm> {
    pub(super) fn new(algebra: &'a mut Algebra<'m>, dimension: usize) -> Self {
        let roles = Roles::new(algebra.mechanism);
        let placed = algebra.mechanism.placed.iter();
        Self {
            poses: placed
                .map(|placed| Pose::new(placed, algebra, &roles))
                .collect(),
            frames: Frames::new(),
            algebra,
            roles,
            dimension,
            points: Vec::new(),
            segments: Vec::new(),
            means: Vec::new(),
            lines: Vec::new(),
            planes: Vec::new(),
            axes: Vec::new(),
            turns: Vec::new(),
            joints: Vec::new(),
            undrawn: Vec::new(),
            asked: Vec::new(),
            remoteness: 0,
            searched: Set::new(),
        }
    }

    pub(super) fn moves(&self, expr: &Expr) -> Moves {
        self.roles.moves(expr)
    }

    pub(super) fn vector(&mut self, expr: &Expr) -> Vn<'m> {
        let value = self.algebra.translate(expr);
        scalar::vector(self.algebra, &value).resized(self.dimension)
    }

    pub(super) fn point(&mut self, written: Vn<'m>) -> usize {
        let at = seen_point(self, written);
        self.spot(at, written)
    }

    pub(super) fn spot(&mut self, at: Vn<'m>, written: Vn<'m>) -> usize {
        let known = self.points.iter().position(|point| point.at == at);
        known.unwrap_or_else(|| {
            self.points.push(Spot {
                at,
                written,
                frames: self.frames.clone(),
                name: None,
                wanted: false,
            });
            self.points.len() - 1
        })
    }

    pub(super) fn segment(
        &mut self,
        from: usize,
        to: usize,
        title: Option<Title>,
        shape: Shape<'m>,
    ) {
        if from != to {
            self.segments.push(Segment {
                from,
                to,
                title,
                shape,
                step: self.points[from].step_to(&self.points[to]),
                frames: self.frames.clone(),
            });
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

/// The position in the drawing of a point of the current coordinates.
pub(super) fn seen_point<'m>(sketch: &mut Sketch<'_, 'm>, written: Vn<'m>) -> Vn<'m> {
    let poses = sketch.frames.iter().map(|&frame| &sketch.poses[frame]);
    poses.fold(written, |point, pose| pose.point(point, sketch.algebra))
}

/// The vector in the drawing of a step or direction of the current coordinates.
pub(super) fn seen_way<'m>(sketch: &mut Sketch<'_, 'm>, written: Vn<'m>) -> Vn<'m> {
    let poses = sketch.frames.iter().map(|&frame| &sketch.poses[frame]);
    poses.fold(written, |step, pose| pose.way(step, sketch.algebra))
}
