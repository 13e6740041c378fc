//! Literals and the units that they are multiplied with: exact arithmetic, rounded once.

use std::collections::BTreeMap;

use super::decimal::Decimal;
use crate::model::types::{Dimension, LengthUnit};
use crate::syntax::{Scale, UnitOfMeasure, Word, find_unit, is_unit};

/// Digits of pi for multiplication: far more than a literal of a double can distinguish.
const PI: &str = "3.14159265358979323846264338327950288419716939937510582097494459230781640628620899\
                  8628034825342117067982148086513282306647";
/// Its reciprocal.
const PER_PI: &str = "0.31830988618379067153776752674502872406891929148091289749533468811779359526845307\
                      01802276055325061719121456";
/// Factors of one kind beyond this are taken for a mistake.
const LIMIT: i32 = 64;

/// A literal in the unit of its dimension: the mechanism's length unit, radians, newtons, seconds,
/// kilograms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::model) enum Literal {
    /// Zero without a unit fits every dimension.
    BareZero,
    Value(f64, Dimension),
    TooLarge,
    TooSmall,
    /// A power of a unit beyond all use.
    Beyond,
    /// Not digits, or an unknown unit.
    Malformed,
}

/// Converts a literal, rounding once.
pub(in crate::model) fn convert(text: &str, suffix: &str, length: LengthUnit) -> Literal {
    match suffix {
        "" => convert_product(text, &[], length),
        _ => convert_product(text, &[(suffix, 1)], length),
    }
}

/// Converts a literal with factors, each a unit and its power, rounding once.
pub(in crate::model) fn convert_product(
    text: &str,
    factors: &[(&str, i32)],
    length: LengthUnit,
) -> Literal {
    let Some(decimal) = Decimal::parse(text) else {
        return Literal::Malformed;
    };
    if factors.iter().any(|(name, _)| !is_unit(name)) {
        return Literal::Malformed;
    }
    let Some((factor, dimension)) = Factor::from_units(factors, length) else {
        return Literal::Beyond;
    };
    let converted = factor.times(decimal);
    let value = converted.to_f64();
    match () {
        () if converted.is_zero() && factors.is_empty() => Literal::BareZero,
        () if value.is_infinite() => Literal::TooLarge,
        () if value == 0.0 && !converted.is_zero() => Literal::TooSmall,
        () => Literal::Value(value, dimension),
    }
}

/// Returns the dimension of a unit.
pub(in crate::model) fn dimension_of(unit: UnitOfMeasure) -> Dimension {
    Dimension {
        half_kilograms: 2 * unit.kilograms,
        angle: unit.angle,
        ..Dimension::from_powers(
            unit.metres - unit.kilograms,
            unit.newtons + unit.kilograms,
            unit.seconds + 2 * unit.kilograms,
        )
    }
}

impl LengthUnit {
    /// Returns its length in another unit.
    pub fn in_units_of(self, other: LengthUnit) -> f64 {
        match convert("1", self.word(), other) {
            Literal::Value(number, _) => number,
            // Units of length have no other.
            _ => f64::NAN,
        }
    }
}

/// A product of scales.
#[derive(Default)]
struct Factor {
    ten: i64,
    pi: i32,
    whole: BTreeMap<u64, i32>,
}

impl Factor {
    /// Converts a product of units to the unit of its dimension; `None` for powers that are too
    /// large.
    fn from_units(units: &[(&str, i32)], length: LengthUnit) -> Option<(Factor, Dimension)> {
        let mut factor = Factor::default();
        let mut dimension = Dimension::NUMBER;
        let mut metres = 0;
        for (name, power) in units {
            let unit = find_unit(name)?;
            dimension = dimension.times(dimension_of(unit).to_the(*power)?)?;
            factor.include(unit.scale, *power)?;
            metres += unit.metres * power;
        }
        factor.include(find_unit(length.name())?.scale, -metres)?;
        Some((factor, dimension))
    }

    fn include(&mut self, scale: Scale, power: i32) -> Option<()> {
        self.ten += scale.ten * i64::from(power);
        self.pi += scale.pi * power;
        for &(number, exponent) in scale.wholes {
            *self.whole.entry(number).or_default() += exponent * power;
        }
        let counts = self.whole.values().chain([&self.pi]);
        counts
            .map(|count| count.abs())
            .all(|count| count <= LIMIT)
            .then_some(())
    }

