//! `f64` and `f32`.

use super::{FUSED, Scalar};
use crate::certificate::{self, ROUNDINGS};
use crate::{elementary, math};
use core::hint::select_unpredictable;

/// A plain floating-point number: `f64` or `f32`, also as the element of lanes.
pub trait Float: Scalar {
    /// Distance from 1 to the next number.
    const EPSILON: Self;
    /// Adding and subtracting this number rounds to an integer (to even at a tie).
    const ROUND: Self;
    /// Turns per radian.
    const TURNS: Self;
    /// The leading bits of a turn in radians, few enough for exact products with turn counts.
    const TURN_HIGH: Self;
    /// A turn in radians less [`TURN_HIGH`](Self::TURN_HIGH).
    const TURN_LOW: Self;
}

impl Float for f64 {
    const EPSILON: f64 = f64::EPSILON;
    const ROUND: f64 = 6_755_399_441_055_744.0;
    const TURNS: f64 = 1.0 / core::f64::consts::TAU;
    // 31 bits: products are exact for up to 2^22 turns.
    const TURN_HIGH: f64 = f64::from_bits(0x4019_21FB_5440_0000);
    const TURN_LOW: f64 = 2.430_840_202_602_477e-10;
}

impl Float for f32 {
    const EPSILON: f32 = f32::EPSILON;
    const ROUND: f32 = 12_582_912.0;
    const TURNS: f32 = 1.0 / core::f32::consts::TAU;
    // 8 bits: products are exact for up to 2^16 turns.
    const TURN_HIGH: f32 = f32::from_bits(0x40C9_0000);
    const TURN_LOW: f32 = 1.935_307_2e-3;
}

