//! Numbers of twice the digits: the unevaluated sum of two numbers, of which the second one is at most half of the last place of the first
//! one (double-double, about 32 digits).
//!
//! The errors of sums and products are numbers themselves and are computed exactly (Knuth, Dekker); products by halves of numbers, since
//! not every target has a fused operation, and results must not hang on it.

use core::ops::{Add, Mul, Neg, Sub};

/// A number of about 32 digits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Double {
    pub(super) high: f64,
    pub(super) low: f64,
}

impl Double {
    pub(super) const fn new(value: f64) -> Self {
        Self {
            high: value,
            low: 0.0,
        }
    }

    /// The sum of two numbers of which the first one is larger, or 0.
    #[inline(always)]
    fn ordered(large: f64, small: f64) -> Self {
        let high = large + small;
        let low = small - (high - large);
        Self { high, low }
    }

    /// The sum of any two numbers.
    #[inline(always)]
    fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let of_b = high - a;
        let low = (a - (high - of_b)) + (b - of_b);
        Self { high, low }
    }

    /// The product of two numbers.
    #[inline(always)]
    fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        let ([a, a_rest], [b, b_rest]) = (halves(a), halves(b));
        let low = ((a * b - high) + a * b_rest + a_rest * b) + a_rest * b_rest;
        Self { high, low }
    }
}

/// The upper and the lower half of the digits.
#[inline(always)]
fn halves(value: f64) -> [f64; 2] {
    // 2^27 + 1.
    const SPLITTER: f64 = 134_217_729.0;
    let spread = SPLITTER * value;
    let upper = spread - (spread - value);
    [upper, value - upper]
}

impl Add for Double {
    type Output = Self;

    /// To 32 digits of the larger one: of a difference no more are known.
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let high = Self::sum(self.high, other.high);
        Self::ordered(high.high, high.low + (self.low + other.low))
    }
}

impl Neg for Double {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        let [high, low] = [-self.high, -self.low];
        Self { high, low }
    }
}

impl Sub for Double {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Double {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let product = Self::product(self.high, other.high);
        let crossed = self.high * other.low + self.low * other.high;
        Self::ordered(product.high, product.low + crossed)
    }
}
