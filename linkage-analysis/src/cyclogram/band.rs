//! Bands of a quantity in which a member dwells.

use core::fmt;
use linkage_core::format::rounded;

/// A band of a quantity: within it a member dwells. In the unit of the quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Band {
    /// A distance from the highest position down.
    Top(f64),
    /// A distance from the lowest position up.
    Bottom(f64),
    /// Between two values, the lower one first.
    Between(f64, f64),
}

impl Band {
    /// The values that the band begins and ends at, with the values of the member's lowest and
    /// highest position.
    pub(super) fn bounds(self, [lowest, highest]: [f64; 2]) -> [f64; 2] {
        match self {
            // Beyond the limit there is nothing; another limit as high may be so up to rounding.
            Self::Top(width) => [highest - width, f64::INFINITY],
            Self::Bottom(width) => [f64::NEG_INFINITY, lowest + width],
            Self::Between(low, high) => [low, high],
        }
    }
}

/// A text such as `top 0.05`.
impl fmt::Display for Band {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Top(width) => write!(f, "top {}", rounded(width)),
            Self::Bottom(width) => write!(f, "bottom {}", rounded(width)),
            Self::Between(low, high) => write!(f, "{} to {}", rounded(low), rounded(high)),
        }
    }
}
