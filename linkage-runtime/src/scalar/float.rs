//! `f64` and `f32`.

use super::Scalar;
use crate::math;
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

macro_rules! scalar {
    ($float:ident, $bits:ident, $functions:ident) => {
        impl Scalar for $float {
            const LANES: usize = 1;

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
                math::$functions::sin_cos(self)
            }

            #[inline(always)]
            fn atan2(self, x: Self) -> Self {
                math::$functions::atan2(self, x)
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
            fn root(self, scale: Self) -> Self {
                let slack = 8.0 * <$float>::EPSILON * <$float>::abs(scale);
                let positive = select_unpredictable(self > 0.0, self, 0.0);
                // The product is zero unless the scale is infinite, when nothing is forgiven.
                let close = self + slack >= slack * 0.0;
                math::$functions::sqrt(select_unpredictable(close, positive, self))
            }

            #[inline(always)]
            fn angle_near(y: Self, x: Self, guide: Self) -> Self {
                let angle = math::$functions::atan2(y, x);
                let turns = ((guide - angle) * Self::TURNS + Self::ROUND) - Self::ROUND;
                (angle + turns * Self::TURN_LOW) + turns * Self::TURN_HIGH
            }

            #[inline(always)]
            fn select(s: Self, a: Self, b: Self) -> Self {
                let chosen = select_unpredictable(s >= 0.0, a, b);
                select_unpredictable(s.is_nan(), s, chosen)
            }

            #[inline(always)]
            fn min(self, other: Self) -> Self {
                let smaller = select_unpredictable(self < other, self, other);
                select_unpredictable(self.is_nan(), self, smaller)
            }

            #[inline(always)]
            fn max(self, other: Self) -> Self {
                let larger = select_unpredictable(self > other, self, other);
                select_unpredictable(self.is_nan(), self, larger)
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
