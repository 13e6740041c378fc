//! The length unit of a mechanism.

use crate::syntax::{Word, first_spelling, vocabulary};

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

    /// `m`, `mm`, ...
    pub fn name(self) -> &'static str {
        self.word()
    }
}
