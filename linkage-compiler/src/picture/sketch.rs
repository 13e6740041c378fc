//! The sketch: points and the segments between them, as they are found.

use linkage_symbolic::Vn;

use crate::algebra::Algebra;
use crate::model::JointKind;
use crate::picture::layout::Layout;
use crate::picture::marks::{
    Arc, Asked, Line, Mean, NamedLink, Plane, Segment, Shape, Slot, Spot, Title, Turn, WheelPair,
};

/// Points and the segments between them, as they are found; several may be one and the same.
#[derive(Default)]
pub(super) struct Sketch<'m> {
    pub(super) points: Vec<Spot<'m>>,
    pub(super) segments: Vec<Segment<'m>>,
    pub(super) means: Vec<Mean>,
    /// Guides that are no terms of a chain.
    pub(super) lines: Vec<Line<'m>>,
    /// Curved slots.
    pub(super) arcs: Vec<Arc<'m>>,
    /// Straight slots that the text has.
    pub(super) slots: Vec<Slot<'m>>,
    /// In space: planes on which points stay, two of which are a guide.
    pub(super) planes: Vec<Plane<'m>>,
    /// In space: points and directions of axes.
    pub(super) axes: Vec<(usize, Vn<'m>)>,
    /// The rotations in space of the steps that end in points.
    pub(super) turns: Vec<(usize, Turn<'m>)>,
    /// Points at which the program has joints.
    pub(super) joints: Vec<(usize, JointKind)>,
    /// Those of them that have a name.
    pub(super) joint_names: Vec<(String, usize)>,
    /// Links that the user named, each by its points.
    pub(super) asked: Vec<Asked>,
    /// Links that the text has, each by its points.
    pub(super) named_links: Vec<NamedLink>,
    /// Wheels that the text has.
    pub(super) wheels: Vec<WheelPair<'m>>,
}

impl<'m> Sketch<'m> {
    /// Adds the segment between two points, unless they are one.
    pub(super) fn segment(
        &mut self,
        frames: &[usize],
        [from, to]: [usize; 2],
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
                frames: frames.to_vec(),
                is_aside: false,
            });
        }
    }
}

/// Returns the number of a point that is written in some coordinates, and adds it if it is new.
pub(super) fn point<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    points: &mut Vec<Spot<'m>>,
    frames: &[usize],
    written: Vn<'m>,
) -> usize {
    let at = layout.seen_point(algebra, frames, written);
    spot(points, frames, at, written)
}

/// Returns the number of a point whose position in the drawing is known.
pub(super) fn spot<'m>(
    points: &mut Vec<Spot<'m>>,
    frames: &[usize],
    at: Vn<'m>,
    written: Vn<'m>,
) -> usize {
    let known = points.iter().position(|point| point.at == at);
    known.unwrap_or_else(|| {
        points.push(Spot {
            at,
            written,
            frames: frames.to_vec(),
            name: None,
            wanted: false,
        });
        points.len() - 1
    })
}
