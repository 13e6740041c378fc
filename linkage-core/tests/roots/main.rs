//! Listing all solutions of polynomial systems.

mod counts;
mod digits;
mod ends;
mod extremes;
mod groups;
mod known;
mod laurent;
mod singular;
mod small;
mod triad;

use laurent::Complex;

/// Whether one of the solutions has these values.
fn has(solutions: &[Vec<[f64; 2]>], values: &[Complex], tolerance: f64) -> bool {
    let near = |solution: &Vec<[f64; 2]>| {
        let pairs = solution.iter().zip(values);
        pairs
            .map(|(&[re, im], value)| (re - value.re).hypot(im - value.im))
            .all(|distance| distance < tolerance)
    };
    solutions.iter().any(near)
}
