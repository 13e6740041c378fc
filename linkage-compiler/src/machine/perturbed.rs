//! Dimensions near the written ones: a property that holds for them, too, holds by the mechanism's
//! shape and not by chance.

use crate::algebra::Nominal;
use crate::model::{Dimension, Mechanism};

/// The approximate share by which dimensions are altered: values equal by chance then differ by far
/// more than rounding, and a mechanism that is not at a limit still closes.
const ALTERED: f64 = 1e-3;

/// The number of times all dimensions are altered. Each is altered by a share of its own, and one
/// alteration would do; the second one guards against a share that is the right one by chance.
pub(crate) const ALTERATIONS: usize = 2;

/// Dimensions that differ a little from those that are written, each by a share of its own.
pub(crate) fn altered(
    mechanism: &Mechanism,
    nominal: &Nominal,
    longest: f64,
    number: usize,
) -> Vec<f64> {
    let each = nominal.parameters.iter().zip(&mechanism.scalar_parameters);
    each.enumerate()
        .map(|(index, (&value, parameter))| {
            let share = ALTERED * scattered(index, number);
            let is_length = parameter.dimension.fits(Dimension::LENGTH);
            match (value == 0.0, is_length) {
                (false, _) => value * (1.0 + share),
                (true, true) => longest * share,
                (true, false) => share,
            }
        })
        .collect()
}

/// Returns a number between -1 and 1, not too small. The numbers are unrelated to each other: a
/// relation that holds for them holds in general.
pub(crate) fn scattered(index: usize, number: usize) -> f64 {
    // Multiples of irrational numbers are spread evenly, and far from those of others.
    let x = (index + 1) as f64 * 0.754_877_666 + (number + 1) as f64 * 0.569_840_291;
    let y = ((index + 1) * (number + 1)) as f64 * 0.362_436_069;
    let size = 0.3 + 0.7 * (x + y).fract();
    if (17.0 * x + 31.0 * y).fract() < 0.5 {
        -size
    } else {
        size
    }
}
