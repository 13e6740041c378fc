//! Discs of complex numbers: arithmetic that holds all results, whatever the rounding.
//!
//! Rounding is to the nearest number; its errors are bounded by twice their largest values, and so
//! are those of the radii.

use super::long::Long;
use super::real::Real;
use core::ops::{Add, Mul, Neg, Sub};
use linkage_core::numeric::complex::{Complex, ZERO};
use linkage_core::numeric::double_double::DoubleDouble;

/// All numbers that are not further from the middle than the radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ball<R = f64> {
    pub(super) middle: Complex<R>,
    pub(super) radius: f64,
}

/// A radius is a sum of a few products: rounding makes it smaller by less than this.
const AMPLE: f64 = 1.0 + 16.0 * f64::EPSILON;

impl<R> Ball<R> {
    pub(super) const fn exact(middle: Complex<R>) -> Self {
        Self {
            middle,
            radius: 0.0,
        }
    }

    pub(super) const fn new(middle: Complex<R>, radius: f64) -> Self {
        Self { middle, radius }
    }
}

impl<R: Real> Ball<R> {
    pub(super) fn widened(self, by: f64) -> Self {
        Self::new(self.middle, (self.radius + by) * AMPLE)
    }

    pub(super) fn conjugate(self) -> Self {
        Self::new(self.middle.conjugate(), self.radius)
    }

    /// A bound of the absolute values.
    pub(super) fn size(self) -> f64 {
        (taxi(self.middle) + self.radius) * AMPLE
    }

    pub(super) fn is_zero(self) -> bool {
        taxi(self.middle) == 0.0 && self.radius == 0.0
    }
}

impl Ball {
    pub(super) const ZERO: Self = Self::exact(ZERO);

    /// A number of more digits.
    pub(super) fn from_wide(number: Complex<DoubleDouble>) -> Self {
        let rest = number.re.low.abs() + number.im.low.abs();
        Self::new(number.narrow(), rest * AMPLE)
    }

    /// Returns whether no number is in both.
    pub(super) fn is_apart_from(self, other: Self) -> bool {
        let way = self.middle - other.middle;
        // A distance of two rounded numbers, which is wrong by less than this part of it.
        let distance = way.re.abs().max(way.im.abs()) * (1.0 - 4.0 * f64::EPSILON);
        distance > (self.radius + other.radius) * AMPLE
    }

    /// `None` if 0 is among the numbers.
    pub(super) fn inverse(self) -> Option<Self> {
        let least = self.middle.size() * (1.0 - 4.0 * f64::EPSILON) - self.radius * AMPLE;
        if least.is_nan() || least <= 0.0 {
            return None;
        }
        let middle = self.middle.inverse();
        let size = taxi(middle);
        // |1/(m + r) - 1/m| = r / (|m| |m + r|)
        let radius = size * self.radius / least + 8.0 * f64::EPSILON * size;
        Some(Self::new(middle, radius * AMPLE + f64::MIN_POSITIVE))
    }
}

impl Ball<Long> {
    /// With the digits of plain numbers.
    pub(super) fn narrow(self) -> Ball {
        let middle = self.middle.map(Long::narrow);
        let rest = taxi(self.middle - middle.map(Long::exact));
        Ball::new(middle, (self.radius + rest) * AMPLE)
    }

    /// Returns whether no number is in both.
    pub(super) fn is_far_from(self, other: Self) -> bool {
        let way = Ball::exact(self.middle - other.middle).narrow();
        way.is_apart_from(Ball::new(ZERO, (self.radius + other.radius) * AMPLE))
    }
}

impl<R: Real> From<Complex> for Ball<R> {
    fn from(number: Complex) -> Self {
        let finite = number.re.is_finite() && number.im.is_finite();
        let radius = if finite { 0.0 } else { f64::NAN };
        Self::new(
            Complex::new(R::exact(number.re), R::exact(number.im)),
            radius,
        )
    }
}

impl From<Complex<DoubleDouble>> for Ball<Long> {
    fn from(number: Complex<DoubleDouble>) -> Self {
        Self::exact(Complex::new(number.re.into(), number.im.into()))
    }
}

impl<R: Real> From<f64> for Ball<R> {
    fn from(number: f64) -> Self {
        Complex::new(number, 0.0).into()
    }
}

/// A bound of the absolute value that needs no root.
fn taxi<R: Real>(number: Complex<R>) -> f64 {
    number.re.bound() + number.im.bound()
}

/// Bounds of absolute values, of sums as of differences: how large the terms of a polynomial are.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bound(pub(super) f64);

impl Bound {
    pub(super) fn from_wide(number: Complex<DoubleDouble>) -> Self {
        Self(taxi(number.narrow()) * AMPLE)
    }

    /// The value of a polynomial whose terms have these bounds, when it has been computed with
    /// `DoubleDouble`: fewer than a hundred operations, each wrong by a few parts in 2^106.
    pub(super) fn around(self, value: Complex<DoubleDouble>) -> Ball {
        const WRONG: f64 = 1.0 / (1_u128 << 96) as f64;
        Ball::from_wide(value).widened(self.0 * WRONG)
    }
}

impl From<Complex> for Bound {
    fn from(number: Complex) -> Self {
        Self(taxi(number) * AMPLE)
    }
}

impl From<f64> for Bound {
    fn from(number: f64) -> Self {
        Self(number.abs())
    }
}

impl Add for Bound {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for Bound {
    type Output = Self;

    #[expect(
        clippy::suspicious_arithmetic_impl,
        reason = "the terms of a difference are as large as those of a sum"
    )]
    fn sub(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Mul for Bound {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl Neg for Bound {
    type Output = Self;

    fn neg(self) -> Self {
        self
    }
}

fn sum<R: Real>(a: Ball<R>, b: Ball<R>, middle: Complex<R>) -> Ball<R> {
    let radius = a.radius + b.radius + R::rounding(taxi(middle));
    Ball::new(middle, radius * AMPLE)
}

impl<R: Real> Add for Ball<R> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        sum(self, other, self.middle + other.middle)
    }
}

impl<R: Real> Sub for Ball<R> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        sum(self, other, self.middle - other.middle)
    }
}

impl<R: Real> Mul for Ball<R> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let (a, b) = (taxi(self.middle), taxi(other.middle));
        let spread = a * other.radius + b * self.radius + self.radius * other.radius;
        let radius = spread + R::rounding(4.0 * a * b);
        // Products may be too small for a rounding error that is a part of them.
        Self::new(
            self.middle * other.middle,
            radius * AMPLE + f64::MIN_POSITIVE,
        )
    }
}

impl<R: Real> Neg for Ball<R> {
    type Output = Self;

    fn neg(self) -> Self {
        Self::new(-self.middle, self.radius)
    }
}
