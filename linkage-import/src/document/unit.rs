//! Units of lengths in files.

/// A unit of lengths.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LengthUnit {
    Millimetre,
    Centimetre,
    Metre,
    Inch,
}

impl LengthUnit {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Millimetre => "mm",
            Self::Centimetre => "cm",
            Self::Metre => "m",
            Self::Inch => "inch",
        }
    }

    /// Returns the unit of a name in a file.
    pub(crate) fn named(name: &str) -> Option<Self> {
        match &name.trim().to_ascii_lowercase()[..] {
            "mm" | "millimetre" | "millimeter" | "millimetres" | "millimeters" => {
                Some(Self::Millimetre)
            }
            "cm" | "centimetre" | "centimeter" | "centimetres" | "centimeters" => {
                Some(Self::Centimetre)
            }
            "m" | "metre" | "meter" | "metres" | "meters" => Some(Self::Metre),
            "inch" | "in" | "inches" => Some(Self::Inch),
            _ => None,
        }
    }
}
