//! Events among those of all members of a shaft.

use super::{Event, Member};

/// An event among those of all members. Printed, it is a text such as
/// `hook's dwell (top 0.5 mm) begins`.
#[derive(Clone, Copy, Debug)]
pub struct Moment<'a> {
    /// The member.
    pub member: &'a Member,
    /// The index of its event.
    pub index: usize,
    /// The event.
    pub event: &'a Event,
    /// Turn of the shaft from the event before it, of any member, to this one.
    pub after: f64,
}