// Choices are integer operations, or a minimum or maximum, which are instructions of their own: two
// other choices on one comparison of floats become a branch, and comparisons of neighbouring
// numbers are made one, so that they share it.
macro_rules! scalar {
    ($float:ident, $bits:ident, $functions:ident) => {
        impl Scalar for $float {
            const LANES: usize = 1;
            const VECTORISES: bool = true;
            // Single precision rounds more coarsely than tables are wrong.
            const CORRECTION_LIMIT: f64 = if $bits::BITS == 64 {
                certificate::CORRECTION_LIMIT
            } else {
                certificate::SINGLE_CORRECTION_LIMIT
            };
            const LAST_CORRECTION: f64 = if $bits::BITS == 64 {
                certificate::LAST_CORRECTION
            } else {
                certificate::SINGLE_LAST_CORRECTION
            };
            const SLACK: f64 = ROUNDINGS * <$float>::EPSILON as f64;
            const REFINES: bool = false;

            #[inline(always)]
            fn from_f64(x: f64) -> Self {
                x as $float
            }

            #[inline(always)]
            fn lane(self, _: usize) -> f64 {
                f64::from(self)
            }

            #[inline(always)]
            fn from_lanes(mut f: impl FnMut(usize) -> f64) -> Self {
                f(0) as $float
            }

            #[inline(always)]
            fn abs(self) -> Self {
                <$float>::abs(self)
            }

            scalar!(@functions $functions, sqrt tan asin acos atan);

            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                elementary::$functions::sin_cos::<FUSED, false>(self)
            }

            #[inline(always)]
            fn sin_cos_with<const FUSED: bool>(self) -> (Self, Self) {
                elementary::$functions::sin_cos::<FUSED, false>(self)
            }

            #[inline(always)]
            fn sin_cos_in_rows<const FUSED: bool, const ROWS: bool>(self) -> (Self, Self) {
                elementary::$functions::sin_cos::<FUSED, ROWS>(self)
            }

            #[inline(always)]
            fn sin_cos_shortest<const FUSED: bool, const ROWS: bool>(self) -> (Self, Self) {
                elementary::$functions::sin_cos_shortest::<FUSED, ROWS>(self)
            }

            #[inline(always)]
            fn mul_add<const FUSED: bool>(self, factor: Self, term: Self) -> Self {
                elementary::$functions::mul_add::<FUSED>(self, factor, term)
            }

            #[inline(always)]
            fn atan2(self, x: Self) -> Self {
                elementary::$functions::atan2::<FUSED>(self, x)
            }

            #[inline(always)]
            fn atan2_with<const FUSED: bool>(self, x: Self) -> Self {
                elementary::$functions::atan2::<FUSED>(self, x)
            }

            #[inline(always)]
            fn inverse_scale(self) -> Self {
                // All in integers: mixed with comparisons of floats it would become branches.
                const ONE: $bits = <$float>::to_bits(1.0);
                const LEAST: $bits = <$float>::to_bits(<$float>::MIN_POSITIVE);
                const INFINITE: $bits = <$float>::to_bits(<$float>::INFINITY);
                // The largest exponent whose reciprocal is a normal number.
                const MOST: $bits = 2 * ONE - LEAST;
                let size = self.to_bits() & <$bits>::MAX >> 1;
                let exponent = (size & INFINITE).max(LEAST).min(MOST);
                let exponent = select_unpredictable(size >= INFINITE, ONE, exponent);
                let exponent = select_unpredictable(size == 0, ONE, exponent);
                <$float>::from_bits(2 * ONE - exponent)
            }

            #[inline(always)]
            fn slack(self) -> Self {
                <$float>::abs(self) * Self::SLACK as $float + 0.0 * self
            }

            #[inline(always)]
            fn root_with<const FUSED: bool>(self, slack: Self, size: Self) -> Self {
                let reserve = elementary::$functions::mul_add::<FUSED>(slack, size, self);
                // The root waits for a maximum only, one instruction, not for the test: -0 becomes
                // 0. NaN has no reserve.
                let root = math::$functions::sqrt(select_unpredictable(self > 0.0, self, 0.0));
                // What is chosen is a constant: a root within a choice may be passed by with a
                // branch, or divisors wait for each other.
                let nan = select_unpredictable(reserve >= 0.0, 0.0, <$float>::NAN);
                <$float>::from_bits(root.to_bits() | nan.to_bits())
            }

            #[inline(always)]
            fn angle_near(y: Self, x: Self, guide: Self) -> Self {
                Self::angle_near_with::<FUSED>(y, x, guide)
            }

            #[inline(always)]
            fn angle_near_with<const FUSED: bool>(y: Self, x: Self, guide: Self) -> Self {
                let angle = elementary::$functions::atan2::<FUSED>(y, x);
                let turns = ((guide - angle) * Self::TURNS + Self::ROUND) - Self::ROUND;
                (angle + turns * Self::TURN_LOW) + turns * Self::TURN_HIGH
            }

            #[inline(always)]
            fn whole(self) -> Self {
                (self + Self::ROUND) - Self::ROUND
            }

            #[inline(always)]
            fn select(s: Self, a: Self, b: Self) -> Self {
                // The sign bit, but not that of -0. A choice by masks is seen through and may
                // become a branch around a load.
                let negative = s.to_bits() & s.to_bits().wrapping_sub(1);
                let [a, b] = [a, b].map(<$float>::to_bits);
                let chosen = select_unpredictable(negative.cast_signed() < 0, b, a);
                // Zero, or NaN.
                let nan = select_unpredictable(s < 0.0, 0.0, s);
                let nan = <$float>::abs(select_unpredictable(nan > 0.0, 0.0, nan));
                <$float>::from_bits(chosen | nan.to_bits())
            }

            #[inline(always)]
            fn unless_negative(s: Self, a: Self) -> Self {
                // A choice beside 0 stays in the registers of floats: `a` would have to leave and
                // enter them again.
                let nan = select_unpredictable(s >= 0.0, 0.0, <$float>::NAN);
                <$float>::from_bits(a.to_bits() | nan.to_bits())
            }

            #[inline(always)]
            fn min(self, other: Self) -> Self {
                // Equal unless one is NaN: then one of them is.
                let smaller = select_unpredictable(self < other, self, other);
                let or = select_unpredictable(other < self, other, self);
                <$float>::from_bits(smaller.to_bits() | or.to_bits())
            }

            #[inline(always)]
            fn max(self, other: Self) -> Self {
                let larger = select_unpredictable(self > other, self, other);
                let or = select_unpredictable(other > self, other, self);
                <$float>::from_bits(larger.to_bits() | or.to_bits())
            }
        }
    };
    (@functions $functions:ident, $($name:ident)*) => {
        $(
            #[inline(always)]
            fn $name(self) -> Self {
                math::$functions::$name(self)
            }
        )*
    };
}

scalar!(f64, u64, double);
scalar!(f32, u32, single);
