//! Values of operations on numbers, where they take more than an expression.

use std::f64::consts::TAU;

/// Roundoffs of the scale by which a discriminant may be negative at the dead point: the rounding
/// of its terms.
pub(super) const DEAD_POINT: f64 = 8.0 * f64::EPSILON;

/// Added and taken away again, it leaves whole numbers: the numbers beside it have no digits behind
/// the point.
pub(super) const WHOLE: f64 = 1.5 / f64::EPSILON;

pub(super) fn sign(a: f64) -> f64 {
    if a.is_nan() {
        a
    } else if a >= 0.0 {
        1.0
    } else {
        -1.0
    }
}

pub(super) fn inverse_scale(x: f64) -> f64 {
    if x == 0.0 || !x.is_finite() {
        return 1.0;
    }
    // The exponent alone, mirrored, and kept within what normal numbers have.
    let exponent = (x.to_bits() >> 52) & 0x7ff;
    f64::from_bits((2046 - exponent.clamp(1, 2045)) << 52)
}

/// Returns the operand that a minimum or a maximum takes. The standard library may take either of
/// two zeros, depending on the machine; this is the choice of generated code.
pub(super) fn one_of(a: f64, b: f64, first: bool, second: bool) -> f64 {
    if a.is_nan() || b.is_nan() {
        f64::NAN
    } else if first {
        a
    } else if second {
        b
    } else {
        // Equal: they differ in the sign at most.
        f64::from_bits(a.to_bits() | b.to_bits())
    }
}

pub(super) fn root(q: f64, slack: f64, size: f64) -> f64 {
    match slack * size + q >= 0.0 {
        // Not the root of -0.
        true if q > 0.0 => q.sqrt(),
        true => 0.0,
        false => f64::NAN,
    }
}

pub(super) fn angle_near(y: f64, x: f64, guide: f64) -> f64 {
    let angle = libm::atan2(y, x);
    angle + TAU * ((guide - angle) / TAU).round_ties_even()
}

pub(super) fn select(s: f64, a: f64, b: f64) -> f64 {
    if s.is_nan() {
        s
    } else if s >= 0.0 {
        a
    } else {
        b
    }
}
