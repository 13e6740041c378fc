//! Two numbers between which a third one is, rounded outwards.

use crate::math::double;
use crate::scalar::Scalar;
use core::f64::consts::{FRAC_PI_2, TAU};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Elementary functions are wrong by less than this many units in the last place.
const ULPS: usize = 4;

/// The distance from an extreme of the sine, in turns, within which a bound counts as beyond it.
const BESIDE: f64 = 1e-9;

/// Between a low and a high number; NaN where nothing is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bounds {
    pub(super) low: f64,
    pub(super) high: f64,
}

impl Bounds {
    /// Nothing is known.
    pub(super) const UNKNOWN: Self = Self::exactly(f64::NAN);
    pub(super) const ZERO: Self = Self::exactly(0.0);

    pub(super) const fn exactly(x: f64) -> Self {
        Self { low: x, high: x }
    }

    /// Between two numbers in this order.
    pub(super) fn between(low: f64, high: f64) -> Self {
        match low <= high {
            true => Self { low, high },
            false => Self::UNKNOWN,
        }
    }

    /// Between a number and its negative.
    pub(super) fn around_zero(size: f64) -> Self {
        Self {
            low: -size,
            high: size,
        }
    }

    /// The same after a rounding of each bound.
    pub(super) fn rounded(self) -> Self {
        Self {
            low: -next(-self.low),
            high: next(self.high),
        }
    }

    /// The same after the errors of an elementary function.
    fn widened(self) -> Self {
        (0..ULPS).fold(self, |bounds, _| bounds.rounded())
    }

    /// The least bounds of some numbers; unknown if one of them is.
    fn around(numbers: [f64; 4]) -> Self {
        let [a, b, c, d] = numbers;
        // All of them at once, and comparisons without a test of NaN: each is one instruction.
        if a.is_nan() | b.is_nan() | c.is_nan() | d.is_nan() {
            return Self::UNKNOWN;
        }
        let least = |x: f64, y: f64| if x < y { x } else { y };
        let most = |x: f64, y: f64| if x > y { x } else { y };
        Self {
            low: least(least(a, b), least(c, d)),
            high: most(most(a, b), most(c, d)),
        }
    }

    pub(super) fn is_known(self) -> bool {
        self.low <= self.high
    }

    fn is_zero(self) -> bool {
        self.low == 0.0 && self.high == 0.0
    }

    fn is_finite(self) -> bool {
        self.low.is_finite() && self.high.is_finite()
    }

    pub(super) fn contains(self, x: f64) -> bool {
        self.low <= x && x <= self.high
    }

    pub(super) fn centre(self) -> f64 {
        0.5 * self.low + 0.5 * self.high
    }

    /// Returns the union.
    pub(super) fn or(self, other: Self) -> Self {
        Self::around([self.low, self.high, other.low, other.high])
    }

    /// Returns the intersection; `self` where the other is unknown.
    pub(super) fn and(self, other: Self) -> Self {
        if !other.is_known() {
            return self;
        }
        let both = Self {
            low: self.low.max(other.low),
            high: self.high.min(other.high),
        };
        if self.is_known() && both.is_known() {
            both
        } else {
            self
        }
    }

    pub(super) fn least(self, other: Self) -> Self {
        match self.is_known() && other.is_known() {
            true => Self::between(self.low.min(other.low), self.high.min(other.high)),
            false => Self::UNKNOWN,
        }
    }

    pub(super) fn abs(self) -> Self {
        if self.low >= 0.0 {
            self
        } else if self.high <= 0.0 {
            -self
        } else {
            Self::between(0.0, self.high.max(-self.low))
        }
    }

    pub(super) fn square(self) -> Self {
        let size = self.abs();
        let square = Self::between(size.low * size.low, size.high * size.high).rounded();
        Self::between(square.low.max(0.0), square.high)
    }

    /// Unknown where a part is negative.
    pub(super) fn sqrt(self) -> Self {
        if self.low >= 0.0 {
            let root = Self::between(double::sqrt(self.low), double::sqrt(self.high)).rounded();
            Self::between(root.low.max(0.0), root.high)
        } else {
            Self::UNKNOWN
        }
    }

    /// Applies a rising function.
    pub(super) fn by(self, rising: impl Fn(f64) -> f64) -> Self {
        Self::between(rising(self.low), rising(self.high)).widened()
    }

    pub(super) fn sin_cos(self) -> (Self, Self) {
        let [low, high] = [self.low, self.high].map(Scalar::sin_cos);
        (
            self.wave(FRAC_PI_2, [low.0, high.0]),
            self.wave(0.0, [low.1, high.1]),
        )
    }

