//! Lengths in metres.

use super::space_vectors::Vector;
use crate::failure::Failure;

/// A length unit in metres: a factor and a divisor, one of which is 1, so that 40 mm are the number
/// nearest to 0.04.
#[derive(Clone, Copy, Debug)]
pub(super) struct Metres {
    factor: f64,
    divisor: f64,
}

impl Metres {
    /// The metres of a length unit of the language.
    pub(super) fn of_unit(unit: &str) -> Result<Self, Failure> {
        let (factor, divisor) = match unit {
            "m" => (1.0, 1.0),
            "cm" => (1.0, 100.0),
            "mm" => (1.0, 1e3),
            "um" => (1.0, 1e6),
            "inch" => (0.0254, 1.0),
            other => {
                return Err(Failure::Told(format!(
                    "lengths in `{other}` are not written in metres"
                )));
            }
        };
        Ok(Self { factor, divisor })
    }

    pub(super) fn length(self, value: f64) -> f64 {
        value * self.factor / self.divisor
    }

    pub(super) fn vector(self, value: Vector) -> Vector {
        value.map(|component| self.length(component))
    }

    /// A square of lengths.
    pub(super) fn square(self, value: f64) -> f64 {
        value * (self.factor * self.factor) / (self.divisor * self.divisor)
    }
}
