//! Dual numbers of num-dual.

use super::operators::operators;
use super::{Float, Scalar};
use num_dual::DualNum;

/// A number with its derivatives: a dual number of num-dual as a [`Scalar`].
///
/// Decisions (which side of zero, how many turns) are made by the real part, and the derivatives of
/// what was chosen are kept.
///
/// ```
/// use linkage_core::{Dual, Scalar};
/// use num_dual::Dual64;
///
/// // d/dx sqrt(x^2 - 1) = x / sqrt(x^2 - 1)
/// let x = Dual(Dual64::new(2.0, 1.0));
/// let square = x * x;
/// let y = (square - Dual::from_f64(1.0)).root_with::<false>(square.slack(), Dual::from_f64(1.0));
/// assert!((y.0.eps - 2.0 / 3.0_f64.sqrt()).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<D>(
    /// The dual number.
    pub D,
);

operators!(Dual, DualNum<Primitive = f64> + Copy);

impl<D: DualNum<Primitive = f64> + Copy> Dual<D> {
    /// NaN in the real part and in every derivative.
    #[inline(always)]
    fn nowhere(self) -> Self {
        Self(self.0 * f64::NAN)
    }

    /// The angle of a vector, its derivatives taken from the quotient that is at most 1.
    #[inline(always)]
    fn angle(y: D, x: D) -> D {
        let angle = y.re().atan2(x.re());
        let quotient = if x.re().abs() >= y.re().abs() {
            (y / x).atan()
        } else {
            -(x / y).atan()
        };
        quotient + (angle - quotient.re())
    }
}

macro_rules! functions {
    ($($name:ident)*) => {
        $(
            #[inline(always)]
            fn $name(self) -> Self {
                Self(DualNum::$name(&self.0))
            }
        )*
    };
}

impl<D: DualNum<Primitive = f64> + Copy> Scalar for Dual<D> {
    const LANES: usize = 1;

    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        Self(D::from(x))
    }

    #[inline(always)]
    fn lane(self, _: usize) -> f64 {
        self.0.re()
    }

    #[inline(always)]
    fn from_lanes(mut f: impl FnMut(usize) -> f64) -> Self {
        Self::from_f64(f(0))
    }

    functions!(sqrt tan asin acos atan);

    #[inline(always)]
    fn abs(self) -> Self {
        Self::select(self, self, -self)
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.0.sin_cos();
        (Self(sin), Self(cos))
    }

    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        Self(Self::angle(self.0, x.0))
    }

    #[inline(always)]
    fn inverse_scale(self) -> Self {
        Self::from_f64(self.0.re().inverse_scale())
    }

    /// At the dead point itself the value is 0 and the derivatives are not finite.
    #[inline(always)]
    fn root_with<const FUSED: bool>(self, slack: Self, size: Self) -> Self {
        let [q, slack, size] = [self, slack, size].map(|number| number.0.re());
        let root = q.root_with::<FUSED>(slack, size);
        if root > 0.0 {
            Self(self.0.sqrt())
        } else if root == 0.0 {
            Self((self.0 - q).sqrt())
        } else {
            self.nowhere()
        }
    }

    #[inline(always)]
    fn angle_near(y: Self, x: Self, guide: Self) -> Self {
        let angle = Self::angle(y.0, x.0);
        let turns = ((guide.0.re() - angle.re()) * f64::TURNS + f64::ROUND) - f64::ROUND;
        Self((angle + turns * f64::TURN_LOW) + turns * f64::TURN_HIGH)
    }

    #[inline(always)]
    fn select(s: Self, a: Self, b: Self) -> Self {
        let sign = s.0.re();
        if sign >= 0.0 {
            a
        } else if sign < 0.0 {
            b
        } else {
            a.nowhere()
        }
    }
}

impl<D: core::fmt::Display> core::fmt::Display for Dual<D> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        self.0.fmt(f)
    }
}
