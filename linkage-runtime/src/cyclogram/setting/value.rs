//! A value of the parameter, and how many of them are looked at.

use crate::cyclogram::member::Member;

/// So many values of the parameter are looked at, evenly over its range, before anything is located: an event that does more between
/// two of them than turn back once is missed.
pub(super) const VALUES: usize = 33;

/// A value of the parameter at which the event is at the wanted angle.
#[derive(Clone, Debug)]
pub struct Setting {
    /// The value.
    pub value: f64,
    /// The organ with it.
    pub member: Member,
    /// The index of the event.
    pub event: usize,
}
