//! Numbers of 77 digits: for the few solutions that plain and double-double numbers do not tell
//! from singular ones.

use super::real::Real;
use core::ops::{Add, Mul, Neg, Sub};
use linkage_core::numeric::complex::Complex;
use linkage_core::numeric::double_double::DoubleDouble;

/// Words of the digits.
const WORDS: usize = 4;
/// Words of exact products, and of sums before they are cut off.
const WIDE: usize = 2 * WORDS;
const BITS: u32 = u64::BITS;
/// Bits of the digits, as a difference of exponents.
const DIGITS: i32 = 256;

/// A whole number of 256 bits times a power of two.
///
/// An operation cuts off the digits that have no place, less than two units of the last bit.
/// Exponents far beyond those of all plain numbers stay where they end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Long {
    negative: bool,
    /// The exponent of the last bit.
    exponent: i32,
    /// The lowest word first. The highest bit is 1, but that of 0.
    digits: [u64; WORDS],
}

impl Long {
    pub(super) const ZERO: Self = Self {
        negative: false,
        exponent: 0,
        digits: [0; WORDS],
    };

    /// The first 256 bits.
    fn cut(negative: bool, exponent: i32, words: [u64; WIDE]) -> Self {
        let Some(highest) = words.iter().rposition(|&word| word != 0) else {
            return Self::ZERO;
        };
        let (up, bits) = (WIDE - 1 - highest, words[highest].leading_zeros());
        let word = |i: usize| i.checked_sub(up).map_or(0, |i| words[i]);
        let digits = core::array::from_fn(|i| match bits {
            0 => word(WORDS + i),
            _ => word(WORDS + i) << bits | word(WORDS + i - 1) >> (BITS - bits),
        });
        let raised = DIGITS - (BITS * up as u32 + bits) as i32;
        Self {
            negative,
            exponent: exponent.saturating_add(raised),
            digits,
        }
    }

    fn is_zero(self) -> bool {
        self.digits == [0; WORDS]
    }

    fn is_below(self, other: Self) -> bool {
        let [a, b, c, d] = self.digits;
        let [e, f, g, h] = other.digits;
        (self.exponent, [d, c, b, a]) < (other.exponent, [h, g, f, e])
    }

    /// Returns the nearest plain number.
    pub(super) fn narrow(self) -> f64 {
        let first = self.digits[WORDS - 1] as f64;
        let exponent = self.exponent.saturating_add(DIGITS - BITS as i32);
        // In two steps: the power alone may be too small or too large where the number is not.
        let exponent = exponent.clamp(-2000, 2000);
        let half = exponent / 2;
        let size = first * power(half) * power(exponent - half);
        if self.negative { -size } else { size }
    }

    /// Not of 0.
    pub(super) fn inverse(self) -> Self {
        let from_half_to_one = Self {
            exponent: -DIGITS,
            ..self
        };
        let mut inverse = Self::exact(1.0 / from_half_to_one.narrow());
        // 53 digits, 106, 212, all.
        for _ in 0..3 {
            inverse = inverse * (Self::exact(2.0) - from_half_to_one * inverse);
        }
        let raised = (-DIGITS).saturating_sub(self.exponent);
        Self {
            exponent: inverse.exponent.saturating_add(raised),
            ..inverse
        }
    }
}

/// A power of two that is a normal number.
fn power(exponent: i32) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}

/// Returns the inverse of a complex number, not of 0.
pub(super) fn inverse(number: Complex<Long>) -> Complex<Long> {
    let square = (number.re * number.re + number.im * number.im).inverse();
    number.conjugate().scaled(square)
}

impl Real for Long {
    fn exact(number: f64) -> Self {
        let bits = number.abs().to_bits();
        let (exponent, fraction) = ((bits >> 52) as i32, bits & ((1 << 52) - 1));
        let mut words = [0; WIDE];
        // Numbers too small for a leading bit have the exponent of the smallest others.
        words[0] = fraction | u64::from(exponent > 0) << 52;
        Self::cut(number < 0.0, exponent.max(1) - 1075, words)
    }

    fn bound(self) -> f64 {
        if self.is_zero() {
            return 0.0;
        }
        // The first word and its rounding, and the part that is less than all plain numbers.
        self.narrow().abs() * (1.0 + 4.0 * f64::EPSILON) + f64::MIN_POSITIVE
    }

    fn rounding(size: f64) -> f64 {
        // 2^-240: operations of complex numbers are a few of real ones, each wrong by less than
        // 2^-253. Plain numbers may be too small for such a part.
        const WRONG: f64 = 1.0 / ((1_u128 << 120) as f64 * (1_u128 << 120) as f64);
        size * WRONG + f64::MIN_POSITIVE
    }
}

impl From<DoubleDouble> for Long {
    fn from(number: DoubleDouble) -> Self {
        Self::exact(number.high) + Self::exact(number.low)
    }
}

impl Add for Long {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return if self.is_zero() { other } else { self };
        }
        let (small, large) = match self.is_below(other) {
            true => (self, other),
            false => (other, self),
        };
        let down = large.exponent.saturating_sub(small.exponent) as usize;
        let (words, bits) = (down / BITS as usize, down as u32 % BITS);
        // One word above for the carry, three below for the digits that move up when leading digits
        // cancel.
        let wide = |number: Self, i: usize| {
            let i = i.checked_sub(WIDE - 1 - WORDS);
            i.and_then(|i| number.digits.get(i)).copied().unwrap_or(0)
        };
        let moved = |i: usize| match bits {
            0 => wide(small, i + words),
            _ => wide(small, i + words) >> bits | wide(small, i + words + 1) << (BITS - bits),
        };
        let opposite = large.negative != small.negative;
        let mut carry = u128::from(opposite);
        let sum = core::array::from_fn(|i| {
            let term = if opposite { !moved(i) } else { moved(i) };
            let sum = u128::from(wide(large, i)) + u128::from(term) + carry;
            carry = sum >> BITS;
            sum as u64
        });
        let below = BITS as i32 * (WIDE - 1 - WORDS) as i32;
        Self::cut(large.negative, large.exponent.saturating_sub(below), sum)
    }
}

impl Sub for Long {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Long {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let mut words = [0; WIDE];
        for (i, &a) in self.digits.iter().enumerate() {
            let mut carry = 0;
            for (j, &b) in other.digits.iter().enumerate() {
                let sum = u128::from(a) * u128::from(b) + u128::from(words[i + j]) + carry;
                words[i + j] = sum as u64;
                carry = sum >> BITS;
            }
            words[i + WORDS] = carry as u64;
        }
        let exponent = self.exponent.saturating_add(other.exponent);
        Self::cut(self.negative != other.negative, exponent, words)
    }
}

impl Neg for Long {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            negative: !self.negative && !self.is_zero(),
            ..self
        }
    }
}
