//! Groups whose solutions cannot be listed, followed from the estimates of their unknowns: wheel suspensions by the travel of the wheel, the
//! platform on six legs. Every position against 25 digits of solutions of these geometries that were computed with 80, apart from this project.

mod body;
mod closest_approach;
mod double_wishbone;
mod five_link_axle;
mod hexapod;
#[path = "../programs/hexapod/geometry.rs"]
mod hexapod_geometry;
mod independent;
mod random_hexapods;
mod two_bodies;
mod wishbone_forms;

use hexapod_geometry::{FEET, JOINTS};
use nalgebra::Vector3;
use serde_json::Value;

/// Whether the long runs are asked for.
fn long() -> bool {
    std::env::var_os("LINKAGE_LONG").is_some()
}

/// Positions of the platform on six legs in 80 digits.
fn path_of_platform() -> Vec<Value> {
    read(include_str!("../../mechanisms/hexapod/reference.json"))
}

fn read(text: &str) -> Vec<Value> {
    serde_json::from_str(text).expect("JSON")
}

/// A number that is written as a string of digits.
#[track_caller]
fn number(value: &Value) -> f64 {
    let digits = value.as_str();
    let number = digits.and_then(|digits| digits.parse().ok());
    number.unwrap_or_else(|| panic!("a number: {value}"))
}

#[track_caller]
fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    std::array::from_fn(|k| number(&value[k]))
}

/// `tolerance` is that of a number of the size of `scale`.
#[track_caller]
fn close(found: f64, expected: f64, scale: f64, tolerance: f64) {
    assert!(
        (found - expected).abs() <= tolerance * scale,
        "{found} instead of {expected}, off by {:e} of {scale}",
        (found - expected).abs() / scale
    );
}

// Derivatives as differences: of inputs, and of dimensions.

/// Steps of inputs and dimensions, in mm.
const STEP: f64 = 1e-2;

/// Differences over such steps are off by this part of the largest number of their kind, at most.
const OFF: f64 = 1e-6;

/// `scale` is the largest number of the kind.
#[track_caller]
fn near(found: Vector3<f64>, [after, before]: [Vector3<f64>; 2], scale: f64) {
    let expected = (after - before) / (2.0 * STEP);
    let pairs = found.iter().zip(&expected);
    pairs.for_each(|(&found, &expected)| close(found, expected, scale, OFF));
}
