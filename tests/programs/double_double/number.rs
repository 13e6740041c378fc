//! A double-double number as a [`Scalar`]: the unevaluated sum of two `f64`, about 31 digits.
//!
//! The arithmetic is that of the crate `xprec`. Neither its type nor the trait is from here, so a
//! newtype stands between them; any other number type is adapted in the same way.

mod decimal;

use linkage::Scalar;
use std::f64::consts;
use std::ops::{Add, Div, Mul, Neg, Sub};
use xprec::Df64;

/// A double-double number.
///
/// Every operation and function is accurate to 1e-31 relative, as long as magnitudes stay between
/// about 1e-130 and 1e150: the low half of a product must not underflow. Sine, cosine and tangent
/// are NaN beyond 3e9 radians. What overflows, and division by zero, is NaN and not infinite.
///
/// Products need the fused multiply-add. A build that may not assume it in hardware calls a library
/// function for each: `RUSTFLAGS="-C target-cpu=native"` doubles the speed.
///
/// Doubles become double-doubles as they are: 0.1 is the double nearest to a tenth. A tenth to all
/// digits is `"0.1".parse()`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct DoubleDouble(pub(crate) Df64);

impl DoubleDouble {
    /// The number pi.
    pub(crate) const PI: Self = Self(Df64::new_full(consts::PI, 1.224_646_799_147_353_2e-16));

    /// Bound of an operation's relative error: what is closer than some of these is equal.
    const EPSILON: f64 = f64::EPSILON * f64::EPSILON;

    /// The largest angle for which `xprec` finds the quadrant.
    const LARGEST_ANGLE: f64 = 3e9;

    const NAN: Self = Self(Df64::NAN);

    /// The double next to the number. All decisions are made by it: the low half is too small to
    /// change a sign.
    fn high(self) -> f64 {
        self.0.hi()
    }
}

macro_rules! operators {
    ($($op:ident $method:ident),*) => {
        $(impl $op for DoubleDouble {
            type Output = Self;

            #[inline]
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        })*
    };
}

operators!(Add add, Sub sub, Mul mul, Div div);

impl Neg for DoubleDouble {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Scalar for DoubleDouble {
    const LANES: usize = 1;
    const SLACK: f64 = 8.0 * Self::EPSILON;

    fn from_f64(x: f64) -> Self {
        Self(Df64::from(x))
    }

    fn lane(self, _: usize) -> f64 {
        self.high()
    }

    fn from_lanes(mut f: impl FnMut(usize) -> f64) -> Self {
        Self::from_f64(f(0))
    }

    fn abs(self) -> Self {
        Self(self.0.abs())
    }

    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    fn tan(self) -> Self {
        let (sin, cos) = self.sin_cos();
        sin / cos
    }

    // By the arc tangent, which keeps its digits near the ends, too.
    fn asin(self) -> Self {
        let one = Self::from_f64(1.0);
        self.atan2(((one - self) * (one + self)).sqrt())
    }

    fn acos(self) -> Self {
        let one = Self::from_f64(1.0);
        ((one - self) * (one + self)).sqrt().atan2(self)
    }

    fn atan(self) -> Self {
        self.atan2(Self::from_f64(1.0))
    }

    fn sin_cos(self) -> (Self, Self) {
        if self.high().abs() <= Self::LARGEST_ANGLE {
            let (sin, cos) = self.0.sin_cos();
            (Self(sin), Self(cos))
        } else {
            (Self::NAN, Self::NAN)
        }
    }

    fn atan2(self, x: Self) -> Self {
        // Scaled, and the smaller divided by the larger: no quotient can overflow.
        let scale = self.abs().max(x.abs()).inverse_scale();
        let (y, x) = ((self * scale).0, (x * scale).0);
        let angle = if x.hi().abs() < y.hi().abs() {
            (Self::PI.0 * 0.5).copysign(y) - (x / y).atan()
        } else if x.hi() < 0.0 {
            Self::PI.0.copysign(y) + (y / x).atan()
        } else if y.hi() == 0.0 {
            y
        } else {
            (y / x).atan()
        };
        Self(angle)
    }

    // A power of two scales both halves alike, so that of the high half will do.
    fn inverse_scale(self) -> Self {
        Self::from_f64(self.high().inverse_scale())
    }

    fn root_with<const FUSED: bool>(self, slack: Self, size: Self) -> Self {
        let root = if self.high() > 0.0 {
            self.sqrt()
        } else {
            Self::from_f64(0.0)
        };
        Self::select(slack * size + self, root, Self::NAN)
    }

    fn angle_near(y: Self, x: Self, guide: Self) -> Self {
        let angle = y.atan2(x);
        let turns = ((guide - angle).high() / consts::TAU).round_ties_even();
        Self(angle.0 + Self::PI.0 * (2.0 * turns))
    }

    fn select(s: Self, a: Self, b: Self) -> Self {
        if s.high() >= 0.0 {
            a
        } else if s.high() < 0.0 {
            b
        } else {
            Self::NAN
        }
    }
}
