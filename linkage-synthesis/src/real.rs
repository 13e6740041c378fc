//! Real numbers with bounds of their rounding errors.

use linkage_core::numeric::complex::Ring;

/// A real number of the middles of discs.
pub(super) trait Real: Ring {
    /// A plain number, exactly; it is finite.
    fn exact(number: f64) -> Self;

    /// A bound of the absolute value.
    fn bound(self) -> f64;

    /// Returns a bound of the error of a complex sum of this size; that of products is four times
    /// as large.
    fn rounding(size: f64) -> f64;
}

impl Real for f64 {
    #[inline(always)]
    fn exact(number: f64) -> Self {
        number
    }

    #[inline(always)]
    fn bound(self) -> f64 {
        self.abs()
    }

    #[inline(always)]
    fn rounding(size: f64) -> f64 {
        f64::EPSILON * size
    }
}
