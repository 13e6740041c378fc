//! Positions of inputs as text.

use alloc::borrow::ToOwned;
use alloc::format;
use alloc::string::String;

/// Ends of a range that are proposed are this share of it inside the dead point, rounded to a power of ten.
const INSIDE: f64 = 1e-4;

/// A position of an input: `30deg` for an angle, `12mm` for a length.
#[must_use]
pub fn place(x: f64, angle: bool, unit: &str) -> String {
    match angle {
        true => format!("{}deg", significant(x.to_degrees())),
        false => format!("{}{unit}", significant(x)),
    }
}

/// The ends of a stretch that works, moved to round numbers inside of it, and the step of these numbers. An end that is that of the range
/// stays.
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
    let unit = if angle { "deg" } else { unit };
    format!("{}{unit}", significant(rounded))
}

/// Up to seven significant digits, without zeros at the end.
#[must_use]
pub fn significant(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
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

/// The exponent of the first digit in powers of ten; 0 for what is no finite number.
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
    use super::{place, rounded_inwards, rounded_to, significant};
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
        assert_eq!(place(PI, true, "rad"), "180deg");
        assert_eq!(place(12.5, false, "mm"), "12.5mm");
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
