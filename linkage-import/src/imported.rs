//! The results of an import.

use crate::drawn::Drawn;

/// A mechanism that was read from a file of another program.
#[derive(Clone, Debug, PartialEq)]
pub struct Import {
    /// The text of a file with one mechanism.
    pub text: String,
    /// Everything that could not be taken, or should be confirmed, one sentence each.
    pub warnings: Vec<String>,
    /// The pose of the file, to be compared with the assembled mechanism.
    pub drawn: Drawn,
}
