//! Inputs besides the reference at which a property is tested on numbers.

use crate::algebra::Nominal;
use crate::model::{Dimension, Mechanism};

/// Other positions in the declared ranges, as shares.
const SHARES: [f64; 4] = [0.137, 0.391, 0.642, 0.871];

/// Returns the reference inputs, then other ones.
pub(crate) fn other_inputs(
    nominal: &Nominal,
    mechanism: &Mechanism,
    longest: f64,
) -> Vec<Vec<f64>> {
    let mut positions = vec![nominal.inputs.clone()];
    for share in SHARES {
        let inputs = nominal.inputs.iter().zip(&nominal.ranges).enumerate();
        let position = inputs.map(|(k, (&at, range))| match range {
            // Near the reference, where it surely closes.
            None => {
                let unit = match mechanism.inputs[k].dimension.fits(Dimension::LENGTH) {
                    true => longest,
                    false => 1.0,
                };
                at + 0.02 * unit * (share * (k + 1) as f64).fract()
            }
            // Several inputs do not move in step.
            Some((low, high)) => low + (share * (k + 1) as f64).fract() * (high - low),
        });
        positions.push(position.collect());
    }
    positions
}
