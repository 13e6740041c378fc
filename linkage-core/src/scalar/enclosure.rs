//! Bounds of a function over an interval of one variable, by the code that computes it elsewhere.

mod bounds;
mod operators;

use super::Scalar;
use bounds::Bounds;

/// A function of one variable over an interval, as a [`Scalar`]: bounds of all its values, bounds
/// of all its slopes, and the value in the middle of the interval.
///
/// All bounds are rounded outwards, so that they hold for the function itself and not only for what
/// is computed of it. They are the tighter, by the square, the shorter the interval is: values are
/// those of interval arithmetic and of the mean value theorem at once (R. E. Moore, *Interval
/// Analysis*, 1966). Where nothing can be said, bounds are NaN.
///
/// ```
/// use linkage_core::{Enclosure, Scalar};
///
/// // x - x^2 between 0.4 and 0.6 is at most 1/4, and its slope 1 - 2 x is between -0.2 and 0.2.
/// let x = Enclosure::over(0.4, 0.6);
/// let y = x - x * x;
/// let [low, high] = y.range();
/// assert!(0.22 < low && low <= 0.24 && 0.25 <= high && high < 0.28);
/// let [least, most] = y.slopes();
/// assert!(least <= -0.2 && 0.2 <= most && most - least < 0.4001);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Enclosure {
    range: Bounds,
    /// In the middle of the interval.
    middle: Bounds,
    slope: Bounds,
    /// Half the length of the interval; 0 for a constant.
    half: f64,
}

impl Enclosure {
    /// The variable itself, between two numbers in this order.
    #[must_use]
    pub fn over(low: f64, high: f64) -> Self {
        let middle = 0.5 * low + 0.5 * high;
        Self {
            range: Bounds::between(low, high),
            middle: Bounds::exactly(middle),
            slope: Bounds::exactly(1.0),
            half: (high - middle).max(middle - low).next_up(),
        }
    }

    /// A number that the variable does not change, between two numbers in this order.
    #[must_use]
    pub fn between(low: f64, high: f64) -> Self {
        Self::constant(Bounds::between(low, high))
    }

    /// A number below all values and one above them; NaN where nothing is known.
    #[must_use]
    pub fn range(self) -> [f64; 2] {
        [self.range.low, self.range.high]
    }

    /// A number below all derivatives by the variable and one above them; NaN where nothing is
    /// known.
    #[must_use]
    pub fn slopes(self) -> [f64; 2] {
        [self.slope.low, self.slope.high]
    }

    const UNKNOWN: Self = Self {
        range: Bounds::UNKNOWN,
        middle: Bounds::UNKNOWN,
        slope: Bounds::UNKNOWN,
        half: 0.0,
    };

    const fn constant(value: Bounds) -> Self {
        Self {
            range: value,
            middle: value,
            slope: Bounds::ZERO,
            half: 0.0,
        }
    }

    /// Returns a value of these parts, within the bounds of the mean value theorem.
    fn from_parts(range: Bounds, middle: Bounds, slope: Bounds, half: f64) -> Self {
        // The product of the slope and of what lies half the length aside.
        let most = slope.low.abs().max(slope.high.abs());
        let mean = match slope.low.is_finite() && slope.high.is_finite() {
            true => middle + Bounds::around_zero(most * half).rounded(),
            false => Bounds::UNKNOWN,
        };
        Self {
            range: range.and(mean),
            middle,
            slope,
            half,
        }
    }

    /// A function of it, with the derivative as a function of its range.
    fn by(
        self,
        function: impl Fn(Bounds) -> Bounds,
        derivative: impl Fn(Bounds) -> Bounds,
    ) -> Self {
        Self::from_parts(
            function(self.range),
            function(self.middle),
            derivative(self.range) * self.slope,
            self.half,
        )
    }
}

impl Scalar for Enclosure {
    const LANES: usize = 1;

    fn from_f64(x: f64) -> Self {
        Self::constant(Bounds::exactly(x))
    }

    /// The middle of all values.
    fn lane(self, _: usize) -> f64 {
        self.range.centre()
    }

    fn from_lanes(mut f: impl FnMut(usize) -> f64) -> Self {
        Self::from_f64(f(0))
    }

    fn abs(self) -> Self {
        let sign = |range: Bounds| {
            if range.low >= 0.0 {
                Bounds::exactly(1.0)
            } else if range.high <= 0.0 {
                Bounds::exactly(-1.0)
            } else {
                Bounds::between(-1.0, 1.0)
            }
        };
        self.by(Bounds::abs, sign)
    }

    #[inline(never)]
    fn sqrt(self) -> Self {
        let root = self.range.sqrt();
        let slope = Bounds::exactly(0.5) / root * self.slope;
        Self::from_parts(root, self.middle.sqrt(), slope, self.half)
    }

