//! Tolerance analysis and allocation.
#![cfg(feature = "tolerance")]

mod allocation;
mod cycle;
mod eye_needle;
mod grades;
mod input;
mod least_cost;
mod modulus;
#[cfg(feature = "monte-carlo")]
mod monte_carlo;
#[cfg(feature = "monte-carlo")]
mod statistics;
#[cfg(feature = "monte-carlo")]
mod stream;

use linkage_analysis::tolerance::Tolerances;
use linkage_runtime::Parameter;

/// `N` lengths of 50 mm.
fn lengths<const N: usize>() -> [Parameter; N] {
    const NAMES: [&str; 16] = [
        "a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m", "n", "o", "p",
    ];
    std::array::from_fn(|i| Parameter {
        name: NAMES[i],
        unit: "mm",
        nominal: 50.0,
        tolerance: 1.0,
    })
}

/// A tolerance of 1 for each parameter.
fn ones<const N: usize>() -> Tolerances<N> {
    Tolerances::declared(&lengths::<N>()).expect("they are valid")
}

fn near(value: f64, known: f64, error: f64) {
    assert!((value - known).abs() <= error, "{value} instead of {known}");
}
