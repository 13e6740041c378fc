//! A reason why a curve cannot be summarised.

use core::fmt;

/// Why there is no summary.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SummaryError {
    /// The range of the input is empty, turned round or infinite.
    Range {
        /// Its beginning.
        from: f64,
        /// Its end.
        to: f64,
    },
    /// Too few positions to begin with.
    Positions {
        /// The given number.
        positions: usize,
    },
    /// The quantity is a number at none of the positions.
    NotAssembled {
        /// The number of positions.
        positions: usize,
    },
    /// A link that has no positive length.
    Length {
        /// The number of the derivative.
        link: &'static str,
        /// Its length.
        length: f64,
    },
}

impl fmt::Display for SummaryError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Range { from, to } => write!(
                f,
                "the range {from} to {to} is empty or infinite: give finite ends, the lower one first"
            ),
            Self::Positions { positions } => write!(
                f,
                "{positions} positions show no course: give at least 2, 360 for a turn"
            ),
            Self::NotAssembled { positions } => write!(
                f,
                "the quantity or a derivative is not finite at any of {positions} positions: the mechanism \
                 cannot be assembled in this range"
            ),
            Self::Length { link, length } => write!(
                f,
                "the {link} has a length of {length}: lengths are positive and finite"
            ),
        }
    }
}

impl core::error::Error for SummaryError {}
