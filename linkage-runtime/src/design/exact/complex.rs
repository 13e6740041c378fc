//! Complex numbers over plain numbers, over double-double ones, and over those of 77 digits.

use super::ball::Real;
use super::double::Double;
use super::long::Long;
use core::ops::{Add, Mul, Neg, Sub};

/// A complex number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Complex<R = f64> {
    pub(super) re: R,
    pub(super) im: R,
}

pub(super) const ZERO: Complex = Complex::new(0.0, 0.0);
pub(super) const ONE: Complex = Complex::new(1.0, 0.0);

/// What polynomials are evaluated in.
pub(super) trait Ring:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
}

impl<T> Ring for T where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T> + Neg<Output = T>
{
}

impl<R> Complex<R> {
    pub(super) const fn new(re: R, im: R) -> Self {
        Self { re, im }
    }
}

impl<R: Neg<Output = R>> Complex<R> {
    #[inline(always)]
    pub(super) fn conjugate(self) -> Self {
        Self::new(self.re, -self.im)
    }
}

impl Complex {
    pub(super) fn polar(angle: f64) -> Self {
        Self::new(angle.cos(), angle.sin())
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

    pub(super) fn size(self) -> f64 {
        self.re.hypot(self.im)
    }

    /// From -pi to pi.
    pub(super) fn angle(self) -> f64 {
        self.im.atan2(self.re)
    }

    #[inline(always)]
    pub(super) fn inverse(self) -> Self {
        self.conjugate().scaled(1.0 / self.square())
    }

    pub(super) fn root(self) -> Self {
        let half = Self::polar(0.5 * self.angle());
        half.scaled(self.size().sqrt())
    }

    pub(super) fn wide(self) -> Complex<Double> {
        Complex::new(self.re.into(), self.im.into())
    }

    /// Of a finite number.
    pub(super) fn long(self) -> Complex<Long> {
        Complex::new(Long::of(self.re), Long::of(self.im))
    }
}

impl Complex<Double> {
    pub(super) fn narrow(self) -> Complex {
        Complex::new(self.re.high, self.im.high)
    }
}

impl Complex<Long> {
    pub(super) fn rounded(self) -> Complex {
        Complex::new(self.re.narrow(), self.im.narrow())
    }

    pub(super) fn reciprocal(self) -> Self {
        let square = (self.re * self.re + self.im * self.im).inverse();
        Self::new(self.re * square, -(self.im * square))
    }
}

impl<R: From<f64>> From<f64> for Complex<R> {
    fn from(number: f64) -> Self {
        Self::new(number.into(), 0.0.into())
    }
}

impl From<Complex> for Complex<Double> {
    fn from(number: Complex) -> Self {
        number.wide()
    }
}

impl From<[f64; 2]> for Complex {
    fn from([re, im]: [f64; 2]) -> Self {
        Self::new(re, im)
    }
}

impl From<Complex> for [f64; 2] {
    fn from(number: Complex) -> Self {
        [number.re, number.im]
    }
}

impl<R: Add<Output = R>> Add for Complex<R> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::new(self.re + other.re, self.im + other.im)
    }
}

impl<R: Sub<Output = R>> Sub for Complex<R> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::new(self.re - other.re, self.im - other.im)
    }
}

impl<R: Ring> Mul for Complex<R> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self::new(
            self.re * other.re - self.im * other.im,
            self.re * other.im + self.im * other.re,
        )
    }
}

impl<R: Neg<Output = R>> Neg for Complex<R> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.re, -self.im)
    }
}
