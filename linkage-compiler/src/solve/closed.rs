//! A closed form: its kind, and the numbers that measure how well a group closes.

use std::borrow::Cow;

use linkage_symbolic::Ex;

/// The closed form of a group.
#[derive(Clone, Debug)]
pub(crate) struct ClosedForm<'m> {
    pub(crate) kind: Cow<'static, str>,
    pub(crate) class: u8,
    pub(crate) order: u8,
    pub(crate) method: &'static str,
    /// True if there are two solutions, which a mode distinguishes.
    pub(crate) two_modes: bool,
    /// `|det J|` over its largest value for these lengths.
    pub(crate) margin: Ex<'m>,
    /// Positive where the group can be assembled, zero at the dead point, negative beyond. For a
    /// group with one solution it changes sign there.
    pub(crate) slack: Ex<'m>,
    /// The measure of the slack: its value at the reference makes the slack a number of about 1.
    pub(crate) slack_scale: Ex<'m>,
    /// The distance from closing: positive if the group cannot be assembled.
    pub(crate) gap: Ex<'m>,
    /// The unit of the gap.
    pub(crate) gap_in: GapIn,
}

/// The unit of a gap.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum GapIn {
    /// Like the two sides of the loop.
    Loop,
    /// Like the unknown.
    Unknown,
    /// Like the links: the loop is about their lengths or squares of them.
    Link,
}
