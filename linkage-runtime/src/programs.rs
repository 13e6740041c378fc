//! Programs of a mechanism for pages.

/// The programs of a mechanism as JavaScript, for the page of a report: the constant `PROGRAMS` of
/// a mechanism with a function that asks for `picture()`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Programs {
    /// An object with all data of the mechanism for the engine.
    pub description: &'static str,
}