    fn tan(self) -> Self {
        let (sin, cos) = self.sin_cos();
        sin / cos
    }

    fn asin(self) -> Self {
        let one = Bounds::exactly(1.0);
        self.by(
            |range| range.by(Scalar::asin),
            |range| one / (one - range.square()).sqrt(),
        )
    }

    fn acos(self) -> Self {
        let one = Bounds::exactly(1.0);
        self.by(
            |range| -range.by(|x| -Scalar::acos(x)),
            |range| -(one / (one - range.square()).sqrt()),
        )
    }

    fn atan(self) -> Self {
        let one = Bounds::exactly(1.0);
        self.by(
            |range| range.by(Scalar::atan),
            |range| one / (one + range.square()),
        )
    }

    #[inline(never)]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.range.sin_cos();
        let (middle_sin, middle_cos) = self.middle.sin_cos();
        (
            Self::from_parts(sin, middle_sin, cos * self.slope, self.half),
            Self::from_parts(cos, middle_cos, -sin * self.slope, self.half),
        )
    }

    #[inline(never)]
    fn atan2(self, x: Self) -> Self {
        let y = self;
        let square = x.range.square() + y.range.square();
        Self::from_parts(
            y.range.atan2(x.range),
            y.middle.atan2(x.middle),
            (x.range * y.slope - y.range * x.slope) / square,
            x.half.max(y.half),
        )
    }

    /// For all values together: that of the largest.
    fn inverse_scale(self) -> Self {
        let size = self.range.abs();
        match size.is_known() {
            true => Self::from_f64(Scalar::inverse_scale(size.high)),
            false => Self::UNKNOWN,
        }
    }

    /// Clamps negative numbers to 0. Callers that need bounds of an expression with a root must
    /// check its discriminant themselves.
    #[inline(never)]
    fn root_with<const FUSED: bool>(self, _slack: Self, _size: Self) -> Self {
        let positive = |range: Bounds| Bounds::between(range.low.max(0.0), range.high);
        let root = positive(self.range).sqrt();
        let slope = Bounds::exactly(0.5) / root * self.slope;
        Self::from_parts(root, positive(self.middle).sqrt(), slope, self.half)
    }

    #[inline(never)]
    fn angle_near(y: Self, x: Self, guide: Self) -> Self {
        // Seen from the middle of the box no vector of it is near half a turn.
        let [cx, cy] = [x, y].map(|value| value.range.centre());
        let base = Bounds::exactly(Scalar::angle_near(cy, cx, guide.range.centre()));
        let [fx, fy] = [cx, cy].map(Bounds::exactly);
        let angle = |x: Bounds, y: Bounds| {
            let aside = (fx * y - fy * x).atan2(fx * x + fy * y);
            // The base itself is rounded.
            base.by(|angle| angle) + aside
        };
        let square = x.range.square() + y.range.square();
        let half = x.half.max(y.half).max(guide.half);
        let all = Self::from_parts(
            angle(x.range, y.range),
            angle(x.middle, y.middle),
            (x.range * y.slope - y.range * x.slope) / square,
            half,
        );
        let away = (all.range - guide.range).abs();
        match away.high < core::f64::consts::PI {
            true => all,
            false => Self::UNKNOWN,
        }
    }

    fn whole(self) -> Self {
        let [low, high] = [self.range.low, self.range.high].map(Scalar::whole);
        match low == high {
            true => Self::from_f64(low),
            false => Self::UNKNOWN,
        }
    }

    /// Returns unknown slopes where either may be chosen.
    fn select(s: Self, a: Self, b: Self) -> Self {
        if s.range.low >= 0.0 {
            return a;
        }
        if s.range.high < 0.0 {
            return b;
        }
        if !s.range.is_known() {
            return Self::UNKNOWN;
        }
        Self {
            range: a.range.or(b.range),
            middle: a.middle.or(b.middle),
            slope: Bounds::UNKNOWN,
            half: a.half.max(b.half).max(s.half),
        }
    }

    #[inline(never)]
    fn min(self, other: Self) -> Self {
        if self.range.high <= other.range.low {
            return self;
        }
        if other.range.high <= self.range.low {
            return other;
        }
        Self::from_parts(
            self.range.least(other.range),
            self.middle.least(other.middle),
            self.slope.or(other.slope),
            self.half.max(other.half),
        )
    }

    fn max(self, other: Self) -> Self {
        -(-self).min(-other)
    }

    #[inline(never)]
    fn hypot(self, other: Self) -> Self {
        let length = |a: Bounds, b: Bounds| (a.square() + b.square()).sqrt();
        let range = length(self.range, other.range);
        Self::from_parts(
            range,
            length(self.middle, other.middle),
            (self.range * self.slope + other.range * other.slope) / range,
            self.half.max(other.half),
        )
    }
}
