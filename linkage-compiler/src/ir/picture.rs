//! What is drawn.

pub use linkage_core::{Drive, DriveOn, Gear, GuideOn, GuideShape, JointShape, PointKind};

/// What the vectors of the quantity `picture()` are: points first, then directions.
#[derive(Clone, Debug, Default)]
pub struct Picture {
    /// 2 in the plane, 3 in space.
    pub dimension: usize,
    /// In the order of the quantity's vectors.
    pub points: Vec<Point>,
    /// Names of unit vectors, which follow the points.
    pub directions: Vec<String>,
    /// Points that keep their distances.
    pub links: Vec<Link>,
    /// Lines along which points slide.
    pub guides: Vec<Guide>,
    /// In space: points and directions of axes.
    pub axes: Vec<(usize, usize)>,
    /// Where links meet, in the order of their points.
    pub joints: Vec<Joint>,
    /// Wheels whose angles belong together.
    pub gears: Vec<Gear>,
    /// What inputs move.
    pub drives: Vec<Drive>,
    /// Loops that are not drawn, by number from 1.
    pub undrawn: Vec<usize>,
    /// What of all this each part of a machine has.
    pub parts: Vec<Part>,
}

/// What a part of a machine has of its picture, by index.
#[derive(Clone, Debug)]
pub struct Part {
    /// From the program.
    pub name: String,
    /// Those in which parts meet belong to all of them.
    pub points: Vec<usize>,
    /// Links.
    pub links: Vec<usize>,
    /// Guides.
    pub guides: Vec<usize>,
}

/// What meets in a point, and how it moves against each other.
#[derive(Clone, Debug)]
pub struct Joint {
    /// By index.
    pub point: usize,
    /// How its members move.
    pub shape: JointShape,
    /// At least two.
    pub between: Vec<Member>,
}

/// What a joint joins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Member {
    /// What does not move.
    Frame,
    /// A link, by index.
    Link(usize),
    /// A guide that is a link of its own, by index: a slotted lever, the barrel of a cylinder.
    Rail(usize),
    /// A block that slides on a guide, by index.
    Block(usize),
    /// The piston rod of a cylinder, by the index of the guide.
    Rod(usize),
}

/// A point that is drawn.
#[derive(Clone, Debug)]
pub struct Point {
    /// From the program, or after the links that meet in it.
    pub name: String,
    /// What it is in the drawing.
    pub kind: PointKind,
}

/// A rigid link.
#[derive(Clone, Debug)]
pub struct Link {
    /// From the program, or after its points.
    pub name: String,
    /// By index.
    pub points: Vec<usize>,
}

/// A line along which a point slides.
#[derive(Clone, Debug)]
pub struct Guide {
    /// Of the slide.
    pub name: String,
    /// A point of the line, by index.
    pub origin: usize,
    /// Its direction, by index.
    pub direction: usize,
    /// The point that slides, by index.
    pub slider: usize,
    /// What carries it.
    pub on: GuideOn,
    /// What it looks like.
    pub shape: GuideShape,
}

impl Picture {
    /// How many vectors the quantity consists of.
    pub fn vectors(&self) -> usize {
        self.points.len() + self.directions.len()
    }

    /// Their names, in the same order.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        let points = self.points.iter().map(|point| &point.name[..]);
        points.chain(self.directions.iter().map(String::as_str))
    }
}
