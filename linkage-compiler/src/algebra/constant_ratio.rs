//! Angles that turn evenly with an input.

use linkage_core::range_check::significant;

use crate::algebra::names::Names;
use crate::algebra::value::Atom;

/// Angles that differ by less turn alike.
pub(crate) const ALIKE: f64 = 1e-9;

/// An unknown angle that turns evenly with an input: `offset + rate * input`.
pub(crate) struct ConstantRatio {
    pub(crate) unknown: usize,
    pub(crate) rate: f64,
    pub(crate) offset: f64,
}

impl ConstantRatio {
    /// `phi`, `2 * phi - 30deg`, `0deg`
    pub(crate) fn relation(&self, input: &str) -> String {
        let offset = if self.offset.abs() < ALIKE {
            0.0
        } else {
            self.offset
        };
        let shown = |x: f64| format!("{}deg", significant(x.to_degrees()));
        let turning = match self.rate {
            0.0 => return shown(offset),
            1.0 => input.to_owned(),
            -1.0 => format!("-{input}"),
            rate => format!("{rate} * {input}"),
        };
        match offset {
            0.0 => turning,
            positive if positive > 0.0 => format!("{turning} + {}", shown(positive)),
            negative => format!("{turning} - {}", shown(-negative)),
        }
    }
}

/// Turns that an unknown angle may make for each turn of an input: the rates at which vectors turn
/// with it, and simple multiples.
pub(crate) fn candidate_rates(names: &Names<'_>, input: usize) -> Vec<f64> {
    let mut rates = vec![0.0];
    if names.mechanism.inputs[input].dimension.half_lengths != 0 {
        return rates;
    }
    for base in [1.0]
        .into_iter()
        .chain(names.input_rates(Atom::Input(input)))
    {
        for factor in [1.0, -1.0, 2.0, -2.0, 0.5, -0.5] {
            let rate = base * factor;
            if rate != 0.0 && !rates.contains(&rate) {
                rates.push(rate);
            }
        }
    }
    rates
}
