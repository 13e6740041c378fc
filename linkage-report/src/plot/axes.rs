//! Titles of axes.

use std::format;
use std::string::String;
use std::vec::Vec;

use super::curve::Quantity;
use linkage_formats::ticks::Scale;

/// Scale and title of an axis.
pub(super) struct Axis {
    pub(super) scale: Scale,
    pub(super) title: String,
}

impl Axis {
    pub(super) fn abscissa(quantity: &Quantity) -> Self {
        let (low, high) = limits(quantity.values.iter().copied());
        let scale = if low == high {
            Scale::about(low, high, 9)
        } else if quantity.unit == "deg" {
            Scale::degrees(low, high, 10)
        } else {
            Scale::within(low, high, 10)
        };
        let title = title(&quantity.name, &quantity.unit, scale.exponent);
        Self { scale, title }
    }

    /// Returns an axis for all these numbers, titled with the names of the curves.
    pub(super) fn ordinate(
        names: &[&str],
        unit: &str,
        values: impl Iterator<Item = f64>,
        height: f64,
    ) -> Self {
        let (low, high) = limits(values);
        let about = if unit == "deg" {
            Scale::about_degrees
        } else {
            Scale::about
        };
        let scale = about(low, high, (height / 34.0) as usize + 1);
        let joined = names.join(", ");
        // A name that does not fit is in the legend.
        let fits = joined.chars().count() as f64 * 7.0 < height - 60.0;
        let title = title(if fits { &joined } else { "" }, unit, scale.exponent);
        Self { scale, title }
    }
}

/// The smallest and the largest finite number; 0 if there is none.
fn limits(values: impl Iterator<Item = f64>) -> (f64, f64) {
    // The distance of the limits must be finite, too.
    let largest = f64::MAX / 4.0;
    let finite: Vec<f64> = values.filter(|x| x.is_finite()).collect();
    let clamped = || finite.iter().map(|x| x.clamp(-largest, largest));
    match finite.is_empty() {
        true => (0.0, 0.0),
        false => (
            clamped().fold(f64::INFINITY, f64::min),
            clamped().fold(f64::NEG_INFINITY, f64::max),
        ),
    }
}

/// `name [10^3 unit]` with raised exponents.
fn title(name: &str, unit: &str, exponent: i32) -> String {
    let power = match exponent {
        0 => String::new(),
        _ => format!("10^{exponent}"),
    };
    let parts: Vec<&str> = [power.as_str(), unit]
        .into_iter()
        .filter(|p| !p.is_empty())
        .collect();
    let bracket = match parts.join(" ") {
        unit if unit.is_empty() => unit,
        unit => format!("[{}]", raised(&unit)),
    };
    let parts = [name, &bracket].into_iter().filter(|p| !p.is_empty());
    parts.collect::<Vec<_>>().join(" ")
}

/// `mm/s^2` with a raised 2, `N*mm` with a raised dot.
fn raised(unit: &str) -> String {
    let mut raising = false;
    let mut text = String::new();
    for c in unit.chars() {
        let digit = c.to_digit(10).filter(|_| raising);
        raising = c == '^' || digit.is_some() || (raising && c == '-');
        match (c, digit) {
            ('^', _) => {}
            ('*', _) => text.push('\u{b7}'),
            ('-', _) if raising => text.push('\u{207b}'),
            (_, Some(1)) => text.push('\u{b9}'),
            (_, Some(2)) => text.push('\u{b2}'),
            (_, Some(3)) => text.push('\u{b3}'),
            (_, Some(digit)) => text.extend(char::from_u32(0x2070 + digit)),
            (c, None) => text.push(c),
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn titles_have_units_and_powers() {
        assert_eq!(title("p.x", "mm", 0), "p.x [mm]");
        assert_eq!(title("a.x", "mm/s^2", 6), "a.x [10\u{2076} mm/s\u{b2}]");
        assert_eq!(title("margin", "", 0), "margin");
        assert_eq!(title("margin", "", -6), "margin [10\u{207b}\u{2076}]");
        assert_eq!(title("", "N*mm", 0), "[N\u{b7}mm]");
        assert_eq!(title("e", "mm^-1", 0), "e [mm\u{207b}\u{b9}]");
    }
}
