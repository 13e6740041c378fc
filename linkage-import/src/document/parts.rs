//! Parts of a drawing: joints, links with their masses, forces, slots and wheels.

/// A point that links share.
#[derive(Clone, Debug)]
pub(crate) struct Joint {
    /// The name in the file.
    pub(crate) name: String,
    pub(crate) position: [f64; 2],
    /// True for points that no file has, such as centres of arcs and of masses.
    pub(crate) is_derived: bool,
}

/// A rigid body.
#[derive(Clone, Debug, Default)]
pub(crate) struct Link {
    pub(crate) name: String,
    /// Indices of joints.
    pub(crate) joints: Vec<usize>,
    pub(crate) mass: Option<Mass>,
    /// True for wheels that do not turn, whose second joint is to the right of the first one.
    pub(crate) is_held: bool,
}

/// A mass with its units as text, and the joint at its centre.
#[derive(Clone, Debug)]
pub(crate) struct Mass {
    pub(crate) mass: String,
    pub(crate) inertia: Option<String>,
    pub(crate) centre: usize,
}

/// A force of constant size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Load {
    /// Its components in the drawing.
    pub(crate) vector: [f64; 2],
    pub(crate) unit: &'static str,
    /// True if it turns with its link.
    pub(crate) turns: bool,
}

/// A force on a link, and the joint at its place of application.
#[derive(Clone, Debug)]
pub(crate) struct PlacedLoad {
    pub(crate) link: usize,
    pub(crate) joint: usize,
    pub(crate) load: Load,
}

/// A pin that slides on a link.
#[derive(Clone, Debug)]
pub(crate) struct Slot {
    pub(crate) pin: usize,
    /// The link with the slot.
    pub(crate) guide: usize,
    pub(crate) path: SlotPath,
    /// A link that does not turn in the guide.
    pub(crate) block: Option<usize>,
}

/// The centre line of a slot.
#[derive(Clone, Debug)]
pub(crate) enum SlotPath {
    /// The line through two joints of the guide.
    Joints(usize, usize),
    /// A direction of the drawing through the pin: radians, and the same as text with a unit.
    /// A guide that moves has a joint there.
    Direction(f64, String, Option<usize>),
    /// An arc about a joint of the guide.
    Arc { centre: usize, radius: f64 },
}

/// Two wheels that mesh, or that a chain connects.
#[derive(Clone, Debug)]
pub(crate) struct GearPair {
    pub(crate) wheels: [usize; 2],
    pub(crate) sizes: [f64; 2],
    /// The link that has the axes of both wheels.
    pub(crate) arm: usize,
    pub(crate) is_chain: bool,
}
