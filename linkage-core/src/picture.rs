//! The picture of a mechanism: the points that its links join.

/// The skeleton of a mechanism, as the quantity `picture()` shows it: the constant `PICTURE` of a
/// mechanism one of whose functions asks for it.
///
/// The quantity is an array of vectors: first the points, in the order of [`points`](Self::points),
/// in the mechanism's length unit, then unit vectors, in the order of
/// [`directions`](Self::directions). All indices here are indices into these two lists.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Picture {
    /// 2 in the plane, 3 in space: the number of components.
    pub dimension: usize,
    /// The points.
    pub points: &'static [PicturePoint],
    /// Names of the unit vectors.
    pub directions: &'static [&'static str],
    /// The moving links, each with at least two points.
    pub links: &'static [PictureLink],
    /// Guides of sliding joints, straight ones and arcs.
    pub guides: &'static [Guide],
    /// In space: the axes about which something turns.
    pub axes: &'static [Axis],
    /// Points in which links meet, and how they move there.
    pub joints: &'static [PictureJoint],
    /// Wheels whose angles belong together.
    pub gears: &'static [Gear],
    /// Members that inputs drive.
    pub drives: &'static [Drive],
    /// Loops that are not drawn, by number from 1: it is not known where in space they lie.
    pub undrawn: &'static [usize],
    /// The parts of a machine, mechanisms within the drawn one: the share of each of them in the
    /// picture. Empty without parts.
    pub parts: &'static [PicturePart],
}

/// A point of the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PicturePoint {
    /// The name in the program; a point without a name is called after the links that it joins.
    pub name: &'static str,
    /// The kind of the point.
    pub kind: PointKind,
}

/// The kind of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PointKind {
    /// It does not move, and a link turns on it.
    Ground,
    /// It joins links.
    Joint,
    /// It belongs to one link, as the tip of a needle does.
    Tip,
    /// A moving point that no known link carries.
    Loose,
    /// It only says where a guide is, and is not drawn.
    Construction,
}

/// A rigid link.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PictureLink {
    /// Name of the length, the body or the angle that it was recognised by.
    pub name: &'static str,
    /// The points that it joins: two for a bar, more for a plate.
    pub points: &'static [usize],
}

/// A guide and the member that slides along it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Guide {
    /// A name: that of the sliding length, the body or the joint.
    pub name: &'static str,
    /// A point that the guide's line goes through; of an arc the centre.
    pub origin: usize,
    /// The direction of the line; of an arc a direction that turns with the carrier.
    pub direction: usize,
    /// The point that slides: always on the line or the arc.
    pub slider: usize,
    /// The carrier of the guide.
    pub on: GuideOn,
    /// The shape of the guide.
    pub shape: GuideShape,
}

/// The shape of a guide.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum GuideShape {
    /// A slot or a rail with a block.
    Slot,
    /// A cylinder between two pins, of which the slider is the end of the piston rod.
    Cylinder,
    /// A slot that is an arc about the origin, in the plane.
    Arc,
}

/// The carrier of a guide.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum GuideOn {
    /// The frame: it does not move.
    Frame,
    /// A link of the picture.
    Link(usize),
    /// A link of its own that turns about the origin, as in an oscillating cylinder.
    Itself,
}

/// The share of a part in a picture, by indices. Additions of the machine itself belong to no part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PicturePart {
    /// Its name in the program, with which the names of its contents begin: `hook.tip` is the tip
    /// of `hook`.
    pub name: &'static str,
    /// Points. One in which parts meet belongs to all of them.
    pub points: &'static [usize],
    /// Links.
    pub links: &'static [usize],
    /// Guides.
    pub guides: &'static [usize],
}

/// A joint where links meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PictureJoint {
    /// The point.
    pub point: usize,
    /// The relative motion of the links.
    pub shape: JointShape,
}

/// Two wheels that turn each other.
///
/// Their ratio is that of the angles by which they turn between any two positions, as seen from the
/// line through their centres.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Gear {
    /// The points that the wheels turn about.
    pub centres: [usize; 2],
    /// The marks by which the turns of the wheels are seen.
    pub turns: [WheelTurn; 2],
    /// The way in which they turn each other.
    pub contact: WheelContact,
}

/// A mark by which the turn of a wheel is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum WheelTurn {
    /// A point of the link that the wheel is part of.
    End(usize),
    /// A direction that turns with the wheel.
    Direction(usize),
    /// None: the wheel is fixed.
    Fixed,
}

/// The way in which two wheels turn each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum WheelContact {
    /// By teeth: one is within the other if both turn in one sense.
    Teeth,
    /// By a belt or a chain.
    Belt,
    /// Only a relation of angles is known: a belt if both turn in one sense, teeth otherwise.
    BySense,
}

/// A member that an input drives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Drive {
    /// Index among the inputs.
    pub input: usize,
    /// The driven member.
    pub on: DriveOn,
}

/// The member that a drive moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DriveOn {
    /// It turns a link about the first point; the second one belongs to the link.
    Turn([usize; 2]),
    /// It moves the slider of a guide.
    Slide(usize),
}

/// The relative motion of links in a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum JointShape {
    /// They turn about one axis; in the plane, about the point.
    Pin,
    /// They slide along one line.
    Slide,
    /// They turn about a point, in any direction.
    Ball,
    /// They turn about two axes through a point.
    Universal,
    /// They turn about a line and slide along it.
    Cylindrical,
}

/// An axis in space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Axis {
    /// A point on it.
    pub point: usize,
    /// Its direction.
    pub direction: usize,
}
