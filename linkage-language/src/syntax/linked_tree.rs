//! The syntax tree of joints and links.

use proc_macro2::Ident;

use super::expression_tree::{Expr, Toleranced};
use super::keyword::LinkedWord;
use super::mechanics_tree::{InertiaPart, MassPart};
use crate::diagnostic::SourceSpan;

#[derive(Debug)]
pub enum LinkedItem {
    Joints(Vec<DrawnJoint>),
    Link(LinkItem),
    Slider(SliderItem),
    /// `gears a, b`: outer gears turn in opposite directions.
    Gears(WheelsItem),
    /// `belt a, b`: both wheels turn in the same direction.
    Belt(WheelsItem),
    Weld(WeldItem),
    /// An item that could not be read; a mistake has been reported.
    Lost(LostItem),
}

/// The names that an item declares which could not be read otherwise.
#[derive(Debug)]
pub struct LostItem {
    pub word: LinkedWord,
    pub names: Vec<Ident>,
}

/// `NAME = (x, y)` after `joint`.
#[derive(Debug)]
pub struct DrawnJoint {
    pub name: Ident,
    pub position: Toleranced,
}

/// `link NAME: joint, joint [= (x, y)], ... [at angle] [length l] [about axis] [mass m at point]
/// [inertia i [at point]];`
#[derive(Debug)]
pub struct LinkItem {
    pub name: Ident,
    pub joints: Vec<LinkJoint>,
    /// The direction from its first joint to its second.
    pub at: Option<Expr>,
    /// The distance of these joints.
    pub length: Option<Toleranced>,
    /// The axis of a hinge in space, in its first joint.
    pub about: Option<Expr>,
    pub masses: Vec<MassPart>,
    pub inertias: Vec<InertiaPart>,
}

/// A joint of a link, with its coordinates if they are given.
#[derive(Debug)]
pub struct LinkJoint {
    pub name: Ident,
    /// The x axis is from the first joint to the second.
    pub coordinates: Option<Toleranced>,
}

/// `slider NAME: joint on LINK along ... [block LINK] [at position];`
#[derive(Debug)]
pub struct SliderItem {
    pub name: Ident,
    pub pin: Ident,
    pub guide: Ident,
    pub path: SlidePath,
    /// The link that keeps its angle to the guide.
    pub block: Option<Ident>,
    /// The position from the first joint towards the second.
    pub at: Option<Expr>,
}

/// The way of a slider on its guide.
#[derive(Debug)]
pub enum SlidePath {
    /// `along joint, joint`
    Line([Ident; 2]),
    /// `along angle [through joint]`, the angle in the drawing.
    Direction { angle: Expr, through: Option<Ident> },
    /// `around joint [radius r]`
    Arc {
        centre: Ident,
        radius: Option<Toleranced>,
    },
}

/// `gears LINK, LINK [on LINK] teeth a, b;`, `belt ... radii a, b;`
#[derive(Debug)]
pub struct WheelsItem {
    pub wheels: [Ident; 2],
    /// The link that carries both pivots; the frame if it is not named.
    pub carrier: Option<Ident>,
    /// Numbers of teeth, or radii.
    pub sizes: [Expr; 2],
    pub span: SourceSpan,
}

/// `weld LINK, LINK, ...;`
#[derive(Debug)]
pub struct WeldItem {
    pub links: Vec<Ident>,
}

impl LinkedItem {
    /// Returns the word that it begins with.
    pub fn word(&self) -> LinkedWord {
        match self {
            LinkedItem::Joints(_) => LinkedWord::Joint,
            LinkedItem::Link(_) => LinkedWord::Link,
            LinkedItem::Slider(_) => LinkedWord::Slider,
            LinkedItem::Gears(_) => LinkedWord::Gears,
            LinkedItem::Belt(_) => LinkedWord::Belt,
            LinkedItem::Weld(_) => LinkedWord::Weld,
            LinkedItem::Lost(item) => item.word,
        }
    }
}
