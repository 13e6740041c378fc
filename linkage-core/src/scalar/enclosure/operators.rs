//! Sums, products and quotients of enclosures.

use super::Enclosure;
use core::ops::{Add, Div, Mul, Neg, Sub};

impl Neg for Enclosure {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            range: -self.range,
            middle: -self.middle,
            slope: -self.slope,
            half: self.half,
        }
    }
}

// Calls, for the code of a mechanism would be many times as long otherwise.
impl Add for Enclosure {
    type Output = Self;

    #[inline(never)]
    fn add(self, other: Self) -> Self {
        Self::from_parts(
            self.range + other.range,
            self.middle + other.middle,
            self.slope + other.slope,
            self.half.max(other.half),
        )
    }
}

impl Sub for Enclosure {
    type Output = Self;

    #[inline(never)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Enclosure {
    type Output = Self;

    #[inline(never)]
    fn mul(self, other: Self) -> Self {
        Self::from_parts(
            self.range * other.range,
            self.middle * other.middle,
            self.slope * other.range + self.range * other.slope,
            self.half.max(other.half),
        )
    }
}

impl Div for Enclosure {
    type Output = Self;

    #[inline(never)]
    fn div(self, other: Self) -> Self {
        let quotient = self.range / other.range;
        Self::from_parts(
            quotient,
            self.middle / other.middle,
            (self.slope - quotient * other.slope) / other.range,
            self.half.max(other.half),
        )
    }
}
