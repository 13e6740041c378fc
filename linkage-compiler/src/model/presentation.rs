//! The units in which numbers are given and printed.

use super::conversion::{Literal, convert_product};
use super::types::{Dimension, LengthUnit};
use super::words::raised;

impl Dimension {
    /// The unit of a quantity: `mm`, `N*mm`, `kg*mm^2`, `1/s`, `mm^(1/2)`, `rad`, nothing for a number.
    pub(crate) fn unit(self, length: LengthUnit) -> String {
        let kilograms = self.half_kilograms;
        let angle = if self.angle { 2 } else { 0 };
        let powers = [
            ("rad", angle),
            ("kg", kilograms),
            ("N", self.half_forces - kilograms),
            (length.name(), self.half_lengths + kilograms),
            ("s", self.half_times - 2 * kilograms),
        ];
        let factors = |sign: i32| {
            let chosen = powers.iter().filter(move |(_, halves)| halves * sign > 0);
            let raised = chosen.map(move |(word, halves)| raised(word, halves * sign));
            raised.collect::<Vec<_>>()
        };
        let (above, below) = (factors(1).join("*"), factors(-1));
        let above = match above.as_str() {
            "" if !below.is_empty() => "1".to_owned(),
            _ => above,
        };
        match below.len() {
            0 => above,
            1 => format!("{above}/{}", below[0]),
            _ => format!("{above}/({})", below.join("*")),
        }
    }

    /// What one of the [unit](Dimension::unit) is for the program, which computes in newtons, seconds and the length unit: not 1
    /// only if the unit has kilograms.
    pub(crate) fn internal_per_unit(self, length: LengthUnit) -> f64 {
        // A kilogram is a newton second^2 for each metre.
        let whole = |power: i32| match convert_product("1", &[("m", power)], length) {
            Literal::Value(value, _) => value,
            _ => 1.0,
        };
        match self.half_kilograms {
            0 => 1.0,
            halves if halves % 2 == 0 => whole(-halves / 2),
            halves => whole(-halves).sqrt(),
        }
    }
}

/// A length: in the unit of the mechanism, or in the other one of inches and millimetres if it is a short number there
/// and none in the mechanism's. So `3mm` is read as it was written where the unit is `inch`.
pub(crate) fn length(x: f64, unit: LengthUnit) -> String {
    let other = match unit {
        LengthUnit::Inch => LengthUnit::Millimetre,
        _ => LengthUnit::Inch,
    };
    let there = x * unit.in_units_of(other);
    let text = |x: f64, unit: LengthUnit| format!("{}{}", significant(x), unit.name());
    match !is_written_by(x, 7) && is_written_by(there, SHORT) {
        true => text(there, other),
        false => text(x, unit),
    }
}

/// Significant digits of a number that a person writes.
const SHORT: usize = 5;

/// Whether as many significant digits say all of a number but its rounding.
fn is_written_by(x: f64, digits: usize) -> bool {
    let decimals = digits - 1;
    let rounded: f64 = format!("{x:.decimals$e}").parse().unwrap_or(f64::NAN);
    (rounded - x).abs() <= 1e-13 * x.abs()
}

/// Up to seven significant digits, without trailing zeros.
pub(crate) fn significant(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    if !x.is_finite() {
        return format!("{x}");
    }
    let digits = (6 - x.abs().log10().floor() as i32).clamp(0, 17) as usize;
    if !(1e-6..1e12).contains(&x.abs()) {
        return format!("{x:.6e}");
    }
    let text = format!("{x:.digits$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_as_they_were_written() {
        for (x, unit, expected) in [
            (3.0 / 25.4, LengthUnit::Inch, "3mm"),
            (12.345 / 25.4, LengthUnit::Inch, "12.345mm"),
            (0.1875, LengthUnit::Inch, "0.1875inch"),
            (1.1, LengthUnit::Inch, "1.1inch"),
            (1.0 / 3.0, LengthUnit::Inch, "0.3333333inch"),
            (25.4, LengthUnit::Millimetre, "25.4mm"),
            (0.001 * 25.4, LengthUnit::Millimetre, "0.0254mm"),
            (2.0f64.sqrt(), LengthUnit::Millimetre, "1.414214mm"),
            (0.0, LengthUnit::Inch, "0inch"),
            (-0.0, LengthUnit::Metre, "0m"),
            (-3.0 / 25.4, LengthUnit::Inch, "-3mm"),
        ] {
            assert_eq!(length(x, unit), expected);
        }
        assert_eq!(significant(-0.0), "0");
    }
}
