//! The length unit of a mechanism.

use crate::syntax::{Word, find_unit, first_spelling, vocabulary};

vocabulary! {
    /// The length unit of fields and results.
    pub enum LengthUnit {
        /// Metres.
        Metre = "m",
        /// Millimetres.
        Millimetre = "mm",
        /// Centimetres.
        Centimetre = "cm",
        /// Micrometres.
        Micrometre = "um",
        /// Inches of 25.4 mm.
        Inch = "inch",
    }
}

impl LengthUnit {
    /// The unit of `unit NAME;`, in any spelling.
    pub fn from_name(name: &str) -> Option<LengthUnit> {
        LengthUnit::from_word(first_spelling(name)?)
    }

    /// Returns the unit in metres, up to rounding.
    pub fn metres(self) -> f64 {
        let unit = find_unit(self.name()).expect("every length unit is a unit of measure");
        unit.scale.factor()
    }

    /// `m`, `mm`, ...
    pub fn name(self) -> &'static str {
        self.word()
    }
}
