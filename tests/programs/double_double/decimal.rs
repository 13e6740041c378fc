//! Double-doubles from decimal digits and back.

use super::DoubleDouble;
use std::error::Error;
use std::fmt;
use std::str::FromStr;
use xprec::Df64;

/// The text is not a decimal number such as `-12.5`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct NotDecimal;

impl fmt::Display for NotDecimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("not a decimal number: digits, perhaps a minus before and a point between")
    }
}

impl Error for NotDecimal {}

impl FromStr for DoubleDouble {
    type Err = NotDecimal;

    /// Up to 31 digits are taken exactly and rounded once, by the division.
    fn from_str(text: &str) -> Result<Self, NotDecimal> {
        let digits = text.strip_prefix('-').unwrap_or(text);
        let (whole, part) = digits.split_once('.').unwrap_or((digits, ""));
        if whole.is_empty() {
            return Err(NotDecimal);
        }
        let mut value = Df64::from(0.0);
        for digit in whole.chars().chain(part.chars()) {
            let digit = digit.to_digit(10).ok_or(NotDecimal)?;
            value = value * 10.0 + f64::from(digit);
        }
        let value = value / power_of_ten(part.len());
        Ok(Self(if digits == text { value } else { -value }))
    }
}

impl fmt::Display for DoubleDouble {
    /// One digit, a point, the others and an exponent; 30 digits unless a precision is given.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let high = self.0.hi();
        if high == 0.0 || !high.is_finite() {
            return write!(f, "{high}");
        }
        let places = f.precision().unwrap_or(29).min(30);
        let (digits, exponent) = rounded(self.0.abs(), places);
        let sign = if high < 0.0 { "-" } else { "" };
        let (first, rest) = digits.split_at(1);
        let width = f.width().unwrap_or(0);
        write!(f, "{:>width$}", format!("{sign}{first}.{rest}e{exponent}"))
    }
}

/// `places + 1` digits of a positive number, and its decimal exponent.
fn rounded(value: Df64, places: usize) -> (String, i32) {
    let exponent = value.hi().log10().floor() as i32;
    let shift = places as i32 - exponent;
    let power = power_of_ten(shift.unsigned_abs() as usize);
    let shifted = if shift < 0 {
        value / power
    } else {
        value * power
    };
    // Below 1e31, both halves are integers after rounding, and so is their sum in 128 bits.
    let whole = shifted.round();
    let digits = (whole.hi() as i128 + whole.lo() as i128).to_string();
    // The logarithm may be off by one next to a power of ten, or rounding may reach it.
    let exponent = exponent + digits.len() as i32 - (places as i32 + 1);
    (digits, exponent)
}

fn power_of_ten(n: usize) -> Df64 {
    (0..n).fold(Df64::from(1.0), |power, _| power * 10.0)
}
