//! The four-bar with the gradients of symdiff: `x` has the angle of the crank and seven dimensions.

// Of the generated gradients.
#![allow(missing_docs)]

use symdiff::gradient;

/// The tracer point along the frame; `x_gradient` has its derivatives.
#[gradient(var = x, dim = 8)]
pub fn along(x: &[f64]) -> f64 {
    let ax = x[1] * x[0].cos();
    let ay = x[1] * x[0].sin();
    let lx = x[4] - ax;
    let ly = x[5] - ay;
    let square = lx.powi(2) + ly.powi(2);
    let part = (square + x[2].powi(2) - x[3].powi(2)) / (2.0 * square);
    let across = (x[2].powi(2) / square - part.powi(2)).sqrt();
    let bx = lx * part - ly * across;
    let by = ly * part + lx * across;
    ax + (bx * x[7].cos() - by * x[7].sin()) * x[6] / x[2]
}

/// The tracer point across the frame; `across_gradient` has its derivatives.
#[gradient(var = x, dim = 8)]
pub fn across(x: &[f64]) -> f64 {
    let ax = x[1] * x[0].cos();
    let ay = x[1] * x[0].sin();
    let lx = x[4] - ax;
    let ly = x[5] - ay;
    let square = lx.powi(2) + ly.powi(2);
    let part = (square + x[2].powi(2) - x[3].powi(2)) / (2.0 * square);
    let across = (x[2].powi(2) / square - part.powi(2)).sqrt();
    let bx = lx * part - ly * across;
    let by = ly * part + lx * across;
    ay + (bx * x[7].sin() + by * x[7].cos()) * x[6] / x[2]
}
