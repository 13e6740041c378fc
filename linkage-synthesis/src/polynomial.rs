//! All roots of a polynomial of low degree.

use linkage_core::numeric::complex::{Complex, ONE, ZERO};
use std::vec::Vec;

/// The number of steps. Roots converge by squares (Ehrlich and Aberth): this is far more than
/// simple roots need, and useful digits of double ones need no more.
const STEPS: usize = 60;

/// The roots, from the coefficients (the constant first). Leading coefficients that are nothing
/// beside the others are left out: their roots are at infinity.
pub(super) fn roots(coefficients: &[Complex]) -> Vec<Complex> {
    let size = |coefficient: &Complex| coefficient.size();
    let largest = coefficients.iter().map(size).fold(0.0, f64::max);
    let counts = |coefficient: &Complex| size(coefficient) > f64::EPSILON * largest;
    let Some(degree) = coefficients.iter().rposition(counts) else {
        return Vec::new();
    };
    let coefficients = &coefficients[..=degree];
    let lead = coefficients[degree];
    // The mean size of the roots; angles without symmetry.
    let radius = (size(&coefficients[0]) / size(&lead)).powf(1.0 / degree.max(1) as f64);
    let start = |i: usize| Complex::polar(0.7 + 2.4 * i as f64).scaled(radius.max(f64::EPSILON));
    let mut roots: Vec<Complex> = (0..degree).map(start).collect();
    for _ in 0..STEPS {
        let mut moved = false;
        for i in 0..degree {
            let here = roots[i];
            let (value, slope) = value_and_slope(coefficients, here);
            if value == ZERO {
                continue;
            }
            let others = (0..degree).filter(|&j| j != i && roots[j] != here);
            let repulsion = others.fold(ZERO, |sum, j| sum + (here - roots[j]).inverse());
            let step = value * (slope - value * repulsion).inverse();
            if step.size() > f64::EPSILON * here.size() && step.size().is_finite() {
                roots[i] = here - step;
                moved = true;
            }
        }
        if !moved {
            break;
        }
    }
    roots
}

fn value_and_slope(coefficients: &[Complex], x: Complex) -> (Complex, Complex) {
    coefficients
        .iter()
        .rev()
        .fold((ZERO, ZERO), |(value, slope), &coefficient| {
            (value * x + coefficient, slope * x + value)
        })
}

/// The product of two polynomials, added with a factor to a third one.
pub(super) fn add_product<const N: usize>(
    sum: &mut [Complex; N],
    factors: [&[Complex]; 3],
    sign: f64,
) {
    let [a, b, c] = factors;
    let sign = ONE.scaled(sign);
    for (i, &a) in a.iter().enumerate() {
        for (j, &b) in b.iter().enumerate() {
            for (k, &c) in c.iter().enumerate() {
                sum[i + j + k] += sign * a * b * c;
            }
        }
    }
}