    /// Sine or cosine, which has its greatest value at `summit` and once in every turn from there,
    /// with its values at both bounds.
    fn wave(self, summit: f64, [low, high]: [f64; 2]) -> Self {
        // Whether a whole number of turns from there is within the bounds, or beside them.
        let meets = |angle: f64| {
            let turns = [self.low, self.high].map(|x| (x - angle) / TAU);
            let (from, to) = (turns[0] - BESIDE, turns[1] + BESIDE);
            let within = |turns: f64| from <= turns.whole() && turns.whole() <= to;
            to - from >= 1.0 || within(from) || within(to)
        };
        let ends = Self::around([low, high, low, high]).widened();
        if !ends.is_known() {
            return Self::UNKNOWN;
        }
        Self {
            low: if meets(summit + 0.5 * TAU) {
                -1.0
            } else {
                ends.low.max(-1.0)
            },
            high: if meets(summit) {
                1.0
            } else {
                ends.high.min(1.0)
            },
        }
    }

    /// Angles of vectors from the x axis; unknown where some of them may have none, or half a turn.
    pub(super) fn atan2(self, x: Self) -> Self {
        let apart = x.low > 0.0 || self.low > 0.0 || self.high < 0.0;
        if !apart {
            return Self::UNKNOWN;
        }
        let (y, angle) = (self, |y: f64, x: f64| Scalar::atan2(y, x));
        Self::around([
            angle(y.low, x.low),
            angle(y.low, x.high),
            angle(y.high, x.low),
            angle(y.high, x.high),
        ])
        .widened()
    }
}

/// The next number above, as `f64::next_up`, without a jump for each sign.
fn next(x: f64) -> f64 {
    // Of both zeros the positive one.
    let bits = (x + 0.0).to_bits() as i64;
    let step = (bits >> 63) | 1;
    match x < f64::INFINITY {
        true => f64::from_bits(bits.wrapping_add(step) as u64),
        false => x,
    }
}

impl Neg for Bounds {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            low: -self.high,
            high: -self.low,
        }
    }
}

impl Add for Bounds {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        // Nothing is rounded.
        if other.is_zero() {
            return self;
        }
        if self.is_zero() {
            return other;
        }
        Self {
            low: self.low + other.low,
            high: self.high + other.high,
        }
        .rounded()
    }
}

impl Sub for Bounds {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Bounds {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let (a, b) = (self, other);
        // Slopes of constants are zero and stay so. Rounded, they would become the least numbers
        // that there are, which processors multiply slowly.
        if (a.is_zero() && b.is_finite()) || (b.is_zero() && a.is_finite()) {
            return Self::ZERO;
        }
        Self::around([
            a.low * b.low,
            a.low * b.high,
            a.high * b.low,
            a.high * b.high,
        ])
        .rounded()
    }
}

impl Div for Bounds {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let (a, b) = (self, other);
        if b.contains(0.0) {
            return Self::UNKNOWN;
        }
        if a.is_zero() && b.is_finite() {
            return Self::ZERO;
        }
        Self::around([
            a.low / b.low,
            a.low / b.high,
            a.high / b.low,
            a.high / b.high,
        ])
        .rounded()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_next_number_is_that_of_the_library() {
        let mut numbers = std::vec![
            0.0,
            1.0,
            f64::MIN_POSITIVE,
            5e-324,
            f64::MAX,
            f64::INFINITY,
            2.0,
            0.1
        ];
        numbers.extend((-1074..1024).map(|exponent| 1.3 * 2.0_f64.powi(exponent)));
        for x in numbers.into_iter().flat_map(|x| [x, -x]) {
            assert_eq!(next(x).to_bits(), x.next_up().to_bits(), "{x:e}");
        }
        assert!(next(f64::NAN).is_nan());
    }

    #[test]
    fn least_bounds_are_those_of_folds() {
        let numbers = [-3.0, -0.5, 0.0, 1.5, 2.0, f64::INFINITY, f64::NEG_INFINITY];
        for a in numbers {
            for b in numbers {
                for c in numbers {
                    let around = Bounds::around([a, b, c, 1.0]);
                    assert_eq!(around.low, a.min(b).min(c).min(1.0));
                    assert_eq!(around.high, a.max(b).max(c).max(1.0));
                }
            }
            for at in 0..4 {
                let mut four = [a; 4];
                four[at] = f64::NAN;
                assert!(!Bounds::around(four).is_known());
            }
        }
    }
}
