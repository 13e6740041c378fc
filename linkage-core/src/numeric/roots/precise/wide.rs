//! Complex numbers of about 32 digits.

use super::super::complex::Complex;
use super::double::Double;
use core::ops::{Add, Mul, Neg, Sub};

/// A complex number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Wide {
    pub(super) re: Double,
    pub(super) im: Double,
}

impl Wide {
    pub(super) const ZERO: Self = Self::new(Complex::new(0.0, 0.0));
    pub(super) const ONE: Self = Self::new(Complex::new(1.0, 0.0));

    pub(super) const fn new(value: Complex) -> Self {
        Self {
            re: Double::new(value.re),
            im: Double::new(value.im),
        }
    }

    /// The nearest number of 16 digits.
    pub(super) fn rounded(self) -> Complex {
        Complex::new(self.re.high, self.im.high)
    }

    /// A Newton step from the inverse of 16 digits.
    pub(super) fn inverse(self) -> Self {
        let rough = Self::new(self.rounded().inverse());
        rough + rough * (Self::ONE - self * rough)
    }

    #[inline(always)]
    pub(super) fn scaled(self, factor: f64) -> Self {
        let factor = Double::new(factor);
        Self {
            re: self.re * factor,
            im: self.im * factor,
        }
    }
}

impl Add for Wide {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            re: self.re + other.re,
            im: self.im + other.im,
        }
    }
}

impl Neg for Wide {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self {
            re: -self.re,
            im: -self.im,
        }
    }
}

impl Sub for Wide {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Wide {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self {
            re: self.re * other.re - self.im * other.im,
            im: self.re * other.im + self.im * other.re,
        }
    }
}
