//! A few positions at which things are looked at on numbers.

use crate::algebra::Nominal;
use crate::model::{Dimension, Mechanism};

/// Places in the declared ranges beside the reference, as shares.
const PLACES: [f64; 4] = [0.137, 0.391, 0.642, 0.871];

/// The reference and other positions.
pub(crate) fn places(nominal: &Nominal, mechanism: &Mechanism, longest: f64) -> Vec<Vec<f64>> {
    let mut places = vec![nominal.inputs.clone()];
    for share in PLACES {
        let inputs = nominal.inputs.iter().zip(&nominal.ranges).enumerate();
        let place = inputs.map(|(k, (&at, range))| match range {
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
        places.push(place.collect());
    }
    places
}
