//! Plane vectors as complex numbers.

use core::ops::{Add, Mul, Neg, Sub};

use linkage_core::Scalar;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Complex(pub(super) f64, pub(super) f64);

pub(super) const I: Complex = Complex(0.0, 1.0);

impl Complex {
    /// The direction at an angle.
    pub(super) fn direction(angle: f64) -> Self {
        let (sin, cos) = Scalar::sin_cos(angle);
        Self(cos, sin)
    }

    pub(super) fn conjugate(self) -> Self {
        Self(self.0, -self.1)
    }

    pub(super) fn length(self) -> f64 {
        Scalar::hypot(self.0, self.1)
    }

    /// `conj(self) other`: along this one, and across to its left.
    pub(super) fn seen(self, other: Self) -> Self {
        self.conjugate() * other
    }

    pub(super) fn point(self) -> [f64; 2] {
        [self.0, self.1]
    }
}

impl Add for Complex {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0, self.1 + other.1)
    }
}

impl Sub for Complex {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Complex {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

impl Mul for Complex {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self(
            self.0 * other.0 - self.1 * other.1,
            self.0 * other.1 + self.1 * other.0,
        )
    }
}

impl Mul<Complex> for f64 {
    type Output = Complex;

    fn mul(self, other: Complex) -> Complex {
        Complex(self * other.0, self * other.1)
    }
}
