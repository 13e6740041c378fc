//! Mechanisms in space that several groups, or none of the closed forms, make up: their loops close, all assemblies are found, derivatives are
//! those of differences, plane and space meet.

mod bodies;
mod cylindrical;
mod octahedral;
mod octahedral_bodies;
mod parallelograms;
mod platform;
mod sarrus;
mod sleds;
mod stacked;
mod swashplate;

use linkage::Vector3;
use linkage_random::Random;
use nalgebra::{DMatrix, DVector};

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

// All solutions of a small system by Newton's method from many places: an independent count.

/// Distinct solutions of `f(x) = 0` reached from random places `from[k] .. to[k]`; `same` tells which are one.
pub(crate) fn all_solutions<const N: usize>(
    f: impl Fn([f64; N]) -> [f64; N],
    [from, to]: [[f64; N]; 2],
    same: impl Fn([f64; N], [f64; N]) -> bool,
    tries: usize,
) -> Vec<[f64; N]> {
    let mut random = Random::new(0x2545_f491_4f6c_dd1d);
    let mut found: Vec<[f64; N]> = Vec::new();
    for _ in 0..tries {
        let start: [f64; N] = std::array::from_fn(|k| random.between(from[k], to[k]));
        if let Some(x) = solve(&f, start)
            && !found.iter().any(|&y| same(x, y))
        {
            found.push(x);
        }
    }
    found
}

/// Newton's method with a Jacobian by differences.
pub(crate) fn solve<const N: usize>(
    f: impl Fn([f64; N]) -> [f64; N],
    mut x: [f64; N],
) -> Option<[f64; N]> {
    for _ in 0..60 {
        let here = f(x);
        let columns: [[f64; N]; N] = std::array::from_fn(|k| {
            let step = 1e-6 * (1.0 + x[k].abs());
            let (mut low, mut high) = (x, x);
            low[k] -= step;
            high[k] += step;
            let (low, high) = (f(low), f(high));
            std::array::from_fn(|row| (high[row] - low[row]) / (2.0 * step))
        });
        let matrix = DMatrix::from_fn(N, N, |row, column| columns[column][row]);
        let change = matrix
            .full_piv_lu()
            .solve(&DVector::from_row_slice(&here))?;
        let size = change.norm();
        // Far from a solution the steps are limited.
        let factor = (30.0 / size).min(1.0);
        (0..N).for_each(|k| x[k] -= factor * change[k]);
        if !size.is_finite() {
            return None;
        }
        if size < 1e-12 * (1.0 + x.iter().map(|x| x.abs()).fold(0.0, f64::max)) {
            let left = f(x).into_iter().map(f64::abs).fold(0.0, f64::max);
            return (left < 1e-8).then_some(x);
        }
    }
    None
}
