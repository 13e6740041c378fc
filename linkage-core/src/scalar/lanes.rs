//! SIMD types of simba.

use super::operators::operators;
use super::{Float, Scalar};
use simba::simd::SimdRealField;

/// Several numbers side by side: a SIMD type of simba, such as `WideF64x4` or `AutoF64x4`, as a
/// [`Scalar`].
///
/// ```
/// use linkage_core::{Lanes, Scalar};
/// use simba::simd::AutoF64x4;
///
/// let q = Lanes::<AutoF64x4>::from_lanes(|i| i as f64 - 1.0);
/// let one = Lanes::from_f64(1.0);
/// let root = q.root_with::<false>(one.slack(), one);
/// assert!(root.lane(0).is_nan());
/// assert_eq!((root.lane(1), root.lane(2)), (0.0, 1.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lanes<S>(
    /// The SIMD value.
    pub S,
);

operators!(Lanes, SimdRealField<Element: Float> + Copy);

impl<S: SimdRealField<Element: Float> + Copy> Lanes<S> {
    /// NaN in the lanes where `test` is NaN, `otherwise` in the others.
    #[inline(always)]
    fn unless_nan(test: S, otherwise: S) -> Self {
        Self(otherwise.select(test.simd_eq(test), test))
    }
}

macro_rules! functions {
    ($($name:ident $simd:ident)*) => {
        $(
            #[inline(always)]
            fn $name(self) -> Self {
                Self(self.0.$simd())
            }
        )*
    };
}

impl<S> Scalar for Lanes<S>
where
    S: SimdRealField<Element: Float> + Copy,
{
    const LANES: usize = S::LANES;
    const CORRECTION_LIMIT: f64 = <S::Element as Scalar>::CORRECTION_LIMIT;
    const LAST_CORRECTION: f64 = <S::Element as Scalar>::LAST_CORRECTION;
    const SLACK: f64 = <S::Element as Scalar>::SLACK;
    const REFINES: bool = false;

    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        Self(S::splat(S::Element::from_f64(x)))
    }

    #[inline(always)]
    fn lane(self, index: usize) -> f64 {
        self.0.extract(index).lane(0)
    }

    #[inline(always)]
    fn from_lanes(mut f: impl FnMut(usize) -> f64) -> Self {
        let mut lanes = S::splat(S::Element::from_f64(0.0));
        for index in 0..S::LANES {
            lanes.replace(index, S::Element::from_f64(f(index)));
        }
        Self(lanes)
    }

    functions!(abs simd_abs sqrt simd_sqrt tan simd_tan);
    functions!(asin simd_asin acos simd_acos atan simd_atan);

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.0.simd_sin_cos();
        (Self(sin), Self(cos))
    }

    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        Self(self.0.simd_atan2(x.0))
    }

    #[inline(always)]
    fn inverse_scale(self) -> Self {
        Self(self.0.map_lanes(S::Element::inverse_scale))
    }

    #[inline(always)]
    fn slack(self) -> Self {
        let [part, zero] = [Self::SLACK, 0.0].map(|x| S::splat(S::Element::from_f64(x)));
        Self(self.0.simd_abs() * part + self.0 * zero)
    }

    #[inline(always)]
    fn root_with<const FUSED: bool>(self, slack: Self, size: Self) -> Self {
        let q = self.0;
        let zero = S::splat(S::Element::from_f64(0.0));
        let reserve = slack.mul_add::<FUSED>(size, self).0;
        let root = q.select(q.simd_gt(zero), zero).simd_sqrt();
        let none = S::splat(S::Element::from_f64(f64::NAN));
        Self(root.select(reserve.simd_ge(zero), none))
    }

    #[inline(always)]
    fn angle_near(y: Self, x: Self, guide: Self) -> Self {
        let angle = y.0.simd_atan2(x.0);
        let round = S::splat(S::Element::ROUND);
        let turns = ((guide.0 - angle) * S::splat(S::Element::TURNS) + round) - round;
        let low = turns * S::splat(S::Element::TURN_LOW);
        let high = turns * S::splat(S::Element::TURN_HIGH);
        Self((angle + low) + high)
    }

    #[inline(always)]
    fn whole(self) -> Self {
        let round = S::splat(S::Element::ROUND);
        Self((self.0 + round) - round)
    }

    #[inline(always)]
    fn select(s: Self, a: Self, b: Self) -> Self {
        let zero = S::splat(S::Element::from_f64(0.0));
        Self::unless_nan(s.0, a.0.select(s.0.simd_ge(zero), b.0))
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self::unless_nan(self.0, self.0.select(self.0.simd_lt(other.0), other.0))
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self::unless_nan(self.0, self.0.select(self.0.simd_gt(other.0), other.0))
    }
}
