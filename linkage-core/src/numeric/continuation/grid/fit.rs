//! Polynomials over a cell of two inputs.

use super::super::follow::Follower;
use super::layout::Layout;
use super::node::Node;
use super::terms::{Terms, index};
use crate::scalar::Scalar;
use alloc::vec;
use alloc::vec::Vec;
use core::f64::consts::PI;

/// The places where polynomials over a cell are interpolated, and the weights for their
/// coefficients: the Padua points, as many as a degree has terms (Bos, Caliari, De Marchi,
/// Vianello, Xu: Bivariate Lagrange interpolation at the Padua points, 2006).
pub(super) struct Fit {
    /// Offsets from the centre, in cells, each with the weights of its value for all coefficients.
    points: Vec<([f64; 2], Vec<f64>)>,
    terms: Terms,
}

impl Fit {
    /// Returns the points for polynomials; slopes need none.
    pub(super) fn new(terms: Terms) -> Self {
        let points = match terms {
            Terms::Slopes => Vec::new(),
            Terms::Polynomials => points(terms.degree()),
        };
        Self { points, terms }
    }

    pub(super) fn terms(&self) -> Terms {
        self.terms
    }

    /// Puts polynomials through the solutions around a centre, of which the node knows the slopes.
    /// Where they do not all exist it stays as it is.
    pub(super) fn refine(
        &self,
        follower: &mut Follower<'_>,
        layout: &Layout<'_>,
        centre: &[f64],
        node: &mut Node,
    ) {
        let width = node.centre().len();
        let empty = layout.0.iter().any(|axis| axis.spacing() == 0.0);
        if self.points.is_empty() || empty {
            return;
        }
        let mut rows = vec![0.0; self.points[0].1.len() * width];
        let mut state = vec![0.0; width];
        for (offsets, weights) in &self.points {
            node.along_slopes(offsets, &mut state);
            let x = layout.moved(centre, offsets);
            if follower.settle_about(&x, &mut state).is_none() {
                return;
            }
            for (row, weight) in rows.chunks_exact_mut(width).zip(weights) {
                for (sum, number) in row.iter_mut().zip(&state) {
                    *sum += weight * number;
                }
            }
        }
        node.coefficients = rows;
    }
}

/// The Padua points of a degree, with their weights.
fn points(degree: usize) -> Vec<([f64; 2], Vec<f64>)> {
    let powers = powers(degree);
    let along = |number: usize, of: usize| Scalar::sin_cos(number as f64 * PI / of as f64).1;
    let mut points = Vec::new();
    for j in 0..=degree {
        for k in (0..=degree + 1).filter(|k| (j + k) % 2 == 0) {
            let at = [along(j, degree), along(k, degree + 1)];
            let ends = usize::from(j == 0 || j == degree) + usize::from(k == 0 || k == degree + 1);
            let weight = [2.0, 1.0, 0.5][ends] / (degree * (degree + 1)) as f64;
            points.push((at.map(|t| 0.5 * t), weights(&powers, degree, at, weight)));
        }
    }
    points
}

/// Returns the weights of the value at a point for all coefficients.
fn weights(powers: &[Vec<f64>], degree: usize, at: [f64; 2], weight: f64) -> Vec<f64> {
    let values = at.map(|t| chebyshev(degree, t));
    let mut all = vec![0.0; Terms::Polynomials.count(2)];
    for p in 0..=degree {
        for q in 0..=degree - p {
            // Those of degree 0 are half as long; the last one of the first input is counted twice
            // by this rule.
            let long = [1.0, 2.0, 4.0][usize::from(p > 0) + usize::from(q > 0)];
            let share = if p == degree { 0.5 } else { 1.0 };
            let factor = weight * long * share * values[0][p] * values[1][q];
            for a in 0..=p {
                for b in 0..=q {
                    // The offsets are halves of what the polynomials go along.
                    let halves = (1_u32 << (a + b)) as f64;
                    all[index(a, b)] += factor * powers[p][a] * powers[q][b] * halves;
                }
            }
        }
    }
    all
}

/// The values of the Chebyshev polynomials.
fn chebyshev(degree: usize, t: f64) -> Vec<f64> {
    let mut values = vec![1.0, t];
    for number in 2..=degree {
        values.push(2.0 * t * values[number - 1] - values[number - 2]);
    }
    values
}

/// The coefficients of the Chebyshev polynomials.
fn powers(degree: usize) -> Vec<Vec<f64>> {
    let mut all = vec![vec![0.0; degree + 1]; degree + 1];
    all[0][0] = 1.0;
    all[1][1] = 1.0;
    for number in 2..=degree {
        for power in 0..=number {
            let shifted = if power > 0 {
                all[number - 1][power - 1]
            } else {
                0.0
            };
            all[number][power] = 2.0 * shifted - all[number - 2][power];
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::continuation::grid::terms::values;

    const WIDTH: usize = Terms::Polynomials.count(2);

    /// The product of these powers of offsets from the centre.
    fn product(offsets: [f64; 2], a: usize, b: usize) -> f64 {
        let power = |x: f64, times: usize| (0..times).fold(1.0, |all, _| all * x);
        power(offsets[0], a) * power(offsets[1], b)
    }

    /// Returns the coefficients of the interpolation of a function.
    fn fitted(function: impl Fn([f64; 2]) -> f64) -> [f64; WIDTH] {
        let mut all = [0.0; WIDTH];
        for (offsets, weights) in Fit::new(Terms::Polynomials).points {
            for (sum, weight) in all.iter_mut().zip(weights) {
                *sum += weight * function(offsets);
            }
        }
        all
    }

    fn value(all: &[f64; WIDTH], offsets: [f64; 2]) -> f64 {
        values::<false, 1>(Terms::Polynomials, |term| [all[term]], &offsets)[0]
    }

    #[test]
    fn products_up_to_the_degree_are_their_own_terms() {
        let degree = Terms::Polynomials.degree();
        for sum in 0..=degree {
            for b in 0..=sum {
                let a = sum - b;
                let all = fitted(|offsets| product(offsets, a, b));
                for (number, found) in all.iter().enumerate() {
                    let wanted = f64::from(number == index(a, b));
                    assert!((found - wanted).abs() < 1e-10, "{a} {b}: {number} {found}");
                }
                for offsets in [[0.31, -0.47], [-0.5, 0.5], [0.11, 0.23]] {
                    let off = value(&all, offsets) - product(offsets, a, b);
                    assert!(off.abs() < 1e-13, "{a} {b}: {off}");
                }
            }
        }
    }

    #[test]
    fn there_are_as_many_points_as_terms() {
        assert_eq!(Fit::new(Terms::Polynomials).points.len(), WIDTH);
    }

    /// The error of a function that is no polynomial goes with the seventh power of the cell.
    #[test]
    fn errors_shrink_with_cells() {
        let error = |size: f64| {
            let function = |[x, y]: [f64; 2]| 1.0 / (1.5 + size * (x + 0.7 * y));
            let all = fitted(function);
            let places = (0..100).map(|k| [k % 10, k / 10].map(|k| f64::from(k) / 9.0 - 0.5));
            places
                .map(|point| (value(&all, point) - function(point)).abs())
                .fold(0.0, f64::max)
        };
        let shrunk = error(0.4) / error(0.2);
        assert!(shrunk > 64.0 && shrunk < 256.0, "{shrunk}");
    }
}
