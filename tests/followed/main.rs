//! Groups whose solutions cannot be listed, followed from the estimates of their unknowns: wheel suspensions by the travel of the wheel, the
//! platform on six legs. Every position against 25 digits of published geometries' solutions, computed with 80.

mod body;
mod double_wishbone;
mod five_link_axle;
mod hexapod;
mod independent;
mod random_axles;
mod random_hexapods;

use serde_json::Value;

/// The joints of the six legs on the ground, and on the platform.
const FEET: [[f64; 3]; 6] = [
    [310.0, 40.0, -12.0],
    [180.0, 275.0, 18.0],
    [-120.0, 300.0, -25.0],
    [-325.0, 60.0, 10.0],
    [-150.0, -290.0, 22.0],
    [205.0, -250.0, -8.0],
];
const JOINTS: [[f64; 3]; 6] = [
    [150.0, -60.0, -14.0],
    [130.0, 85.0, 9.0],
    [10.0, 160.0, -11.0],
    [-145.0, 75.0, 16.0],
    [-120.0, -105.0, -7.0],
    [35.0, -155.0, 12.0],
];

/// Whether the long runs are asked for.
fn long() -> bool {
    std::env::var_os("LINKAGE_LONG").is_some()
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
