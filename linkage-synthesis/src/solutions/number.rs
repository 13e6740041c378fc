//! Numbers for the evaluation of equations, and numbers with their derivatives with respect to all
//! unknowns.

use core::ops::{Add, Mul, Neg, Sub};
use linkage_core::numeric::complex::Ring;

/// A number that equations are evaluated in: real, complex, with derivatives, with more digits,
/// with bounds of its error.
pub trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self> + From<f64>
{
}

impl<T: Ring + From<f64>> Number for T {}

/// A number with its derivatives.
#[derive(Clone, Copy)]
pub(super) struct Slopes<T, const N: usize> {
    pub(super) value: T,
    pub(super) by: [T; N],
}

impl<T: Number, const N: usize> Slopes<T, N> {
    /// An unknown.
    pub(super) fn unknown(value: T, index: usize) -> Self {
        let by = core::array::from_fn(|i| T::from(f64::from(u8::from(i == index))));
        Self { value, by }
    }
}

impl<T: Number, const N: usize> From<f64> for Slopes<T, N> {
    fn from(number: f64) -> Self {
        Self {
            value: number.into(),
            by: [T::from(0.0); N],
        }
    }
}

impl<T: Number, const N: usize> Add for Slopes<T, N> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            by: core::array::from_fn(|i| self.by[i] + other.by[i]),
        }
    }
}

impl<T: Number, const N: usize> Sub for Slopes<T, N> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self {
            value: self.value - other.value,
            by: core::array::from_fn(|i| self.by[i] - other.by[i]),
        }
    }
}

impl<T: Number, const N: usize> Mul for Slopes<T, N> {
    type Output = Self;

    #[expect(clippy::suspicious_arithmetic_impl, reason = "the product rule")]
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            by: core::array::from_fn(|i| self.by[i] * other.value + self.value * other.by[i]),
        }
    }
}

impl<T: Number, const N: usize> Neg for Slopes<T, N> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            by: self.by.map(|by| -by),
        }
    }
}
