//! The motions of a member, and the events between them.

use super::Band;
use core::fmt;

/// A motion of a member during an interval of the cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Motion {
    /// The quantity rises.
    Advance,
    /// It is in a band, the one of this index.
    Dwell(usize),
    /// It falls.
    Return,
}

impl Motion {
    /// Returns true for a dwell, in any of the bands.
    #[must_use]
    pub const fn is_dwell(self) -> bool {
        matches!(self, Self::Dwell(_))
    }

    /// The text, with the member's bands.
    pub(crate) fn described<'a>(self, bands: &'a [Band], unit: &'a str) -> impl fmt::Display + 'a {
        linkage_core::format::printed(move |f| match self {
            Self::Advance => f.write_str("advance"),
            Self::Return => f.write_str("return"),
            Self::Dwell(band) => {
                let space = if unit.is_empty() { "" } else { " " };
                write!(f, "dwell ({}{space}{unit})", bands[band])
            }
        })
    }
}

/// Why a motion ends where it does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Cause {
    /// The quantity passes a bound of the band.
    Bound {
        /// The index of the band.
        band: usize,
    },
    /// It turns back, from an advance to a return or the other way round, without a dwell.
    Turn,
}

/// The angle of the shaft at which one motion of a member ends and the next one begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// The angle, in radians.
    pub at: f64,
    /// The quantity there.
    pub value: f64,
    /// Its derivative by the angle.
    pub slope: f64,
    /// Its second derivative; NaN where the curve has none.
    pub bend: f64,
    /// Why it is there.
    pub cause: Cause,
    /// The motion that ends.
    pub ends: Motion,
    /// The motion that begins.
    pub begins: Motion,
}
