//! Positions of inputs as text.

use alloc::borrow::ToOwned;
use alloc::format;
use alloc::string::String;

/// Ends of a range that are proposed are this share of it inside the dead point, rounded to a power
/// of ten.
const INSIDE: f64 = 1e-4;

/// A position of an input: `30deg` for an angle, `12mm` for a length.
#[must_use]
pub fn position_as_written(x: f64, angle: bool, unit: &str) -> String {
    match angle {
        true => format!("{}deg", significant(x.to_degrees())),
        false => length(x, unit),
    }
}

/// Units of length that a mechanism may have, in metres.
const UNITS: [(&str, f64); 5] = [
    ("m", 1.0),
    ("cm", 1e-2),
    ("mm", 1e-3),
    ("um", 1e-6),
    ("inch", 0.0254),
];

/// Significant digits that are printed of a number.
const MOST_PRINTED: usize = 7;

/// Significant digits of a number that a person writes.
const SHORT: usize = 5;

fn length(x: f64, unit: &str) -> String {
    let (x, unit) = length_as_written(x, unit);
    format!("{}{unit}", significant(x))
}

/// A length as a person has written it, probably: in this unit, or in the other one of inches and
/// millimetres if it is a short number there and none here.
///
/// ```
/// use linkage_core::range_check::length_as_written;
///
/// assert_eq!(length_as_written(3.0 / 25.4, "inch"), (3.0, "mm"));
/// assert_eq!(length_as_written(0.5, "inch"), (0.5, "inch"));
/// ```
#[must_use]
pub fn length_as_written(x: f64, unit: &str) -> (f64, &str) {
    let metres = |name: &str| UNITS.iter().find(|unit| unit.0 == name).map(|unit| unit.1);
    let other = if unit == "inch" { "mm" } else { "inch" };
    let (Some(of_unit), Some(of_other)) = (metres(unit), metres(other)) else {
        return (x, unit);
    };
    match rounded(x * (of_unit / of_other), SHORT) {
        Some(there) if rounded(x, MOST_PRINTED).is_none() => (there, other),
        _ => (x, unit),
    }
}

/// A number of so many significant digits if it is one except for rounding.
fn rounded(x: f64, digits: usize) -> Option<f64> {
    let decimals = digits - 1;
    let rounded: f64 = format!("{x:.decimals$e}").parse().ok()?;
    ((rounded - x).abs() <= 1e-13 * x.abs()).then_some(rounded)
}

/// The ends of a stretch that works, moved to round numbers inside of it, and the step of these
/// numbers. An end that is that of the range stays.
#[must_use]
pub fn rounded_inwards(
    reach: [f64; 2],
    reference: f64,
    range: [f64; 2],
    angle: bool,
) -> ([f64; 2], f64) {
    let [from, to] = reach;
    let unit = match angle {
        true => 1.0_f64.to_radians(),
        false => 1.0,
    };
    let step = unit * power_of_ten(exponent((to - from) * INSIDE / unit));
    let inside = |x: f64, end: f64| match x == end {
        true => x,
        false if reference < x => floor(x / step) * step,
        false => -floor(-x / step) * step,
    };
    ([inside(from, range[0]), inside(to, range[1])], step)
}

/// A multiple of `step` as text, without further digits: `179.99deg`.
#[must_use]
pub fn rounded_to(x: f64, step: f64, angle: bool, unit: &str) -> String {
    let [shown, step] = [x, step].map(|x| if angle { x.to_degrees() } else { x });
    // A step is a power of ten, apart from rounding.
    let digits = (-exponent(1.5 * step)).clamp(0, 17) as usize;
    let text = format!("{shown:.digits$}");
    let rounded = text.parse().unwrap_or(shown);
    match angle {
        true => format!("{}deg", significant(rounded)),
        false => length(rounded, unit),
    }
}

/// Up to seven significant digits, without zeros at the end.
#[must_use]
pub fn significant(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    if !x.is_finite() {
        return format!("{x}");
    }
    if !(1e-6..1e12).contains(&x.abs()) {
        return format!("{x:.6e}");
    }
    let digits = (6 - exponent(x)).clamp(0, 17) as usize;
    let text = format!("{x:.digits$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// Returns the exponent of the first digit in powers of ten; 0 for numbers that are not finite.
fn exponent(x: f64) -> i32 {
    let text = format!("{x:e}");
    let exponent = text.rsplit('e').next();
    exponent.and_then(|text| text.parse().ok()).unwrap_or(0)
}

fn power_of_ten(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().unwrap_or(1.0)
}

/// The largest whole number that is not above `x`, of numbers that are not large.
fn floor(x: f64) -> f64 {
    let whole = x as i64 as f64;
    if whole > x { whole - 1.0 } else { whole }
}

#[cfg(test)]
mod tests {
    use super::{length, position_as_written, rounded_inwards, rounded_to, significant};
    use core::f64::consts::PI;

    #[test]
    fn numbers_have_seven_digits_at_most() {
        let shown = [0.0, 1e6, 999_999.96, 0.1 + 0.2, -12.5, 1e-7, 1e12, f64::NAN].map(significant);
        let expected = [
            "0",
            "1000000",
            "1000000",
            "0.3",
            "-12.5",
            "1.000000e-7",
            "1.000000e12",
            "NaN",
        ];
        assert_eq!(shown, expected);
        assert_eq!(position_as_written(PI, true, "rad"), "180deg");
        assert_eq!(position_as_written(12.5, false, "mm"), "12.5mm");
    }

    #[test]
    fn lengths_are_as_they_were_written() {
        for (x, unit, expected) in [
            (3.0 / 25.4, "inch", "3mm"),
            (12.345 / 25.4, "inch", "12.345mm"),
            (0.1875, "inch", "0.1875inch"),
            (1.1, "inch", "1.1inch"),
            (1.0 / 3.0, "inch", "0.3333333inch"),
            (25.4, "mm", "25.4mm"),
            (0.001 * 25.4, "mm", "0.0254mm"),
            (2.0f64.sqrt(), "mm", "1.414214mm"),
            (0.0, "inch", "0inch"),
            (-0.0, "m", "0m"),
            (-3.0 / 25.4, "inch", "-3mm"),
        ] {
            assert_eq!(length(x, unit), expected);
        }
        assert_eq!(significant(-0.0), "0");
    }

    #[test]
    fn proposed_ends_are_round_and_inside() {
        let range = [0.0, 2.0 * PI];
        let ([low, high], step) = rounded_inwards([1e-7, PI - 1e-7], 0.5, range, true);
        assert!(low > 1e-7 && high < PI - 1e-7, "{low} {high}");
        let shown = [low, high].map(|x| rounded_to(x, step, true, "rad"));
        assert_eq!(shown, ["0.01deg", "179.99deg"]);
        // An end that is reached is the end, whatever its digits.
        let ([low, _], step) = rounded_inwards([-3.25, 7.77], 1.0, [-3.25, 10.0], false);
        assert_eq!(low, -3.25);
        assert_eq!(rounded_to(7.769, step, false, "mm"), "7.769mm");
    }
}
