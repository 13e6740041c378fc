//! Plane vectors as complex numbers, with the elementary functions of scalars.

use linkage_core::Scalar;
use linkage_core::numeric::complex::Complex;

/// Returns the unit vector at an angle (rad).
pub(super) fn direction(angle: f64) -> Complex {
    let (sin, cos) = Scalar::sin_cos(angle);
    Complex::new(cos, sin)
}

pub(super) fn length(vector: Complex) -> f64 {
    Scalar::hypot(vector.re, vector.im)
}

/// Returns the components of a vector along another one and across to its left, times the length of
/// that one.
pub(super) fn relative(to: Complex, vector: Complex) -> Complex {
    to.conjugate() * vector
}
