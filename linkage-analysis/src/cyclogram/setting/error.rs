//! Why an event cannot be set to an angle.

use super::value::VALUES;
use alloc::string::String;
use core::fmt;
use linkage_core::format::rounded;

/// A reason why an event cannot be set to an angle. `E` is the error of building a member.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum SettingError<E> {
    /// No member can be built with any value that was looked at.
    Unbuilt {
        /// The range of the parameter.
        range: (f64, f64),
        /// Why there is none with the first value.
        error: E,
    },
    /// The members have no such event.
    NoEvent {
        /// The range of the parameter.
        range: (f64, f64),
        /// The member.
        member: String,
    },
    /// The member has no sensitivities, or none to this parameter.
    Parameter {
        /// The member.
        member: String,
        /// The index of the parameter.
        parameter: usize,
        /// The number of parameters of the sensitivities; `None` if there are none.
        sensitivities: Option<usize>,
    },
    /// The event is nowhere at the wanted angle.
    Unreached {
        /// The member.
        member: String,
        /// The wanted angle.
        wanted: f64,
        /// The nearest angle that was found: at the values that are looked at, the ends of the
        /// range among them, and where the angle turns back between them.
        nearest: f64,
        /// At this value of the parameter.
        value: f64,
        /// The range of the parameter.
        range: (f64, f64),
    },
}

impl<E: fmt::Display> fmt::Display for SettingError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unbuilt { range, error } => write!(
                f,
                "there is no organ with any of the {VALUES} values from {} to {} of the parameter that were looked at; with the first \
                 one: {error}",
                rounded(range.0),
                rounded(range.1)
            ),
            Self::NoEvent { range, member } => write!(
                f,
                "`{member}` has no event that is meant, with any of the {VALUES} values from {} to {} of the parameter that were \
                 looked at",
                rounded(range.0),
                rounded(range.1)
            ),
            Self::Parameter {
                member,
                parameter,
                sensitivities: Some(count),
            } => write!(
                f,
                "`{member}` has sensitivities to {count} parameters, and none with the index {parameter}"
            ),
            Self::Parameter { member, .. } => write!(
                f,
                "`{member}` has no sensitivities, which lead to the wanted angle\nhelp: call `sensitivities` on the organ that is built"
            ),
            Self::Unreached {
                member,
                wanted,
                nearest,
                value,
                range,
            } => write!(
                f,
                "no event of `{member}` that is meant is at {} deg: the nearest angle is {} deg, where the parameter is {} (from {} to \
                 {})\nhelp: give a wider range, or change another parameter",
                rounded(wanted.to_degrees()),
                rounded(nearest.to_degrees()),
                rounded(*value),
                rounded(range.0),
                rounded(range.1)
            ),
        }
    }
}

impl<E: fmt::Debug + fmt::Display> core::error::Error for SettingError<E> {}
