//! Complex numbers over any real numbers that add and multiply: plain ones, double-double ones, and
//! longer ones.
//!
//! `num-complex` is not used: it divides by the squared absolute value where this type multiplies
//! by its inverse, which would change last digits, and it would bring two more crates, one of them
//! with a build script, into every build of the macro.

use super::double_double::DoubleDouble;
use core::ops::{Add, AddAssign, Mul, Neg, Sub};

/// Numbers that polynomials can be evaluated in.
pub trait Ring:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
}

impl<T> Ring for T where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T> + Neg<Output = T>
{
}

/// A complex number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Complex<R = f64> {
    /// The real part.
    pub re: R,
    /// The imaginary part.
    pub im: R,
}

pub const ZERO: Complex = Complex::new(0.0, 0.0);
pub const ONE: Complex = Complex::new(1.0, 0.0);
pub const I: Complex = Complex::new(0.0, 1.0);

impl<R> Complex<R> {
    pub const fn new(re: R, im: R) -> Self {
        Self { re, im }
    }

    /// Converts both parts.
    #[inline(always)]
    pub fn map<S>(self, convert: impl Fn(R) -> S) -> Complex<S> {
        Complex::new(convert(self.re), convert(self.im))
    }
}

impl<R: Neg<Output = R>> Complex<R> {
    #[inline(always)]
    pub fn conjugate(self) -> Self {
        Self::new(self.re, -self.im)
    }
}

impl<R: Copy + Mul<Output = R>> Complex<R> {
    #[inline(always)]
    pub fn scaled(self, factor: R) -> Self {
        Self::new(self.re * factor, self.im * factor)
    }
}

impl Complex {
    /// Returns the square of the absolute value.
    #[inline(always)]
    pub fn square(self) -> f64 {
        self.re * self.re + self.im * self.im
    }

    #[inline(always)]
    pub fn inverse(self) -> Self {
        self.conjugate().scaled(1.0 / self.square())
    }

    /// Returns the same number with room for 32 digits.
    #[inline(always)]
    pub fn wide(self) -> Complex<DoubleDouble> {
        self.map(DoubleDouble::from)
    }
}

#[cfg(feature = "std")]
impl Complex {
    /// Returns the direction at an angle (rad).
    pub fn polar(angle: f64) -> Self {
        Self::new(angle.cos(), angle.sin())
    }

    /// Returns the absolute value.
    pub fn size(self) -> f64 {
        self.re.hypot(self.im)
    }

    /// Returns the angle, from -pi to pi.
    pub fn angle(self) -> f64 {
        self.im.atan2(self.re)
    }

    /// Returns the square root on the right side of the imaginary axis.
    pub fn root(self) -> Self {
        let half = Self::polar(0.5 * self.angle());
        half.scaled(self.size().sqrt())
    }
}

impl Complex<DoubleDouble> {
    /// Returns the nearest number of 16 digits.
    #[inline(always)]
    pub fn narrow(self) -> Complex {
        self.map(|part| part.high)
    }

    /// Returns the inverse, by a Newton step from that of 16 digits.
    pub fn inverse(self) -> Self {
        let rough = self.narrow().inverse().wide();
        rough + rough * (ONE.wide() - self * rough)
    }
}

impl<R: From<f64>> From<f64> for Complex<R> {
    fn from(number: f64) -> Self {
        Self::new(number.into(), 0.0.into())
    }
}

impl From<Complex> for Complex<DoubleDouble> {
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

impl<R: Copy + Add<Output = R>> AddAssign for Complex<R> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
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

impl Mul<Complex> for f64 {
    type Output = Complex;

    #[inline(always)]
    fn mul(self, other: Complex) -> Complex {
        other.scaled(self)
    }
}
