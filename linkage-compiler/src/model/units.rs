//! The units of literals: one table.

use super::decimal::Decimal;
use super::types::{Dimension, LengthUnit};

/// How many digits of pi are multiplied: far more than a double's literal can tell apart.
const PI: &str = "3.14159265358979323846264338327950288419716939937510582097494459230781640628620899\
                  8628034825342117067982148086513282306647";

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Unit {
    /// Metres, times ten to this power.
    Metric(i64),
    Inch,
    Radian,
    /// This many make half a turn.
    PerHalfTurn(u32),
    Turn,
}

const UNITS: [(&str, Unit); 13] = [
    ("m", Unit::Metric(0)),
    ("mm", Unit::Metric(-3)),
    ("cm", Unit::Metric(-2)),
    ("um", Unit::Metric(-6)),
    // The micro sign and the Greek letter look alike.
    ("\u{b5}m", Unit::Metric(-6)),
    ("\u{3bc}m", Unit::Metric(-6)),
    ("nm", Unit::Metric(-9)),
    ("inch", Unit::Inch),
    ("deg", Unit::PerHalfTurn(180)),
    ("rad", Unit::Radian),
    ("arcmin", Unit::PerHalfTurn(180 * 60)),
    ("arcsec", Unit::PerHalfTurn(180 * 3600)),
    ("turn", Unit::Turn),
];

/// The units as messages list them.
pub(crate) const UNIT_NAMES: [&str; 11] = [
    "m", "mm", "cm", "um", "nm", "inch", "deg", "rad", "arcmin", "arcsec", "turn",
];

/// The length units that a mechanism can have, as messages list them.
pub(super) const LENGTH_UNIT_NAMES: [&str; 5] = ["m", "mm", "cm", "um", "inch"];

/// Whether this is the suffix of a literal.
pub(crate) fn is_unit(name: &str) -> bool {
    find(name).is_some()
}

fn find(name: &str) -> Option<Unit> {
    UNITS
        .iter()
        .find(|(known, _)| *known == name)
        .map(|(_, unit)| *unit)
}

impl LengthUnit {
    /// The unit of `unit NAME;`.
    pub fn from_name(name: &str) -> Option<LengthUnit> {
        Some(match name {
            "m" => LengthUnit::Metre,
            "mm" => LengthUnit::Millimetre,
            "cm" => LengthUnit::Centimetre,
            "um" | "\u{b5}m" | "\u{3bc}m" => LengthUnit::Micrometre,
            "inch" => LengthUnit::Inch,
            _ => return None,
        })
    }

    /// `m`, `mm`, ...
    pub fn name(self) -> &'static str {
        match self {
            LengthUnit::Metre => "m",
            LengthUnit::Millimetre => "mm",
            LengthUnit::Centimetre => "cm",
            LengthUnit::Micrometre => "um",
            LengthUnit::Inch => "inch",
        }
    }

    fn unit(self) -> Unit {
        match self {
            LengthUnit::Metre => Unit::Metric(0),
            LengthUnit::Millimetre => Unit::Metric(-3),
            LengthUnit::Centimetre => Unit::Metric(-2),
            LengthUnit::Micrometre => Unit::Metric(-6),
            LengthUnit::Inch => Unit::Inch,
        }
    }
}

impl Dimension {
    /// The unit of a quantity: `mm`, `mm^2`, `mm^(1/2)`, `rad`, nothing for a number.
    pub fn unit(self, length: LengthUnit) -> String {
        let word = length.name();
        match self.half_lengths {
            0 if self.angle => "rad".to_owned(),
            0 => String::new(),
            2 => word.to_owned(),
            halves if halves % 2 == 0 => format!("{word}^{}", halves / 2),
            halves => format!("{word}^({halves}/2)"),
        }
    }
}

/// A literal in the mechanism's unit or in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Literal {
    /// Zero without a unit fits every dimension.
    BareZero,
    Value(f64, Dimension),
    TooLarge,
    TooSmall,
    /// Not digits, or an unknown unit.
    Malformed,
}

/// Converts a literal, rounding once.
pub(super) fn convert(text: &str, suffix: &str, length: LengthUnit) -> Literal {
    let Some(decimal) = Decimal::parse(text) else {
        return Literal::Malformed;
    };
    let (converted, dimension) = match find(suffix) {
        None if suffix.is_empty() => (decimal, Dimension::NUMBER),
        None => return Literal::Malformed,
        Some(unit @ (Unit::Metric(_) | Unit::Inch)) => (
            convert_length(decimal, unit, length.unit()),
            Dimension::LENGTH,
        ),
        Some(unit) => (convert_angle(decimal, unit), Dimension::ANGLE),
    };
    let value = converted.to_f64();
    match () {
        () if converted.is_zero() && suffix.is_empty() => Literal::BareZero,
        () if value.is_infinite() => Literal::TooLarge,
        () if value == 0.0 && !converted.is_zero() => Literal::TooSmall,
        () => Literal::Value(value, dimension),
    }
}

fn convert_length(value: Decimal, from: Unit, to: Unit) -> Decimal {
    let millimetres_per_inch = || Decimal::parse("25.4").expect("a number");
    match (from, to) {
        (Unit::Metric(from), Unit::Metric(to)) => value.shifted(from - to),
        (Unit::Inch, Unit::Metric(to)) => value.times(&millimetres_per_inch()).shifted(-3 - to),
        // 25.4 mm are 254 of the unit 1e-4 m.
        (Unit::Metric(from), Unit::Inch) => value.shifted(from + 4).over(254),
        _ => value,
    }
}

fn convert_angle(value: Decimal, unit: Unit) -> Decimal {
    let pi = || Decimal::parse(PI).expect("a number");
    match unit {
        Unit::PerHalfTurn(parts) => value.times(&pi()).over(parts),
        Unit::Turn => value
            .times(&pi())
            .times(&Decimal::parse("2").expect("a number")),
        _ => value,
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
        for line in include_str!("angles.txt").lines() {
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
    fn listed_units_are_in_the_table() {
        assert!(UNIT_NAMES.iter().all(|name| is_unit(name)));
        assert!(
            LENGTH_UNIT_NAMES
                .iter()
                .all(|name| LengthUnit::from_name(name).is_some())
        );
    }
}
