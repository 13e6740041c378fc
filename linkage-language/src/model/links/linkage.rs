//! The joints and links of a mechanism, with numbers instead of names.

use proc_macro2::Ident;

use crate::syntax::{Expr, ExprKind, InertiaPart, MassPart, Toleranced};

/// The number of the frame, among links and among bodies.
pub(super) const FRAME: usize = 0;

/// The name of the length of a link.
pub(super) const LENGTH: &str = "length";
/// The name of the length of an arc.
pub(super) const RADIUS: &str = "radius";

pub(super) struct Linkage<'a> {
    pub(super) joints: Vec<Joint<'a>>,
    /// The frame is the first of them.
    pub(super) links: Vec<Link<'a>>,
    pub(super) sliders: Vec<Slider<'a>>,
    pub(super) arcs: Vec<Arc>,
    pub(super) wheels: Vec<Wheels<'a>>,
    /// Pairs of links that are one body.
    pub(super) welds: Vec<[usize; 2]>,
}

pub(super) struct Joint<'a> {
    pub(super) name: Ident,
    /// The place where it is drawn. A point that is declared with `let` or the like has none, and
    /// its position is known.
    pub(super) drawn: Option<&'a Toleranced>,
}

pub(super) struct Link<'a> {
    pub(super) name: Ident,
    pub(super) joints: Vec<usize>,
    /// Given coordinates, for each joint.
    pub(super) coordinates: Vec<Option<&'a Toleranced>>,
    pub(super) at: Option<&'a Expr>,
    /// The axis of a hinge in space.
    pub(super) about: Option<&'a Expr>,
    pub(super) length: Option<&'a Toleranced>,
    /// The name of its length: the arc of a curved slot has a radius.
    pub(super) length_word: &'static str,
    pub(super) masses: &'a [MassPart],
    pub(super) inertias: &'a [InertiaPart],
}

impl Link<'_> {
    /// Returns true for the arc of a curved slot, which is written as a slider.
    pub(super) fn is_arc(&self) -> bool {
        self.length_word == RADIUS
    }
}

/// A joint that slides along a line of a link.
pub(super) struct Slider<'a> {
    pub(super) name: Ident,
    pub(super) pin: usize,
    pub(super) guide: usize,
    pub(super) path: Path<'a>,
    pub(super) block: Option<usize>,
    pub(super) at: Option<&'a Expr>,
}

/// A slot that is an arc about a joint of the guide. The link of its name keeps the pin in it.
pub(super) struct Arc {
    pub(super) link: usize,
    pub(super) pin: usize,
    pub(super) centre: usize,
    pub(super) guide: usize,
}

#[derive(Clone, Copy)]
pub(super) enum Path<'a> {
    /// From one joint of the guide to another.
    Line([usize; 2]),
    /// A direction of the drawing, through a joint or the place where the pin is drawn.
    Direction(&'a Expr, Option<usize>),
}

/// Two wheels: the angle of the second one follows from that of the first one.
pub(super) struct Wheels<'a> {
    pub(super) wheels: [usize; 2],
    pub(super) carrier: usize,
    pub(super) sizes: &'a [Expr; 2],
    /// True for outer gears.
    pub(super) reverses: bool,
    pub(super) item: &'a crate::syntax::WheelsItem,
}

/// Returns true if all joints of a linkage that are drawn have three coordinates.
pub(super) fn is_spatial(linkage: &Linkage) -> bool {
    let mut drawn = linkage.joints.iter().filter_map(|joint| joint.drawn);
    let count = |value: &Toleranced| match value {
        Toleranced::Single { nominal, .. } => match &nominal.kind {
            ExprKind::Tuple(components) => components.len(),
            _ => 2,
        },
        Toleranced::Components { components, .. } => components.len(),
    };
    drawn.any(|position| count(position) == 3)
}

/// Returns true for a joint of the frame, or a point whose position is known.
pub(super) fn is_fixed(linkage: &Linkage, joint: usize) -> bool {
    linkage.links[FRAME].joints.contains(&joint) || linkage.joints[joint].drawn.is_none()
}
