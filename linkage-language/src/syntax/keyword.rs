//! Keywords of the language, and those of Rust.

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
        Unit = "unit",
        Const = "const",
        Param = "param",
        Input = "input",
        Unknown = "unknown",
        Let = "let",
        Loop = "loop",
        Argument = "argument",
        Part = "part",
        Gravity = "gravity",
        Body = "body",
        Arc = "arc",
    }
}

vocabulary! {
    /// Items without a name and without `=`.
    pub enum LoadWord {
        Force = "force",
        Torque = "torque",
        Spring = "spring",
        Damper = "damper",
    }
}

vocabulary! {
    /// Items that describe a mechanism by its joints and links.
    pub enum LinkedWord {
        Joint = "joint",
        Link = "link",
        Slider = "slider",
        Gears = "gears",
        Belt = "belt",
        Weld = "weld",
    }
}

vocabulary! {
    /// The word that a clause of a body, a joint or a load begins with.
    pub enum ClauseWord {
        On = "on",
        At = "at",
        Along = "along",
        About = "about",
        Turns = "turns",
        Turned = "turned",
        Mass = "mass",
        Inertia = "inertia",
        From = "from",
        To = "to",
        Free = "free",
    }
}

vocabulary! {
    /// The kind of a joint: the motions that it permits.
    pub enum JointKind {
        Pin = "pin",
        Slide = "slide",
        Roller = "roller",
        Ball = "ball",
        Cylinder = "cylinder",
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

pub(super) fn is_keyword(word: &str) -> bool {
    KEYWORDS.contains(&word)
}
