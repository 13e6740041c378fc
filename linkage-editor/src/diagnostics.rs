//! Messages about a text, and the changes that they propose.

use std::ops::Range;

/// A message of the compiler.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// The words at fault.
    pub range: Range<usize>,
    /// A mistake or a warning.
    pub severity: Severity,
    /// The fact, in lower case, names in back-ticks.
    pub message: String,
    /// The advice.
    pub help: Option<String>,
    /// Further places of the same mistake.
    pub related: Vec<Related>,
    /// Changes that follow the advice.
    pub fixes: Vec<Fix>,
}

/// The weight of a message.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// The mechanism cannot be compiled.
    Error,
    /// The text is valid, but hardly meant.
    Warning,
}

/// A further place of a mistake.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Related {
    /// The words.
    pub range: Range<usize>,
    /// Their part in the mistake.
    pub message: String,
}

/// A change of a text that an editor offers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fix {
    /// The change in a few words, as in a menu.
    pub title: String,
    /// The replacements, which do not overlap.
    pub edits: Vec<Edit>,
}

/// A replacement of some bytes of a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// The bytes that are replaced.
    pub range: Range<usize>,
    /// The text instead of them.
    pub text: String,
}

impl Diagnostic {
    /// Returns a mistake without advice.
    pub(crate) fn error(range: Range<usize>, message: &str) -> Self {
        Self {
            range,
            severity: Severity::Error,
            message: message.to_owned(),
            help: None,
            related: Vec::new(),
            fixes: Vec::new(),
        }
    }
}
