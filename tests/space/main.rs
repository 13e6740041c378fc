//! Mechanisms in space that several groups, or none of the closed forms, make up: their loops close, all assemblies are found, derivatives are
//! those of differences, plane and space meet.

mod bennett;
mod bodies;
mod cylindrical;
mod mixed;
mod newton;
mod octahedral;
mod octahedral_bodies;
mod parallelograms;
mod platform;
mod rocking_sleeve;
mod sarrus;
mod sleds;
mod stacked;
mod swashplate;

use linkage::Vector3;

/// Rodrigues' rotation, written independently of the compiler's.
fn turned(v: Vector3<f64>, axis: Vector3<f64>, angle: f64) -> Vector3<f64> {
    let unit = nalgebra::Unit::new_normalize(axis);
    nalgebra::Rotation3::from_axis_angle(&unit, angle) * v
}

/// First and second derivative by differences.
fn differences(f: impl Fn(f64) -> f64, x: f64, step: f64) -> [f64; 2] {
    let [before, here, after] = [x - step, x, x + step].map(f);
    [
        (after - before) / (2.0 * step),
        (after - 2.0 * here + before) / (step * step),
    ]
}

#[track_caller]
fn close(found: f64, expected: f64, tolerance: f64) {
    let size = 1.0 + expected.abs();
    assert!(
        (found - expected).abs() <= tolerance * size,
        "{found} instead of {expected}"
    );
}
