//! Criteria for the size of a pin.

use core::fmt;

/// A part that a pin presses on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BearingPart {
    /// The rod of a clevis.
    Rod,
    /// The fork of a clevis.
    Fork,
    /// The hub on an overhung pin.
    Hub,
    /// The seat of an overhung pin.
    Seat,
}

impl fmt::Display for BearingPart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Rod => "rod",
            Self::Fork => "fork",
            Self::Hub => "hub",
            Self::Seat => "seat",
        })
    }
}

/// A criterion for the size of a pin.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Criterion {
    /// Its bending.
    Bending,
    /// Its shear.
    Shear,
    /// The bearing pressure in a part.
    Bearing(BearingPart),
}

impl fmt::Display for Criterion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bending => f.write_str("bending"),
            Self::Shear => f.write_str("shear"),
            Self::Bearing(part) => write!(f, "bearing pressure in the {part}"),
        }
    }
}
