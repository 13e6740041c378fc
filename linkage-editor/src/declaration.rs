//! Declared names and their kinds.

use std::ops::Range;

/// The kind of a declared name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NameKind {
    /// A mechanism.
    Mechanism,
    /// A value known at compile time.
    Constant,
    /// A dimension.
    Parameter,
    /// A driving coordinate.
    Input,
    /// A name that the loops determine.
    Unknown,
    /// A quantity derived from other names.
    Derived,
    /// A number that functions take besides inputs.
    Argument,
    /// Another mechanism within this one.
    Part,
    /// A body with mass.
    Body,
    /// A joint of bodies, or of links.
    Joint,
    /// A link.
    Link,
    /// A joint that slides on a link.
    Slider,
    /// A curved slot.
    Slot,
    /// A function of the `impl` block.
    Function,
    /// A field of the result of a function.
    Field,
}

impl NameKind {
    /// Returns the kind as text, without an article.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            NameKind::Mechanism => "mechanism",
            NameKind::Constant => "constant",
            NameKind::Parameter => "parameter",
            NameKind::Input => "input",
            NameKind::Unknown => "unknown",
            NameKind::Derived => "derived quantity",
            NameKind::Argument => "argument",
            NameKind::Part => "part",
            NameKind::Body => "body",
            NameKind::Joint => "joint",
            NameKind::Link => "link",
            NameKind::Slider => "slider",
            NameKind::Slot => "curved slot",
            NameKind::Function => "function",
            NameKind::Field => "field",
        }
    }

    /// Returns true for names whose values take operations: those of the others are given.
    pub(crate) fn has_cost(self) -> bool {
        match self {
            NameKind::Unknown | NameKind::Derived | NameKind::Joint | NameKind::Slider => true,
            NameKind::Mechanism
            | NameKind::Constant
            | NameKind::Parameter
            | NameKind::Input
            | NameKind::Argument
            | NameKind::Part
            | NameKind::Body
            | NameKind::Link
            | NameKind::Slot
            | NameKind::Function
            | NameKind::Field => false,
        }
    }
}

/// A declared name.
#[derive(Clone, Debug)]
pub(crate) struct Declaration {
    pub(crate) name: String,
    pub(crate) kind: NameKind,
    /// The name in the text.
    pub(crate) range: Range<usize>,
    /// The item that declares it, without its doc comment.
    pub(crate) item: Range<usize>,
    /// The value after `=`.
    pub(crate) value: Option<Range<usize>>,
    /// The mechanism that a part is.
    pub(crate) mechanism: Option<String>,
    /// Its doc comment, or the comment after the item.
    pub(crate) documentation: String,
}
