//! The range of an input over which angles are followed.

use std::f64::consts::PI;

use crate::algebra::{Algebra, Nominal};

/// Returns the range over which an angle is followed along an input: the declared one, else a turn
/// about the reference for an angle, only the reference for a length.
pub(crate) fn followed_range(algebra: &Algebra, nominal: &Nominal, input: usize) -> (f64, f64) {
    let reference = nominal.inputs[input];
    let half = match algebra.mechanism.inputs[input].dimension.half_lengths {
        0 => PI,
        _ => 0.0,
    };
    nominal.ranges[input].unwrap_or((reference - half, reference + half))
}
