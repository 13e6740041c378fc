//! Derivatives as differences: of inputs, and of dimensions.

use nalgebra::Vector3;

use super::close;

/// Steps of inputs and dimensions, in mm.
pub(super) const STEP: f64 = 1e-2;

/// Differences over such steps are off by this part of the largest number of their kind, at most.
const OFF: f64 = 1e-6;

/// `scale` is the largest number of the kind.
#[track_caller]
pub(super) fn near(found: Vector3<f64>, [after, before]: [Vector3<f64>; 2], scale: f64) {
    let expected = (after - before) / (2.0 * STEP);
    let pairs = found.iter().zip(&expected);
    pairs.for_each(|(&found, &expected)| close(found, expected, scale, OFF));
}
