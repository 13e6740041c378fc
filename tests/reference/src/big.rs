//! A number of 512 bits (154 digits) with operators.

use astro_float_num::{BigFloat, Consts, RoundingMode, Sign, Word};
use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};
use std::cell::RefCell;
use std::collections::BTreeMap;

/// Bits of every number.
pub const BITS: usize = 512;

const ROUNDING: RoundingMode = RoundingMode::None;

/// A number of [`BITS`] bits.
#[derive(Clone, Debug)]
pub struct Big(BigFloat);

impl Big {
    /// Zero.
    pub fn zero() -> Self {
        Self::from(0.0)
    }

    /// One.
    pub fn one() -> Self {
        Self::from(1.0)
    }

    /// `2^exponent`.
    pub fn power_of_two(exponent: i32) -> Self {
        let mut one = BigFloat::from_f64(1.0, BITS);
        // The mantissa lies in [1/2, 1): the exponent of 1 is 1.
        one.set_exponent(exponent + 1);
        Self(one)
    }

    /// Square root; NaN for a negative number.
    pub fn sqrt(&self) -> Self {
        Self(self.0.sqrt(BITS, ROUNDING))
    }

    /// Absolute value.
    pub fn abs(&self) -> Self {
        Self(self.0.abs())
    }

    /// Whether the number is negative (zero is not).
    pub fn is_negative(&self) -> bool {
        self.0.is_negative() && !self.0.is_zero()
    }

    /// Whether the number is zero.
    pub fn is_zero(&self) -> bool {
        self.0.is_zero()
    }

    /// Whether the number is not a number or infinite.
    pub fn is_invalid(&self) -> bool {
        self.0.is_nan() || self.0.is_inf()
    }

    /// The larger of two numbers.
    pub fn max(&self, other: &Self) -> Self {
        if self < other {
            other.clone()
        } else {
            self.clone()
        }
    }

    /// Sine and cosine; the last results are remembered, since one input enters many evaluations.
    pub fn sin_cos(&self) -> (Self, Self) {
        TRIGONOMETRY.with_borrow_mut(|known| known.sin_cos(self))
    }

    /// The nearest `f64`, to within its last bit; infinite or zero beyond its range.
    pub fn to_f64(&self) -> f64 {
        let Some((words, _, sign, exponent, _)) = self.0.as_raw_parts() else {
            return f64::NAN;
        };
        if words.is_empty() {
            return 0.0;
        }
        let word_size = 2f64.powi(-(8 * size_of_val(&words[0]) as i32));
        let mantissa = words
            .iter()
            .fold(0.0, |sum, &word| (sum + word as f64) * word_size);
        let magnitude = mantissa * 2f64.powi(exponent / 2) * 2f64.powi(exponent - exponent / 2);
        if sign == Sign::Neg {
            -magnitude
        } else {
            magnitude
        }
    }

    fn key(&self) -> Option<Key> {
        let (words, _, sign, exponent, _) = self.0.as_raw_parts()?;
        Some((words.to_vec(), exponent, sign == Sign::Neg))
    }
}

impl From<f64> for Big {
    fn from(x: f64) -> Self {
        Self(BigFloat::from_f64(x, BITS))
    }
}

impl PartialEq for Big {
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

impl PartialOrd for Big {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.0.cmp(&other.0).map(|order| order.cmp(&0))
    }
}

impl Neg for Big {
    type Output = Big;
    fn neg(self) -> Big {
        Big(self.0.neg())
    }
}

impl Neg for &Big {
    type Output = Big;
    fn neg(self) -> Big {
        Big(BigFloat::neg(&self.0))
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident) => {
        impl $trait<&Big> for &Big {
            type Output = Big;
            fn $method(self, other: &Big) -> Big {
                Big(self.0.$method(&other.0, BITS, ROUNDING))
            }
        }
        impl $trait<Big> for &Big {
            type Output = Big;
            fn $method(self, other: Big) -> Big {
                self.$method(&other)
            }
        }
        impl $trait<&Big> for Big {
            type Output = Big;
            fn $method(self, other: &Big) -> Big {
                (&self).$method(other)
            }
        }
        impl $trait<Big> for Big {
            type Output = Big;
            fn $method(self, other: Big) -> Big {
                (&self).$method(&other)
            }
        }
        impl $trait<f64> for &Big {
            type Output = Big;
            fn $method(self, other: f64) -> Big {
                self.$method(&Big::from(other))
            }
        }
        impl $trait<f64> for Big {
            type Output = Big;
            fn $method(self, other: f64) -> Big {
                (&self).$method(&Big::from(other))
            }
        }
    };
}

operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

type Key = (Vec<Word>, i32, bool);

struct Trigonometry {
    constants: Consts,
    known: BTreeMap<Key, (Big, Big)>,
}

thread_local! {
    static TRIGONOMETRY: RefCell<Trigonometry> = RefCell::new(Trigonometry {
        constants: Consts::new().expect("memory for the constants"),
        known: BTreeMap::new(),
    });
}

impl Trigonometry {
    fn sin_cos(&mut self, x: &Big) -> (Big, Big) {
        let Some(key) = x.key() else {
            return (Big::from(f64::NAN), Big::from(f64::NAN));
        };
        if let Some(pair) = self.known.get(&key) {
            return pair.clone();
        }
        if self.known.len() > 400 {
            self.known.clear();
        }
        let sine = Big(x.0.sin(BITS, ROUNDING, &mut self.constants));
        let cosine = Big(x.0.cos(BITS, ROUNDING, &mut self.constants));
        self.known.insert(key, (sine.clone(), cosine.clone()));
        (sine, cosine)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn conversion_keeps_every_f64() {
        for x in [
            0.0,
            1.0,
            -0.1,
            1e-150,
            3.5e150,
            -7e-300,
            f64::MIN_POSITIVE,
            f64::MAX,
        ] {
            assert_eq!(Big::from(x).to_f64(), x);
        }
        assert_eq!(Big::power_of_two(-70).to_f64(), 2f64.powi(-70));
    }

    #[test]
    fn sine_and_cosine_lie_on_the_unit_circle() {
        for x in [0.0, 0.3, -2.0, 40.0] {
            let (s, c) = Big::from(x).sin_cos();
            let miss = &s * &s + &c * &c - 1.0;
            assert!(miss.abs() < Big::power_of_two(10 - BITS as i32));
            assert!((s.to_f64() - x.sin()).abs() < 1e-15);
        }
    }
}
