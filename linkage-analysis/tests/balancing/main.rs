//! Balancing: known optima, other methods, proofs of optimality, extremes, wrong input.
#![cfg(feature = "std")]

mod counterweight;
mod extremes;
mod input;
mod known;
mod optimal;

use std::f64::consts::TAU;

/// Evenly spaced angles.
fn angles(count: u32) -> impl Iterator<Item = f64> {
    (0..count).map(move |i| TAU * f64::from(i) / f64::from(count))
}

/// The effects of two masses at the same radius on a crank, 90 degrees apart, of 1 N each.
fn crank(count: u32) -> Vec<[[f64; 2]; 2]> {
    angles(count)
        .map(|phi| [[phi.cos(), phi.sin()], [-phi.sin(), phi.cos()]])
        .collect()
}

fn near(value: f64, known: f64, error: f64) {
    assert!((value - known).abs() <= error, "{value} instead of {known}");
}
