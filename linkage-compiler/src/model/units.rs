//! What the units of literals are measured in, and which of them fields and results may have.

use super::conversion::{Literal, convert};
use super::types::Dimension;
use crate::syntax::{Unit, Word, first_spelling, vocabulary};

vocabulary! {
    /// The length unit of fields and results.
    pub(crate) enum LengthUnit {
        Metre = "m",
        Millimetre = "mm",
        Centimetre = "cm",
        Micrometre = "um",
        Inch = "inch",
    }
}

impl Unit {
    /// Its powers of length, force and time.
    pub(super) fn dimension(self) -> Dimension {
        Dimension {
            half_kilograms: 2 * self.kilograms,
            angle: self.angle,
            ..Dimension::of(
                self.metres - self.kilograms,
                self.newtons + self.kilograms,
                self.seconds + 2 * self.kilograms,
            )
        }
    }
}

impl LengthUnit {
    /// The unit of `unit NAME;`, in any spelling.
    pub(crate) fn from_name(name: &str) -> Option<LengthUnit> {
        LengthUnit::from_word(first_spelling(name)?)
    }

    /// How many of another unit it is.
    pub(crate) fn in_units_of(self, other: LengthUnit) -> f64 {
        match convert("1", self.word(), other) {
            Literal::Value(number, _) => number,
            // Units of length have no other.
            _ => f64::NAN,
        }
    }

    /// `m`, `mm`, ...
    pub(crate) fn name(self) -> &'static str {
        self.word()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::find_unit;

    #[test]
    fn length_units_are_in_the_table() {
        for unit in LengthUnit::all() {
            let found = find_unit(unit.word()).map(Unit::dimension);
            assert_eq!(found, Some(Dimension::LENGTH), "{}", unit.word());
        }
        assert_eq!(
            LengthUnit::from_name("\u{b5}m"),
            Some(LengthUnit::Micrometre)
        );
    }
}
