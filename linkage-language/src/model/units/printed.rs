//! The units in which numbers are given and printed.

use super::conversion::{Literal, convert_product};
use crate::model::types::{Dimension, LengthUnit, raised};

impl Dimension {
    /// Returns the unit of a quantity: `mm`, `N*mm`, `kg*mm^2`, `1/s`, `mm^(1/2)`, `rad`, an empty
    /// text for a number.
    pub fn unit(self, length: LengthUnit) -> String {
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

    /// Returns the value of one [unit](Dimension::unit) in the program, which computes in newtons,
    /// seconds and the length unit. It is not 1 only if the unit has kilograms.
    pub fn internal_per_unit(self, length: LengthUnit) -> f64 {
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
