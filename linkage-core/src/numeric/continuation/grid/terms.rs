//! The polynomials of a cell over the inputs, as offsets from its centre.
//!
//! Of degree 1 their coefficients are the state at the centre and the slopes, input by input. Of a
//! higher degree, over two inputs, they stand power by power of the second input, and for each of
//! these power by power of the first, up to the degree of both together.

use crate::scalar::Scalar;

/// The largest distance from the centre of a cell, in cells, with a state: half a cell outside the
/// grid.
pub(in super::super) const OUTSIDE: f64 = 1.0;

/// The degree over two inputs. With each degree less a grid has twice as many cells and takes twice
/// as long to prepare; with more, it takes longer to look a state up.
const DEGREE: usize = 6;

/// The terms of the state in a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Terms {
    /// Derivatives with respect to each input: four Newton steps lead to the solution.
    Slopes,
    /// Polynomials over two inputs, of which one step leads there.
    Polynomials,
}

impl Terms {
    /// The degree of the polynomials.
    #[must_use]
    pub const fn degree(self) -> usize {
        match self {
            Self::Slopes => 1,
            Self::Polynomials => DEGREE,
        }
    }

    /// Returns the number of coefficients over so many inputs; of polynomials over two.
    #[must_use]
    pub const fn count(self, inputs: usize) -> usize {
        match self {
            Self::Slopes => inputs + 1,
            Self::Polynomials => (DEGREE + 1) * (DEGREE + 2) / 2,
        }
    }

    /// Returns the kind of terms with so many coefficients over so many inputs, if there is one.
    pub(super) const fn with_count(inputs: usize, count: usize) -> Option<Self> {
        if count == Self::Slopes.count(inputs) {
            Some(Self::Slopes)
        } else if inputs == 2 && count == Self::Polynomials.count(2) {
            Some(Self::Polynomials)
        } else {
            None
        }
    }
}

/// Returns the index of the coefficient of these powers of two inputs.
#[inline(always)]
pub(super) const fn index(first: usize, second: usize) -> usize {
    second * (2 * DEGREE + 3 - second) / 2 + first
}

/// The values of `S` polynomials at these offsets from the centre, in cells: coefficients of a term
/// side by side.
#[inline(always)]
pub(super) fn values<const FUSED: bool, const S: usize>(
    terms: Terms,
    coefficients: impl Fn(usize) -> [f64; S] + Copy,
    offsets: &[f64],
) -> [f64; S] {
    match (terms, offsets) {
        (Terms::Polynomials, &[x, y]) => {
            // Row by row, each as long as it is: in a loop they would be calls.
            let rows = [
                row::<FUSED, S, 7>(coefficients, 0, x),
                row::<FUSED, S, 6>(coefficients, 1, x),
                row::<FUSED, S, 5>(coefficients, 2, x),
                row::<FUSED, S, 4>(coefficients, 3, x),
                row::<FUSED, S, 3>(coefficients, 4, x),
                row::<FUSED, S, 2>(coefficients, 5, x),
                row::<FUSED, S, 1>(coefficients, 6, x),
            ];
            const { assert!(DEGREE + 1 == 7, "a row for each power of the second input") };
            by_pairs::<FUSED, S, 7>(rows, y)
        }
        _ => {
            let mut sum = coefficients(0);
            for (input, &offset) in offsets.iter().enumerate() {
                add::<FUSED, S>(&mut sum, offset, &coefficients(1 + input));
            }
            sum
        }
    }
}

/// Returns the factors of a power of the second input.
#[inline(always)]
fn row<const FUSED: bool, const S: usize, const N: usize>(
    coefficients: impl Fn(usize) -> [f64; S] + Copy,
    second: usize,
    x: f64,
) -> [f64; S] {
    let mut row = [[0.0; S]; N];
    for (first, number) in row.iter_mut().enumerate() {
        *number = coefficients(index(first, second));
    }
    by_pairs::<FUSED, S, N>(row, x)
}

/// The values of polynomials of one number at `t`, pairs of powers side by side: that waits for
/// fewer operations than one after the other.
#[inline(always)]
fn by_pairs<const FUSED: bool, const S: usize, const N: usize>(
    mut sums: [[f64; S]; N],
    t: f64,
) -> [f64; S] {
    const { assert!(N <= 7, "no further power is added") };
    let t2 = t * t;
    let mut both = |low: usize, factor: f64, high: usize| {
        if high < N {
            let high = sums[high];
            add::<FUSED, S>(&mut sums[low], factor, &high);
        }
    };
    for power in [0, 2, 4] {
        both(power, t, power + 1);
    }
    both(0, t2, 2);
    both(4, t2, 6);
    both(0, t2 * t2, 4);
    sums[0]
}

/// Adds numbers times a factor. One after the other in a short loop, which becomes vectors.
#[inline(always)]
fn add<const FUSED: bool, const S: usize>(sums: &mut [f64; S], factor: f64, numbers: &[f64; S]) {
    for (sum, &number) in sums.iter_mut().zip(numbers) {
        *sum = Scalar::mul_add::<FUSED>(number, factor, *sum);
    }
}