    fn times(&self, mut value: Decimal) -> Decimal {
        let number = |text: &str| Decimal::parse(text).expect("a number");
        if self.pi != 0 {
            let pi = number(if self.pi > 0 { PI } else { PER_PI });
            for _ in 0..self.pi.abs() {
                value = value.times(&pi);
            }
        }
        for (whole, count) in &self.whole {
            let factor = number(&whole.to_string());
            for _ in 0..*count {
                value = value.times(&factor);
            }
        }
        for (whole, count) in &self.whole {
            for _ in *count..0 {
                value = value.over(*whole);
            }
        }
        value.shifted(self.ten)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_6, PI, TAU};

    use super::*;

    fn value(text: &str, suffix: &str, length: LengthUnit) -> f64 {
        match convert(text, suffix, length) {
            Literal::Value(value, _) => value,
            other => panic!("{text}{suffix}: {other:?}"),
        }
    }

    #[test]
    fn lengths_are_rounded_once() {
        use LengthUnit::{Centimetre, Inch, Metre, Micrometre, Millimetre};
        for (text, suffix, unit, expected) in [
            ("12", "um", Millimetre, 0.012),
            ("12", "\u{b5}m", Millimetre, 0.012),
            ("12", "\u{3bc}m", Millimetre, 0.012),
            ("30.1", "mm", Metre, 0.0301),
            ("1", "m", Micrometre, 1e6),
            ("0.3", "cm", Millimetre, 3.0),
            ("7", "nm", Centimetre, 7e-7),
            ("1", "inch", Millimetre, 25.4),
            ("0.1", "inch", Metre, 0.00254),
            ("3", "inch", Inch, 3.0),
            ("25.4", "mm", Inch, 1.0),
            ("2.54", "um", Inch, 1e-4),
            ("1e3", "mm", Metre, 1.0),
            ("0", "mm", Metre, 0.0),
        ] {
            assert_eq!(value(text, suffix, unit), expected, "{text}{suffix}");
        }
    }

    #[test]
    fn round_angles_are_the_constants() {
        let angle = |text, suffix| value(text, suffix, LengthUnit::Metre);
        assert_eq!(angle("90", "deg"), FRAC_PI_2);
        assert_eq!(angle("30", "deg"), FRAC_PI_6);
        assert_eq!(angle("180", "deg"), PI);
        assert_eq!(angle("360", "deg"), TAU);
        assert_eq!(angle("1", "turn"), TAU);
        assert_eq!(angle("5400", "arcmin"), FRAC_PI_2);
        assert_eq!(angle("648000", "arcsec"), PI);
        assert_eq!(angle("0.25", "rad"), 0.25);
    }

    #[test]
    fn angles_agree_with_high_precision() {
        for line in include_str!("../../../tests/angles.txt").lines() {
            let mut words = line.split(' ');
            let mut word = || words.next().expect("number, unit and bits");
            let (text, suffix) = (word(), word());
            let bits = u64::from_str_radix(word(), 16).expect("bits in hexadecimal");
            let found = value(text, suffix, LengthUnit::Metre);
            assert_eq!(found, f64::from_bits(bits), "{text}{suffix}");
        }
    }

    #[test]
    fn range_of_the_numbers() {
        let convert = |text, suffix| convert(text, suffix, LengthUnit::Metre);
        assert_eq!(convert("0.0", ""), Literal::BareZero);
        assert_eq!(convert("0", "deg"), Literal::Value(0.0, Dimension::ANGLE));
        assert_eq!(convert("1e400", ""), Literal::TooLarge);
        assert_eq!(convert("1e-400", "mm"), Literal::TooSmall);
        assert_eq!(convert("1e-320", "nm"), Literal::TooSmall);
        assert_eq!(convert("1e308", "turn"), Literal::TooLarge);
        assert_eq!(convert("1", "furlong"), Literal::Malformed);
    }

    #[test]
    fn length_units_are_in_the_table() {
        for unit in LengthUnit::all() {
            let found = find_unit(unit.word()).map(dimension_of);
            assert_eq!(found, Some(Dimension::LENGTH), "{}", unit.word());
        }
        assert_eq!(
            LengthUnit::from_name("\u{b5}m"),
            Some(LengthUnit::Micrometre)
        );
    }
}
