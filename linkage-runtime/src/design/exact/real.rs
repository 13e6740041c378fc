//! Real numbers with bounds of their rounding errors.

use linkage_core::numeric::complex::Ring;

/// What the middles of discs consist of.
pub(super) trait Real: Ring {
    /// A plain number, exactly; it is finite.
    fn exact(number: f64) -> Self;

    /// A bound of the absolute value.
    fn bound(self) -> f64;

    /// By how much a complex sum of this size is wrong at most; products by four times that.
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
