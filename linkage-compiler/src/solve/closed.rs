//! A closed form: its kind, and the numbers that measure how well a group closes.

use std::borrow::Cow;

use linkage_symbolic::Ex;

/// What a kind of group tells about its solution.
#[derive(Clone, Debug)]
pub(crate) struct Closed<'m> {
    pub(crate) kind: Cow<'static, str>,
    pub(crate) class: u8,
    pub(crate) order: u8,
    pub(crate) method: &'static str,
    /// Two solutions, told apart by a mode.
    pub(crate) two_modes: bool,
    /// `|det J|` over its largest value for these lengths.
    pub(crate) margin: Ex<'m>,
    /// Positive where the group can be assembled, zero at the dead point, negative beyond. For a group with one
    /// solution it changes sign there.
    pub(crate) slack: Ex<'m>,
    /// What the slack is measured by: its value at the reference makes the slack a number of about 1.
    pub(crate) slack_scale: Ex<'m>,
    /// By how much the group misses closing: positive if it cannot be assembled.
    pub(crate) gap: Ex<'m>,
    /// What the gap is measured in.
    pub(crate) gap_in: GapIn,
}

/// What a gap is measured in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum GapIn {
    /// Like the two sides of the loop.
    Loop,
    /// Like the unknown.
    Unknown,
    /// Like the links: the loop is about their lengths or squares of them.
    Link,
}
