//! Complex numbers, as far as tracking paths needs them.

use core::ops::{Add, AddAssign, Mul, Neg, Sub};

/// A complex number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Complex {
    pub(super) re: f64,
    pub(super) im: f64,
}

pub(super) const ZERO: Complex = Complex::new(0.0, 0.0);
pub(super) const ONE: Complex = Complex::new(1.0, 0.0);

impl Complex {
    pub(super) const fn new(re: f64, im: f64) -> Self {
        Self { re, im }
    }

    #[inline(always)]
    pub(super) fn conjugate(self) -> Self {
        Self::new(self.re, -self.im)
    }

    #[inline(always)]
    pub(super) fn scaled(self, factor: f64) -> Self {
        Self::new(self.re * factor, self.im * factor)
    }

    /// Square of the absolute value.
    #[inline(always)]
    pub(super) fn square(self) -> f64 {
        self.re * self.re + self.im * self.im
    }

    #[inline(always)]
    pub(super) fn inverse(self) -> Self {
        self.conjugate().scaled(1.0 / self.square())
    }
}

impl Add for Complex {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::new(self.re + other.re, self.im + other.im)
    }
}

impl AddAssign for Complex {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Sub for Complex {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::new(self.re - other.re, self.im - other.im)
    }
}

impl Mul for Complex {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self::new(
            self.re * other.re - self.im * other.im,
            self.re * other.im + self.im * other.re,
        )
    }
}

impl Neg for Complex {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.re, -self.im)
    }
}

/// Square root to two digits, which is enough for choosing step sizes; it needs no library.
pub(super) fn rough_root(square: f64) -> f64 {
    const HALF_BIAS: u64 = 0x1ff8_0000_0000_0000;
    let guess = f64::from_bits((square.to_bits() >> 1) + HALF_BIAS);
    0.5 * (guess + square / guess)
}
