//! Fields of a record of the payload: tokens between commas, numbers in base 64.

use crate::error::ImportError;
use crate::names::shown;

/// The digits, from zero to 63.
const DIGITS: &str = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-";
/// Numbers of more digits are not whole in a double.
const MOST_DIGITS: usize = 9;

/// The numbers are thousandths.
const THOUSANDTHS: f64 = 1000.0;

/// The tokens of a record.
pub(super) struct Record<'t> {
    text: &'t str,
    tokens: std::str::Split<'t, char>,
}

impl<'t> Record<'t> {
    pub(super) fn new(text: &'t str) -> Self {
        Self {
            text,
            tokens: text.split(','),
        }
    }

    /// Returns the next token, which is empty after the last one.
    pub(super) fn text(&mut self) -> &'t str {
        self.tokens.next().unwrap_or_default()
    }

    /// Returns the next token as thousandths.
    pub(super) fn decimal(&mut self) -> Result<f64, ImportError> {
        let token = self.text();
        Ok(self.whole(token)? / THOUSANDTHS)
    }

    /// Returns a decimal number that may be missing.
    pub(super) fn optional(&mut self) -> Result<f64, ImportError> {
        match self.text() {
            "" => Ok(0.0),
            token => Ok(self.whole(token)? / THOUSANDTHS),
        }
    }

    fn whole(&self, token: &str) -> Result<f64, ImportError> {
        whole(token).ok_or_else(|| {
            ImportError::new(format!(
                "`{}` in the record `{}` of the address is no number",
                shown(token),
                shown(self.text)
            ))
        })
    }
}

/// Reads a whole number. A zero in front is the minus sign.
pub(super) fn whole(token: &str) -> Option<f64> {
    if token.is_empty() || token.len() > MOST_DIGITS {
        return None;
    }
    let mut value = 0.0;
    for letter in token.chars() {
        value = 64.0 * value + digit(letter)? as f64;
    }
    let is_negative = token.starts_with('0') && value != 0.0;
    Some(if is_negative { -value } else { value })
}

/// Returns the value of a digit.
pub(super) fn digit(letter: char) -> Option<usize> {
    DIGITS.find(letter)
}
