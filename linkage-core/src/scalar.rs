//! The numbers that generated functions compute with.

#[cfg(feature = "num-dual")]
mod dual;
#[cfg(any(feature = "std", feature = "libm"))]
mod enclosure;
#[cfg(any(feature = "std", feature = "libm"))]
mod float;
#[cfg(all(feature = "simba", any(feature = "std", feature = "libm")))]
mod lanes;
#[cfg(any(
    feature = "num-dual",
    all(feature = "simba", feature = "libm"),
    all(feature = "simba", feature = "std")
))]
mod operators;

#[cfg(feature = "num-dual")]
pub use dual::Dual;
#[cfg(any(feature = "std", feature = "libm"))]
pub use enclosure::Enclosure;
#[cfg(any(feature = "std", feature = "libm"))]
pub use float::Float;
#[cfg(all(feature = "simba", any(feature = "std", feature = "libm")))]
pub use lanes::Lanes;

use crate::certificate::{self, ROUNDINGS};
use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// True if this build may use fused multiply-add instructions everywhere. Sweeps may use them where
/// the machine turns out to have them.
pub const FUSED: bool = cfg!(all(
    feature = "std",
    any(target_feature = "fma", target_arch = "aarch64")
));

/// A real number, or several side by side (lanes), or one with derivatives (a dual number).
///
/// Implemented for `f64` and `f32`; `Lanes` (feature `simba`) and `Dual` (feature `num-dual`)
/// adapt the types of other crates, and an extended precision type can implement it too.
///
/// Angles are in radians. NaN stands for "cannot be assembled" and is passed on by every method.
/// Those of `f64` and `f32` have no branch and no call in machine code, apart from `tan`, `asin`,
/// `acos` and `atan`, so that loops over them become vector code.
///
/// ```
/// use linkage_core::Scalar;
///
/// fn third_side<T: Scalar>(a: T, b: T, angle: T) -> T {
///     let (_, cos) = angle.sin_cos();
///     let scale = a * a + b * b;
///     // 0 for equal sides and no angle, also where rounding makes it less.
///     T::root_with::<false>(scale - (a + a) * b * cos, T::slack(scale), T::from_f64(1.0))
/// }
/// assert!((third_side(3.0_f64, 4.0, core::f64::consts::FRAC_PI_2) - 5.0).abs() < 1e-15);
/// assert!((third_side(3.0_f32, 4.0, core::f32::consts::FRAC_PI_2) - 5.0).abs() < 1e-6);
/// ```
pub trait Scalar:
    Copy
    + Debug
    + PartialEq
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The count of numbers side by side; 1 for a plain number.
    const LANES: usize;

    /// True if loops over this type can become vector code: sweeps are then compiled for several
    /// instruction sets.
    const VECTORISES: bool = false;

    /// The largest negative discriminant due to the rounding of its terms, as a part of them: eight
    /// times the distance from 1 to the next number.
    const SLACK: f64 = ROUNDINGS * f64::EPSILON;

    /// The largest Newton correction, in radians or scaled lengths, of a prepared solution of a
    /// coupled group that is trusted: far above the error of a table, far below the distance of
    /// another assembly.
    const CORRECTION_LIMIT: f64 = certificate::CORRECTION_LIMIT;

    /// The largest last correction of a solution that is followed from position to position.
    /// Newton's method squares it and multiplies by the curvature of the equations. Up to a
    /// curvature of ten thousand, the rest in an `f64` is rounding.
    const LAST_CORRECTION: f64 = certificate::LAST_CORRECTION;

    /// True if a prepared solution, a plain `f64`, needs several Newton steps: for derivatives and
    /// digits that it does not have.
    const REFINES: bool = true;

    /// A constant, the same in every lane, with derivative zero.
    fn from_f64(x: f64) -> Self;

    /// The real part of one lane; a type with one lane does not look at `index`.
    ///
    /// # Panics
    /// If the type has several lanes and `index` is not below [`LANES`](Self::LANES).
    fn lane(self, index: usize) -> f64;

    /// Constants, lane by lane.
    fn from_lanes(f: impl FnMut(usize) -> f64) -> Self;

    /// Absolute value.
    fn abs(self) -> Self;
    /// Square root; NaN for a negative number.
    fn sqrt(self) -> Self;
    /// Tangent of an angle.
    fn tan(self) -> Self;
    /// Arc sine, from -pi/2 to pi/2; NaN outside -1 to 1.
    fn asin(self) -> Self;
    /// Arc cosine, from 0 to pi; NaN outside -1 to 1.
    fn acos(self) -> Self;
    /// Arc tangent, from -pi/2 to pi/2.
    fn atan(self) -> Self;
    /// Sine and cosine of an angle; NaN for an infinite one, and for one so large that its sine
    /// would be noise (`f64`: from 2^30 radians on, `f32`: from 2^20).
    fn sin_cos(self) -> (Self, Self);
    /// Angle of the vector (`x`, `self`) from the x axis, from -pi to pi.
    fn atan2(self, x: Self) -> Self;

    /// `self * factor + term`. With `FUSED` it is rounded once if the type can do that in one
    /// instruction, else twice.
    ///
    /// Only code that is compiled for machines with fused multiply-add instructions may say
    /// `FUSED`; elsewhere it is correct but slow.
    #[inline(always)]
    fn mul_add<const FUSED: bool>(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }

    /// Returns the result of [`sin_cos`](Self::sin_cos), for the machines that
    /// [`mul_add`](Self::mul_add) names.
    #[inline(always)]
    fn sin_cos_with<const FUSED: bool>(self) -> (Self, Self) {
        self.sin_cos()
    }

    /// Returns the result of [`sin_cos_with`](Self::sin_cos_with), to the last bit. `ROWS` is for a
    /// loop over many positions that becomes vector code, which has other instructions.
    #[inline(always)]
    fn sin_cos_in_rows<const FUSED: bool, const ROWS: bool>(self) -> (Self, Self) {
        self.sin_cos_with::<FUSED>()
    }

    /// Returns sine and cosine as [`sin_cos_in_rows`](Self::sin_cos_in_rows) does, but by the
    /// shortest method for one position or, with `ROWS`, for many, which may round differently. For
    /// callers that do not need equal bits for equal angles elsewhere.
    #[inline(always)]
    fn sin_cos_shortest<const FUSED: bool, const ROWS: bool>(self) -> (Self, Self) {
        self.sin_cos_in_rows::<FUSED, ROWS>()
    }

    /// `self / divisor`, NaN where that is infinite: a rate at a dead point or a change point,
    /// where the root of a discriminant is 0. For the machines that [`mul_add`](Self::mul_add)
    /// speaks of.
    #[inline(always)]
    fn quotient_with<const FUSED: bool>(self, divisor: Self) -> Self {
        let quotient = self / divisor;
        quotient.mul_add::<FUSED>(Self::from_f64(0.0), quotient)
    }

    /// Returns the result of [`atan2`](Self::atan2), for the machines that
    /// [`mul_add`](Self::mul_add) names.
    #[inline(always)]
    fn atan2_with<const FUSED: bool>(self, x: Self) -> Self {
        self.atan2(x)
    }

    /// A power of two near `1 / |self|`, for scaling without rounding: a constant, derivative zero.
    ///
    /// It is 1 for zero, infinities and NaN, and always finite; for `f64` its square is finite too
    /// when `|self|` is between 1e-150 and 1e150 (`f32`: 1e-18 and 1e18).
    fn inverse_scale(self) -> Self;

    /// Returns the bound of a negative rounding error in a sum of terms of the size `self`:
    /// [`SLACK`](Self::SLACK) times its absolute value, derivative zero; NaN for infinite terms.
    #[inline(always)]
    fn slack(self) -> Self {
        Self::from_lanes(|lane| {
            let x = self.lane(lane);
            Self::SLACK * x.max(-x) + 0.0 * x
        })
    }

    /// Square root of a discriminant `self`, with a fused multiply-add on the way if `FUSED`: where
    /// that is an instruction.
    ///
    /// It is 0 for a value that is negative by no more than `slack` times `size`, so that a
    /// position at a dead point has a value, and NaN below that. `slack` is [that](Self::slack) of
    /// a length or an area, `size` a factor, neither of them negative; where one is NaN, so is the
    /// root.
    fn root_with<const FUSED: bool>(self, slack: Self, size: Self) -> Self;

    /// The angle of the vector (`x`, `y`) that lies nearest to `guide`, turns counted.
    ///
    /// Accurate to about a unit in the last place for up to a million turns (`f32`: 2000).
    fn angle_near(y: Self, x: Self, guide: Self) -> Self;

    /// Returns the result of [`angle_near`](Self::angle_near), for the machines that
    /// [`mul_add`](Self::mul_add) names.
    #[inline(always)]
    fn angle_near_with<const FUSED: bool>(y: Self, x: Self, guide: Self) -> Self {
        Self::angle_near(y, x, guide)
    }

    /// The nearest whole number, of two the even one: a constant, derivative zero. Right up to 2^51
    /// (`f32`: 2^22).
    #[inline(always)]
    fn whole(self) -> Self {
        // Added and taken away again, it leaves whole numbers.
        const ROUND: f64 = 1.5 / f64::EPSILON;
        Self::from_lanes(|lane| (self.lane(lane) + ROUND) - ROUND)
    }

    /// `a` where `s >= 0`, `b` where `s < 0`, NaN where `s` is NaN.
    fn select(s: Self, a: Self, b: Self) -> Self;

    /// `a` where `s >= 0`, else NaN: [`select`](Self::select) with NaN.
    #[inline(always)]
    fn unless_negative(s: Self, a: Self) -> Self {
        Self::select(s, a, Self::from_f64(f64::NAN))
    }

    /// The smaller of two numbers; NaN if either is NaN.
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self::select(other - self, self, other)
    }

    /// The larger of two numbers; NaN if either is NaN.
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self::select(self - other, self, other)
    }

    /// +1 for zero and above, -1 below, NaN for NaN.
    #[inline(always)]
    fn sign(self) -> Self {
        Self::select(self, Self::from_f64(1.0), Self::from_f64(-1.0))
    }

    /// Length of the vector (`self`, `other`), without overflow or underflow on the way.
    #[inline(always)]
    fn hypot(self, other: Self) -> Self {
        let scale = self.abs().max(other.abs()).inverse_scale();
        let (a, b) = (self * scale, other * scale);
        (a * a + b * b).sqrt() * scale.inverse_scale()
    }
}
