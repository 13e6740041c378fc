//! The last points of a path, and the polynomial through them that tells where it goes.

use crate::numeric::complex::Complex;
use crate::numeric::complex_matrix::Vector;

/// A point of a path and its derivative with respect to `t`.
#[derive(Clone, Copy)]
pub(super) struct PathSample<const N: usize> {
    pub(super) t: f64,
    pub(super) x: Vector<N>,
    pub(super) tangent: Vector<N>,
}

const MOST: usize = 3;

/// The last points of a path, the latest one first.
pub(super) struct PathSamples<const N: usize> {
    knots: [PathSample<N>; MOST],
    count: usize,
}

impl<const N: usize> PathSamples<N> {
    pub(super) fn new(first: PathSample<N>) -> Self {
        Self {
            knots: [first; MOST],
            count: 1,
        }
    }

    #[inline(always)]
    pub(super) fn now(&self) -> &PathSample<N> {
        &self.knots[0]
    }

    #[inline(always)]
    pub(super) fn add(&mut self, knot: PathSample<N>) {
        self.knots[2] = self.knots[1];
        self.knots[1] = self.knots[0];
        self.knots[0] = knot;
        self.count = (self.count + 1).min(MOST);
    }

    /// Takes the inverse of a coordinate as a coordinate.
    pub(super) fn flip(&mut self, j: usize) {
        for knot in &mut self.knots {
            let inverse = knot.x[j].inverse();
            knot.tangent[j] = -(knot.tangent[j] * inverse * inverse);
            knot.x[j] = inverse;
        }
    }

    /// The polynomial (Hermite's) that has the points and tangents.
    #[inline(always)]
    pub(super) fn predict(&self, t: f64) -> Vector<N> {
        let [a, b, c] = &self.knots;
        let ahead = t - a.t;
        match self.count {
            1 => core::array::from_fn(|j| a.x[j] + a.tangent[j].scaled(ahead)),
            2 => {
                let inverse = 1.0 / (a.t - b.t);
                let (to_a, to_b) = (ahead, t - b.t);
                let first = weights(to_b * inverse, inverse, to_a);
                let second = weights(-to_a * inverse, -inverse, to_b);
                core::array::from_fn(|j| weighted(a, first, j) + weighted(b, second, j))
            }
            _ => {
                let (to_a, to_b, to_c) = (ahead, t - b.t, t - c.t);
                let (ab, ac, bc) = (a.t - b.t, a.t - c.t, b.t - c.t);
                // One division for three inverses.
                let inverse = 1.0 / (ab * ac * bc);
                let (ab, ac, bc) = (inverse * ac * bc, inverse * ab * bc, inverse * ab * ac);
                let first = weights(to_b * to_c * ab * ac, ab + ac, to_a);
                let second = weights(-to_a * to_c * ab * bc, bc - ab, to_b);
                let third = weights(to_a * to_b * ac * bc, -ac - bc, to_c);
                core::array::from_fn(|j| {
                    weighted(a, first, j) + weighted(b, second, j) + weighted(c, third, j)
                })
            }
        }
    }

    /// Product of the distances from `t` to the points; the error of the prediction grows with
    /// its square.
    #[inline(always)]
    pub(super) fn span(&self, t: f64) -> f64 {
        let used = &self.knots[..self.count];
        used.iter().fold(1.0, |span, knot| span * (knot.t - t))
    }

    /// Returns about the distance ahead at which the span has this value.
    #[inline(always)]
    pub(super) fn length_of_span(&self, span: f64, guess: f64) -> f64 {
        const STEPS: usize = 3;
        let [now, before, first] = self.knots.map(|knot| knot.t);
        let (b, c) = (before - now, first - now);
        let mut length = guess;
        for _ in 0..STEPS {
            let (value, slope) = match self.count {
                1 => (length, 1.0),
                2 => (length * (length + b), 2.0 * length + b),
                _ => {
                    let product = (length + b) * (length + c);
                    (length * product, product + length * (2.0 * length + b + c))
                }
            };
            length -= (value - span) / slope;
        }
        length
    }
}

/// Weights of a point and of its tangent, from the value of its Lagrange polynomial, the slope of
/// that at the point, and the distance from it.
#[inline(always)]
fn weights(value: f64, slope: f64, distance: f64) -> [f64; 2] {
    let square = value * value;
    [square * (1.0 - 2.0 * slope * distance), square * distance]
}

#[inline(always)]
fn weighted<const N: usize>(knot: &PathSample<N>, weights: [f64; 2], j: usize) -> Complex {
    knot.x[j].scaled(weights[0]) + knot.tangent[j].scaled(weights[1])
}
