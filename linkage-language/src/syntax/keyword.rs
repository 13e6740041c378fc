//! Keywords of the language, and those of Rust.

use super::linked_words::{LinkClause, SliderWord, WheelsWord};
use super::vocabulary::{Word, vocabulary};

vocabulary! {
    /// The word that an item of the struct block begins with.
    pub enum ItemWord {
        Declaration(DeclarationWord),
        Joint(JointKind),
        Load(LoadWord),
        Linked(LinkedWord),
    }
}

vocabulary! {
    /// Items that declare something, and the unit.
    pub enum DeclarationWord {
        /// The length unit of fields and results.
        Unit = "unit",
        /// A value that is known at compile time.
        Const = "const",
        /// A dimension, which can change at run time; a tolerance may follow after `+-`.
        Param = "param",
        /// A driving coordinate: its reference position, and after `in` the range in which the mechanism must work.
        Input = "input",
        /// An angle, a length, a point or a frame that the loops determine, with its estimate.
        Unknown = "unknown",
        /// A derived quantity of the names before it.
        Let = "let",
        /// An equation that the links close, of vectors or of numbers.
        Loop = "loop",
        /// A number that functions take besides inputs, such as a load.
        Argument = "argument",
        /// Another mechanism within this one.
        Part = "part",
        /// The acceleration of gravity.
        Gravity = "gravity",
        /// A link with mass, which a joint attaches to another one.
        Body = "body",
        /// An arc about a centre that a curved slot has the form of.
        Arc = "arc",
    }
}

vocabulary! {
    /// Items without a name and without `=`.
    pub enum LoadWord {
        /// A force on a body at a point.
        Force = "force",
        /// A torque on a body.
        Torque = "torque",
        /// A spring between two bodies or in a joint.
        Spring = "spring",
        /// A damper between two bodies or in a joint.
        Damper = "damper",
        /// Dry friction in a pin or slide, from its reaction.
        Friction = "friction",
    }
}

vocabulary! {
    /// Items that describe a mechanism by its joints and links.
    pub enum LinkedWord {
        /// Joints with the positions of a drawing.
        Joint = "joint",
        /// A rigid link by the names of its joints.
        Link = "link",
        /// A joint that slides along a line or an arc of a link.
        Slider = "slider",
        /// Two outer gears, which turn in opposite directions.
        Gears = "gears",
        /// A belt or chain over two wheels, which turn in one direction.
        Belt = "belt",
        /// Links that are one body.
        Weld = "weld",
    }
}

vocabulary! {
    /// The word that a clause of a body, a joint or a load begins with.
    pub enum ClauseWord {
        /// The body that carries it.
        On = "on",
        /// The point, direction or position of it; the speed and acceleration of an input.
        At = "at",
        /// The direction in which it slides.
        Along = "along",
        /// The axis about which it turns.
        About = "about",
        /// The angle of the body.
        Turns = "turns",
        /// The angle of a part.
        Turned = "turned",
        /// The mass and its point.
        Mass = "mass",
        /// The moment of inertia.
        Inertia = "inertia",
        /// The body that takes the opposite force, or the first end.
        From = "from",
        /// The second end.
        To = "to",
        /// The length or angle without force.
        Free = "free",
        /// The radius of a pin with friction.
        Radius = "radius",
        /// The length of the block of a slide with friction.
        Length = "length",
    }
}

vocabulary! {
    /// Words within items that begin no clause.
    pub enum MarkWord {
        /// The range in which the mechanism must work, as in `in LOW..HIGH`.
        In = "in",
        /// The equation follows from the others.
        Redundant = "redundant",
        /// The link that does not move.
        Frame = "frame",
    }
}

vocabulary! {
    /// The kind of a joint: the motions that it permits.
    pub enum JointKind {
        /// A joint about which two bodies turn.
        Pin = "pin",
        /// A joint along which two bodies slide without turning.
        Slide = "slide",
        /// A pin in a slot: two bodies turn and slide.
        Roller = "roller",
        /// A joint that allows all rotations.
        Ball = "ball",
        /// A joint that turns about an axis and slides along it.
        Cylinder = "cylinder",
        /// A joint without motion: both bodies are one.
        Fixed = "fixed",
    }
}

impl JointKind {
    /// The clause that names its direction.
    pub fn direction_word(self) -> ClauseWord {
        match self {
            JointKind::Slide | JointKind::Roller => ClauseWord::Along,
            // Joints without a direction never need the word.
            JointKind::Pin | JointKind::Ball | JointKind::Cylinder | JointKind::Fixed => {
                ClauseWord::About
            }
        }
    }
}

impl ItemWord {
    /// The words of all items, for messages.
    pub(super) fn listed() -> String {
        let words: Vec<&str> = Self::all().map(Self::word).collect();
        words.join(" ")
    }
}

/// Rust's keywords, those reserved for later included; none may name anything.
const KEYWORDS: [&str; 53] = [
    "_", "abstract", "as", "async", "await", "become", "box", "break", "const", "continue",
    "crate", "do", "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if",
    "impl", "in", "let", "loop", "macro", "match", "mod", "move", "mut", "override", "priv", "pub",
    "ref", "return", "self", "Self", "static", "struct", "super", "trait", "true", "try", "type",
    "typeof", "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

/// Returns true for a keyword of Rust, which may name nothing.
pub fn is_keyword(word: &str) -> bool {
    KEYWORDS.contains(&word)
}

/// Returns true for a word within items that a value or a name can follow, and for a mark at their
/// end. After a value, none of them is a name.
pub fn is_clause_word(word: &str) -> bool {
    let is_mark = MarkWord::from_word(word).is_some_and(|mark| match mark {
        MarkWord::In | MarkWord::Redundant => true,
        MarkWord::Frame => false,
    });
    is_mark
        || word == "by"
        || ClauseWord::from_word(word).is_some()
        || LinkClause::from_word(word).is_some()
        || SliderWord::from_word(word).is_some()
        || WheelsWord::from_word(word).is_some()
}
