//! A drawing of a page, as its payload has it.

use crate::document::LengthUnit;

/// All that a payload has.
#[derive(Default)]
pub(super) struct Drawing {
    pub(super) unit: Option<LengthUnit>,
    /// Revolutions per minute of motors without their own, and their sense.
    pub(super) speed: f64,
    pub(super) is_clockwise: bool,
    pub(super) joints: Vec<PageJoint>,
    pub(super) links: Vec<PageLink>,
    /// The unit of forces, if it is known.
    pub(super) force_unit: Option<&'static str>,
    pub(super) forces: Vec<PageForce>,
    /// True if numbers have corrections, so that all of them are those of the page.
    pub(super) is_precise: bool,
    pub(super) warnings: Vec<String>,
}

/// A force on a link, as an arrow of the page.
#[derive(Clone, Debug, Default)]
pub(super) struct PageForce {
    pub(super) id: String,
    pub(super) link: String,
    /// The place of application.
    pub(super) start: [f64; 2],
    pub(super) end: [f64; 2],
    pub(super) size: f64,
    /// True if it turns with the link.
    pub(super) turns: bool,
    /// True for an arrow that points from its place of application to its end.
    pub(super) points_away: bool,
}

/// A joint: a pin, or a slide with its line.
#[derive(Clone, Debug, Default)]
pub(super) struct PageJoint {
    pub(super) id: String,
    pub(super) name: String,
    pub(super) position: [f64; 2],
    pub(super) angle: f64,
    pub(super) is_slide: bool,
    pub(super) is_input: bool,
    pub(super) is_grounded: bool,
    pub(super) is_welded: bool,
    pub(super) is_sealed: bool,
    /// The link with the slot and the two joints that the slot joins.
    pub(super) carrier: Option<[String; 3]>,
    pub(super) speed: f64,
    pub(super) mass: f64,
}

/// A link or the block of a slide.
#[derive(Clone, Debug, Default)]
pub(super) struct PageLink {
    pub(super) id: String,
    pub(super) name: String,
    pub(super) is_root: bool,
    pub(super) is_block: bool,
    pub(super) mass: f64,
    pub(super) inertia: f64,
    pub(super) centre: [f64; 2],
    pub(super) joints: Vec<String>,
    pub(super) parts: Vec<String>,
}
