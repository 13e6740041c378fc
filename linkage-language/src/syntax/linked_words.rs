//! Words within the items of joints and links, and names of their quantities.

use super::vocabulary::{Word, vocabulary};

vocabulary! {
    /// The word that a clause of a link begins with.
    pub enum LinkClause {
        /// The direction from the first joint of the link to the second: an input, or any angle.
        At = "at",
        /// The distance of the first two joints of the link; an input makes it a cylinder.
        Length = "length",
        /// The axis of a hinge in space, in the first joint of the link.
        About = "about",
        /// A mass of the link and its point.
        Mass = "mass",
        /// A moment of inertia of the link.
        Inertia = "inertia",
    }
}

vocabulary! {
    /// A word of a slider after the joint that slides.
    pub enum SliderWord {
        /// The link that has the slot.
        On = "on",
        /// A straight slot: the joints that its line leads through, or its direction in the drawing.
        Along = "along",
        /// A joint that a slot of given direction leads through.
        Through = "through",
        /// A slot that is an arc about a joint of the link.
        Around = "around",
        /// The radius of a slot that is an arc.
        Radius = "radius",
        /// The link that does not turn in the slot, and transmits a moment.
        Block = "block",
        /// The position in the slot: an input, or any length.
        At = "at",
    }
}

vocabulary! {
    /// A word of gears or a belt after the two links.
    pub enum WheelsWord {
        /// The link that carries the pivots of both wheels; the frame if it is left out.
        On = "on",
        /// Numbers of teeth; that of an inner gear is negative.
        Teeth = "teeth",
        /// Radii instead of numbers of teeth.
        Radii = "radii",
    }
}

vocabulary! {
    /// The name of a quantity of a link or slider, as in `coupler.angle`.
    pub enum LinkQuantity {
        /// The direction from the first joint of a link to the second, or that of a pin from the middle of its arc.
        Angle = "angle",
        /// The distance of the first two joints of a link.
        Length = "length",
        /// The radius of a slot that is an arc.
        Radius = "radius",
        /// The position on the frame that a slider counts from.
        Start = "start",
    }
}

/// Returns true for a word that names a clause or a quantity of links, and so no joint.
pub(super) fn is_word_of_links(word: &str) -> bool {
    LinkClause::from_word(word).is_some() || LinkQuantity::from_word(word).is_some()
}
