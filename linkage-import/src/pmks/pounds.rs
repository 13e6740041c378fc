//! Masses in pounds as kilograms.

use crate::number::plain;

/// A pound in kilograms.
pub(super) const POUND: f64 = 0.453_592_37;
/// A pound times a square inch, in kilograms times square centimetres.
pub(super) const POUND_INCHES: f64 = POUND * 2.54 * 2.54;

/// Returns a number without the noise of a conversion.
pub(super) fn converted(value: f64) -> String {
    plain(format!("{value:.9}").parse().unwrap_or(value))
}
