//! Double-double numbers of about 32 digits: the unevaluated sum of two plain numbers, the second
//! of which is at most half of the last place of the first.
//!
//! The errors of sums and products are plain numbers and are computed exactly (Knuth, Dekker).
//! Products split their factors in halves: not every target has a fused operation, and results must
//! not depend on the target.

use core::ops::{Add, Mul, Neg, Sub};

/// A number of about 32 digits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleDouble {
    /// The nearest plain number.
    pub high: f64,
    /// The rest.
    pub low: f64,
}

impl DoubleDouble {
    /// Returns the exact sum of two numbers.
    #[inline(always)]
    pub fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let of_b = high - a;
        let low = (a - (high - of_b)) + (b - of_b);
        Self { high, low }
    }

    /// Returns the exact difference of two numbers.
    #[inline(always)]
    pub fn difference(a: f64, b: f64) -> Self {
        Self::sum(a, -b)
    }

    /// Returns the exact sum of two numbers of which the first is the larger one, or 0.
    #[inline(always)]
    fn ordered_sum(large: f64, small: f64) -> Self {
        let high = large + small;
        let low = small - (high - large);
        Self { high, low }
    }

    /// Returns the exact product of two numbers.
    #[inline(always)]
    fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        let ([a, a_rest], [b, b_rest]) = (halves(a), halves(b));
        let low = ((a * b - high) + a * b_rest + a_rest * b) + a_rest * b_rest;
        Self { high, low }
    }
}

/// Splits a number in the upper and the lower half of its digits.
#[inline(always)]
fn halves(value: f64) -> [f64; 2] {
    // 2^27 + 1.
    const SPLITTER: f64 = 134_217_729.0;
    let spread = SPLITTER * value;
    let upper = spread - (spread - value);
    [upper, value - upper]
}

impl From<f64> for DoubleDouble {
    #[inline(always)]
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    /// Keeps 32 digits of the result, also where leading digits cancel.
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let high = Self::sum(self.high, other.high);
        let low = Self::sum(self.low, other.low);
        let first = Self::ordered_sum(high.high, high.low + low.high);
        Self::ordered_sum(first.high, first.low + low.low)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let product = Self::product(self.high, other.high);
        let crossed = self.high * other.low + self.low * other.high;
        Self::ordered_sum(product.high, product.low + crossed)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self {
            high: -self.high,
            low: -self.low,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::complex::{Complex, I};
    use super::DoubleDouble;

    /// A unit in the 31st place.
    const DIGITS: f64 = 1e-31;

    const fn double(high: f64, low: f64) -> DoubleDouble {
        DoubleDouble { high, low }
    }

    const fn plain(high: f64) -> DoubleDouble {
        double(high, 0.0)
    }

    /// The absolute value, to 16 digits.
    fn size(value: DoubleDouble) -> f64 {
        (value.high + value.low).abs()
    }

    /// `e` and its inverse, from tables: the nearest numbers, and those nearest to the rest.
    const E: DoubleDouble = double(core::f64::consts::E, 1.445_646_891_729_250_2e-16);
    const INVERSE: DoubleDouble = double(0.367_879_441_171_442_33, -1.242_875_367_278_836_3e-17);

    #[test]
    fn errors_of_sums_and_products_are_exact() {
        let small = (0.5_f64).powi(70);
        let sum = plain(1.0) + plain(small);
        assert_eq!(sum, double(1.0, small));
        assert_eq!(sum - plain(1.0), plain(small));
        // The larger one second.
        assert_eq!(plain(small) + plain(1.0), sum);

        let near_one = 1.0 + (0.5_f64).powi(30);
        let square = plain(near_one) * plain(near_one);
        assert_eq!(square, double(1.0 + (0.5_f64).powi(29), (0.5_f64).powi(60)));
        // All digits of both factors.
        let [above, below] = [1.0 + f64::EPSILON, 1.0 - f64::EPSILON];
        let product = plain(above) * plain(below);
        assert_eq!(product, double(1.0, -f64::EPSILON * f64::EPSILON));
    }

    #[test]
    fn products_have_the_digits_of_both_parts() {
        assert!(size(E * INVERSE - plain(1.0)) < DIGITS);
        assert!(size(-E * INVERSE + plain(1.0)) < DIGITS);
        // (a + b)^2 - (a - b)^2 = 4 a b, of which the first two agree in 16 digits.
        let b = INVERSE * plain(1e-16);
        let [sum, difference] = [E + b, E - b];
        let four = sum * sum - difference * difference;
        assert!(size(four - plain(4e-16)) < 20.0 * DIGITS);
    }

    #[test]
    fn complex_numbers_have_them_too() {
        let z = Complex::new(E, INVERSE);
        let one = z * z.inverse();
        assert!(size(one.re - plain(1.0)) < DIGITS && size(one.im) < DIGITS);
        let turned = z * I.wide();
        assert_eq!((turned.re, turned.im), (-INVERSE, E));
        assert_eq!(z.scaled(plain(2.0)) - z, z);
        assert_eq!(z.narrow(), Complex::new(E.high, INVERSE.high));
    }
}
