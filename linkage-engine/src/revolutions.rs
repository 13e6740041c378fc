//! Revolutions of continuous angles.

use crate::mechanism::Mechanism;

/// The centre of each angle, and the turns it makes for each turn of each input.
#[derive(Clone, Debug)]
pub(crate) struct Revolutions {
    pub(crate) centres: Vec<f64>,
    pub(crate) windings: Vec<Vec<f64>>,
}

impl Revolutions {
    /// Centres at the start estimates, no winding.
    pub(crate) fn at_estimates(mechanism: &Mechanism) -> Self {
        let angles = &mechanism.angles;
        Self {
            centres: angles.iter().map(|angle| angle.estimate).collect(),
            windings: vec![vec![0.0; mechanism.inputs.len()]; angles.len()],
        }
    }
}
