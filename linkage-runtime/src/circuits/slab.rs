//! The part of the range between two ends, with a parameter that makes the functions smooth at
//! these ends.
//!
//! At a turning point places depend on the root of the distance from it. Inputs are a cubic of the
//! parameter whose slope vanishes at both ends, so that they are smooth functions of it.

use linkage_core::{Enclosure, Scalar};

/// Two inputs, the lower one first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Slab {
    pub(super) low: f64,
    pub(super) high: f64,
}

impl Slab {
    /// The input at a parameter from -1 to 1.
    pub(super) fn x(&self, u: f64) -> f64 {
        let share = 0.25 * (2.0 + u * (3.0 - u * u));
        if u <= -1.0 {
            self.low
        } else if u >= 1.0 {
            self.high
        } else {
            (self.low + (self.high - self.low) * share).clamp(self.low, self.high)
        }
    }

    /// The inputs of parameters from -1 to 1.
    pub(super) fn over(&self, u: Enclosure) -> Enclosure {
        let [low, quarter, two, three] =
            [self.low, 0.25 * (self.high - self.low), 2.0, 3.0].map(Enclosure::from_f64);
        low + quarter * (two + u * (three - u * u))
    }

    /// The inputs of parameters from -1 to 1 as a variable of their own, of which slopes have the
    /// same sign.
    pub(super) fn between(&self, u: Enclosure) -> Enclosure {
        let [low, high] = u.range().map(|u| self.x(u));
        Enclosure::over(low, high)
    }

    /// The slope of the input with respect to the parameter, compared with the middle.
    pub(super) fn slope(u: f64) -> f64 {
        1.0 - u * u
    }

    /// The parameter of an input: by bisection, since it is rarely needed.
    pub(super) fn parameter(&self, x: f64) -> f64 {
        let (mut low, mut high) = (-1.0, 1.0);
        for _ in 0..f64::MANTISSA_DIGITS {
            let middle = 0.5 * (low + high);
            if self.x(middle) < x {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high)
    }

    pub(super) fn covers(&self, x: f64) -> bool {
        self.low < x && x < self.high
    }
}
