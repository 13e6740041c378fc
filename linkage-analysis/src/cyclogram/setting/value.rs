//! A value of the parameter, and how many of them are looked at.

use crate::cyclogram::member::Member;

/// The number of values of the parameter, evenly over its range, that are evaluated before anything
/// is located. An event that turns back more than once between two of them is missed.
pub(super) const VALUES: usize = 33;

/// A value of the parameter at which the event is at the wanted angle.
#[derive(Clone, Debug)]
pub struct Setting {
    /// The value.
    pub value: f64,
    /// The member with it.
    pub member: Member,
    /// The index of the event.
    pub event: usize,
}
