//! Choices that a file leaves open.

use crate::format::Format;

/// Choices of the user for [`import`](crate::import).
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The format, if neither name nor content decide it.
    pub format: Option<Format>,
    /// The name of the mechanism, otherwise from the name of the file.
    pub mechanism: Option<String>,
    /// Inputs: a pivot and another joint of the link that turns, `"p0,p1"`. They replace those of
    /// the file.
    pub inputs: Vec<String>,
}
