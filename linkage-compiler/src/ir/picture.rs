//! The elements of a drawing.

pub use linkage_core::{
    Drive, DriveOn, Gear, GuideOn, GuideShape, JointShape, PointKind, WheelContact, WheelTurn,
};

/// The vectors of the quantity `picture()`: points first, then directions.
#[derive(Clone, Debug, Default)]
pub struct Picture {
    /// 2 in the plane, 3 in space.
    pub dimension: usize,
    /// In the order of the quantity's vectors.
    pub points: Vec<Point>,
    /// Names of unit vectors, which follow the points.
    pub directions: Vec<String>,
    /// Points and directions at the reference inputs, by components.
    pub reference: Vec<Vec<f64>>,
    /// Points that keep their distances.
    pub links: Vec<Link>,
    /// Lines and arcs along which points slide.
    pub guides: Vec<Guide>,
    /// In space: points and directions of axes.
    pub axes: Vec<(usize, usize)>,
    /// The joints in which links meet, in the order of their points.
    pub joints: Vec<Joint>,
    /// The declared joints with a name, and their points.
    pub declared_joints: Vec<(String, usize)>,
    /// Wheels whose angles belong together.
    pub gears: Vec<Gear>,
    /// The elements that inputs move.
    pub drives: Vec<Drive>,
    /// Loops that are not drawn, by number from 1.
    pub undrawn: Vec<usize>,
    /// The elements of all these that each part of a machine has.
    pub parts: Vec<PicturePart>,
}

/// The elements that a part of a machine has of its picture, by index.
#[derive(Clone, Debug)]
pub struct PicturePart {
    /// The name from the program.
    pub name: String,
    /// Those in which parts meet belong to all of them.
    pub points: Vec<usize>,
    /// Links.
    pub links: Vec<usize>,
    /// Guides.
    pub guides: Vec<usize>,
}

/// The members that meet in a point, and their movement against each other.
#[derive(Clone, Debug)]
pub struct Joint {
    /// The index of the point.
    pub point: usize,
    /// The movement of its members.
    pub shape: JointShape,
    /// At least two.
    pub between: Vec<Member>,
}

/// A member that a joint joins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Member {
    /// The frame, which does not move.
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
    /// The name from the program, or after the links that meet in it.
    pub name: String,
    /// Its kind in the drawing.
    pub kind: PointKind,
}

/// A rigid link.
#[derive(Clone, Debug)]
pub struct Link {
    /// The name from the program, or after its points.
    pub name: String,
    /// The points by index.
    pub points: Vec<usize>,
}

/// A line or an arc along which a point slides.
#[derive(Clone, Debug)]
pub struct Guide {
    /// The name of the slide.
    pub name: String,
    /// A point of the line or the centre of the arc, by index.
    pub origin: usize,
    /// Its direction, or one that turns with the carrier of the arc, by index.
    pub direction: usize,
    /// The point that slides, by index.
    pub slider: usize,
    /// The member that carries it.
    pub on: GuideOn,
    /// Its shape in the drawing.
    pub shape: GuideShape,
}

impl Picture {
    /// Returns the number of vectors that the quantity consists of.
    pub fn vectors(&self) -> usize {
        self.points.len() + self.directions.len()
    }

    /// Their names, in the same order.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        let points = self.points.iter().map(|point| &point.name[..]);
        points.chain(self.directions.iter().map(String::as_str))
    }
}
