//! Errors in the numbers of a pin.

use core::fmt;

use super::criterion::Criterion;
use linkage_core::format::rounded;

/// Why a pin cannot be computed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum PinError {
    /// A number that makes no sense.
    Invalid {
        /// Name of the number.
        what: &'static str,
        /// The number.
        value: f64,
        /// The range that is required.
        expected: &'static str,
    },
    /// There are no reactions to take the largest of.
    NoReactions,
    /// A reaction is NaN or infinite: the mechanism cannot be assembled there, or is at a dead
    /// point.
    NotFinite {
        /// The position, counted from 0.
        position: usize,
    },
    /// No diameter is large enough: the hub grows with the diameter and the seat does not, so that
    /// the pressure at the seat's mouth falls to `least` and no further.
    SeatTooShort {
        /// The pressure at the seat's mouth for a very large diameter.
        least: f64,
        /// The allowable pressure.
        allowable: f64,
    },
    /// The numbers are so large or so small that a result is beyond the range of floating point
    /// numbers.
    OutOfRange {
        /// The check.
        criterion: Criterion,
    },
}

impl fmt::Display for PinError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Invalid {
                what,
                value,
                expected,
            } => write!(f, "{what} is {value}: it must be {expected}"),
            Self::NoReactions => f.write_str("there are no reactions to take the largest of"),
            Self::NotFinite { position } => write!(
                f,
                "position {position}: the reaction is not finite: the mechanism cannot be assembled there \
                 or stands at a dead point"
            ),
            Self::SeatTooShort { least, allowable } => write!(
                f,
                "no diameter is large enough: the pressure in the seat stays above {}, and {} is \
                 allowable: make the seat longer, or its length a ratio as the hub's width is",
                rounded(*least),
                rounded(*allowable)
            ),
            Self::OutOfRange { criterion } => write!(
                f,
                "{criterion}: the numbers are too large or too small to compute with"
            ),
        }
    }
}

impl core::error::Error for PinError {}
