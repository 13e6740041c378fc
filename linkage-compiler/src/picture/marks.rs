//! Data of a sketch: points, segments, steps and their names.

use linkage_symbolic::{Ex, Vn};

use crate::diagnostic::OriginId;
use crate::model::Expr;
use crate::picture::point_or_vector::Moves;
use crate::picture::pose::Frames;

/// A point of a chain.
#[derive(Clone, Debug)]
pub(super) struct Spot<'m> {
    /// In the drawing.
    pub(super) at: Vn<'m>,
    /// The point as it is written, and the coordinates in which it is.
    pub(super) written: Vn<'m>,
    pub(super) frames: Frames,
    pub(super) name: Option<Title>,
    /// True if it is more than a corner on the way along a link: it has a name, a loop closes
    /// there, or the user lists it.
    pub(super) wanted: bool,
}

/// A name, and how good it is: the lowest rank wins, the first of equal ones.
#[derive(Clone, Debug)]
pub(super) struct Title {
    pub(super) rank: u8,
    pub(super) text: String,
}

/// A step from one point to another.
#[derive(Clone, Debug)]
pub(super) struct Segment<'m> {
    pub(super) from: usize,
    pub(super) to: usize,
    pub(super) title: Option<Title>,
    pub(super) shape: Shape<'m>,
    /// The vector from one to the other, as it is written.
    pub(super) step: Vn<'m>,
    /// The coordinates in which it is written.
    pub(super) frames: Frames,
    /// True for a step of a derived quantity that no loop uses.
    pub(super) is_aside: bool,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Shape<'m> {
    /// A term of a sum with its sign: if it is no link, it may be a slide.
    Term(f64, &'m Expr),
    /// A part of a term.
    Part(f64, Option<Slide<'m>>),
    /// A distance: if it is no link, its ends slide along each other.
    Distance,
    /// Two points of a body, of which declarations have numbers.
    Body(Option<usize>),
    /// The step from the origin of an unknown frame, by its derived quantity, to a point of it.
    Frame(usize),
    /// The step from the origin of moving coordinates to a point that rests in them: the carrier of
    /// a part, which belongs to a part itself.
    Base(Option<usize>),
}

/// A point that is computed from others, by a mean or in a frame: it may belong to their link.
#[derive(Clone, Debug)]
pub(super) struct Mean {
    pub(super) point: usize,
    pub(super) sources: Vec<usize>,
}

/// A point that stays on a line.
#[derive(Clone, Debug)]
pub(super) struct Line<'m> {
    pub(super) slider: usize,
    /// A point of the line's carrier; `None` is the frame.
    pub(super) carrier: Option<usize>,
    /// The vector from that point to the line, if known.
    pub(super) foot: Option<Vn<'m>>,
    pub(super) along: Vn<'m>,
    pub(super) name: String,
}

/// A curved slot.
#[derive(Clone, Debug)]
pub(super) struct Arc<'m> {
    pub(super) name: String,
    /// The point in the slot.
    pub(super) slider: usize,
    pub(super) centre: usize,
    /// A unit vector that turns with the carrier.
    pub(super) direction: Vn<'m>,
}

/// A straight slot that the text has.
#[derive(Clone, Debug)]
pub(super) struct Slot<'m> {
    pub(super) name: String,
    /// The point in the slot.
    pub(super) slider: usize,
    /// A point of its line on the carrier.
    pub(super) start: usize,
    /// A unit vector that turns with the carrier.
    pub(super) direction: Vn<'m>,
}

/// A list in `picture([p, q])`.
#[derive(Clone, Debug)]
pub(super) struct Asked {
    pub(super) points: Vec<usize>,
    pub(super) origin: OriginId,
}

/// A link that the text has by its name.
#[derive(Clone, Debug)]
pub(super) struct NamedLink {
    pub(super) name: String,
    pub(super) points: Vec<usize>,
}

/// Two wheels that turn each other by the text.
#[derive(Clone, Debug)]
pub(super) struct WheelPair<'m> {
    pub(super) centres: [usize; 2],
    /// Unit vectors that turn with the wheels; `None` for one that is fixed.
    pub(super) directions: [Option<Vn<'m>>; 2],
    /// True for gears, false for a belt.
    pub(super) touch: bool,
}

/// A term of a sum.
pub(super) struct Term<'m> {
    pub(super) sign: f64,
    pub(super) expr: &'m Expr,
    /// The name that it goes by.
    pub(super) name: Option<String>,
    /// The part of the expression, unless the term is all of it.
    pub(super) part: Option<StepPart<'m>>,
}

impl<'m> Spot<'m> {
    /// The vector to another point: as it is written, where both are written in the same
    /// coordinates.
    pub(super) fn step_to(&self, other: &Self) -> Vn<'m> {
        if self.frames == other.frames {
            other.written - self.written
        } else {
            other.at - self.at
        }
    }
}

/// A step within a term.
#[derive(Clone, Debug)]
pub(super) struct StepPart<'m> {
    pub(super) at: Vn<'m>,
    pub(super) title: Option<Title>,
    /// Along which it changes, if its length does.
    pub(super) slide: Option<Slide<'m>>,
    pub(super) moves: Moves,
    /// In space, from outside to inside.
    pub(super) turns: Vec<Turn<'m>>,
}

/// A rotation of a step in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Turn<'m> {
    pub(super) along: Vn<'m>,
    /// The angle, where it is written.
    pub(super) by: Option<&'m Expr>,
}

/// A change of a step's length.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slide<'m> {
    /// The part of the step across that direction.
    pub(super) offset: Option<Vn<'m>>,
    /// A unit vector.
    pub(super) along: Vn<'m>,
    /// The input that is its length, or in it.
    pub(super) input: Option<usize>,
}

/// `dot(p - q, n) = d` in space: `p` stays on a plane.
#[derive(Clone, Debug)]
pub(super) struct Plane<'m> {
    pub(super) difference: Vn<'m>,
    /// The coordinates in which both are written.
    pub(super) frames: Frames,
    pub(super) normal: Vn<'m>,
    /// `d`.
    pub(super) offset: Ex<'m>,
    pub(super) is_used: bool,
}
