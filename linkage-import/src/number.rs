//! Numbers of files: finite, with the count of their decimals, and as text for the language.

use std::borrow::Cow;

use crate::error::ImportError;
use crate::names::shown;

/// The longest number that is read.
const LONGEST: usize = 60;

/// Wider bands contain whole numbers nearly always.
pub(crate) const WIDE: f64 = 0.25;

/// A number with the number of digits after its decimal point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Decimal {
    pub(crate) value: f64,
    pub(crate) decimals: usize,
}

/// Reads a decimal number. `name` is its name in messages.
pub(crate) fn decimal(text: &str, name: &str) -> Result<Decimal, ImportError> {
    let text = text.trim();
    let wrong = || ImportError::new(format!("{name} is `{}`, which is no number", shown(text)));
    let is_number = |letter: char| letter.is_ascii_digit() || "+-.eE".contains(letter);
    if text.len() > LONGEST || !text.chars().all(is_number) {
        return Err(wrong());
    }
    let value: f64 = text.parse().map_err(|_| wrong())?;
    if !value.is_finite() {
        return Err(ImportError::new(format!(
            "{name} is `{}`, which is too large",
            shown(text)
        )));
    }
    let mantissa = text.split(['e', 'E']).next().unwrap_or_default();
    let decimals = mantissa.split_once('.').map_or(0, |parts| parts.1.len());
    Ok(Decimal { value, decimals })
}

/// Returns a number of a table with a decimal point. It may have a comma instead where another sign
/// separates columns.
pub(crate) fn with_point(text: &str, separator: u8) -> Cow<'_, str> {
    match separator != b',' && text.matches(',').count() == 1 && !text.contains('.') {
        true => Cow::Owned(text.replace(',', ".")),
        false => Cow::Borrowed(text),
    }
}

/// Returns half of the last digit of numbers with so many decimals.
pub(crate) fn half_digit(decimals: usize) -> f64 {
    0.5 * 10f64.powi(-i32::try_from(decimals).unwrap_or(i32::MAX).min(30))
}

/// Rounds a length that was converted, so that no digits are added that the band covers.
pub(crate) fn rounded(value: f64, band: f64) -> f64 {
    /// The part of the band that the new rounding may add.
    const PART: f64 = 1e-3;
    if band <= 0.0 || !value.is_finite() {
        return value;
    }
    let digits = -(band * PART).log10().floor();
    let scale = 10f64.powi(digits.clamp(0.0, 14.0) as i32);
    let scaled = value * scale;
    // Larger numbers have no such digits.
    if scaled.abs() > 9e15 {
        return value;
    }
    scaled.round() / scale
}

/// Returns a number as text without an exponent, which the language has not.
pub(crate) fn plain(value: f64) -> String {
    let text = format!("{value}");
    if text == "-0" { "0".to_owned() } else { text }
}

/// Returns a number with few digits, for comments.
pub(crate) fn short(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let size = value.abs().log10().floor();
    let decimals = (1.0 - size).clamp(0.0, 15.0) as usize;
    let text = format!("{value:.decimals$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// A length with four digits or more.
pub(crate) fn short_length(length: f64) -> String {
    if length >= 1000.0 {
        format!("{length:.0}")
    } else {
        let decimals = (3.0 - length.max(1e-9).log10().floor()).clamp(0.0, 12.0) as usize;
        plain(format!("{length:.decimals$}").parse().unwrap_or(length))
    }
}

/// Returns a length with the band in which the rounding of its file leaves it, and a whole number
/// within. Without a band it has all digits.
pub(crate) fn banded(length: f64, band: f64, unit: &str) -> String {
    if band == 0.0 {
        return format!("{}{unit}", plain(length));
    }
    // One digit more than the band has.
    let decimals = (1.0 - band.log10().floor()).clamp(0.0, 12.0) as usize;
    let text = format!("{length:.decimals$} +-{}{unit}", short(band));
    let whole = length.round();
    match whole > 0.0 && (length - whole).abs() <= band && band < WIDE {
        true => format!("{text}; {whole}{unit} is within"),
        false => text,
    }
}
