//! Polynomials through eight nodes, for several numbers at once.

use crate::scalar::Scalar;

/// Coefficients of a polynomial.
pub(super) const TERMS: usize = 8;

/// The nodes of the interpolation: the zeros of the Chebyshev polynomial of degree 8.
pub(super) const NODES: [f64; TERMS] = [
    -0.980_785_280_403_230_4,
    -0.831_469_612_302_545_2,
    -0.555_570_233_019_602_2,
    -0.195_090_322_016_128_27,
    0.195_090_322_016_128_27,
    0.555_570_233_019_602_2,
    0.831_469_612_302_545_2,
    0.980_785_280_403_230_4,
];

/// `FIT[power][node]`: the weight of the value at a node for a coefficient.
const FIT: [[f64; TERMS]; TERMS] = fit_matrix();

/// The coefficient of the last power is this times that of the last Chebyshev polynomial.
const LAST: f64 = 64.0;

const fn fit_matrix() -> [[f64; TERMS]; TERMS] {
    // Powers of the Chebyshev polynomials, by their recurrence.
    let mut powers = [[0.0; TERMS]; TERMS];
    powers[0][0] = 1.0;
    powers[1][1] = 1.0;
    let mut degree = 2;
    while degree < TERMS {
        let mut power = 0;
        while power < TERMS {
            let shifted = if power > 0 {
                powers[degree - 1][power - 1]
            } else {
                0.0
            };
            powers[degree][power] = 2.0 * shifted - powers[degree - 2][power];
            power += 1;
        }
        degree += 1;
    }
    let mut fit = [[0.0; TERMS]; TERMS];
    let mut node = 0;
    while node < TERMS {
        // Values of the Chebyshev polynomials at the node, by the same recurrence.
        let mut values = [1.0, NODES[node], 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let mut degree = 2;
        while degree < TERMS {
            values[degree] = 2.0 * NODES[node] * values[degree - 1] - values[degree - 2];
            degree += 1;
        }
        let mut power = 0;
        while power < TERMS {
            let mut sum = 0.5 * values[0] * powers[0][power];
            let mut degree = 1;
            while degree < TERMS {
                sum += values[degree] * powers[degree][power];
                degree += 1;
            }
            fit[power][node] = sum * (2.0 / TERMS as f64);
            power += 1;
        }
        node += 1;
    }
    fit
}

/// Turns the values of `width` numbers at the nodes into coefficients, power by power. Returns the
/// largest coefficient of the last Chebyshev polynomial, a measure of the error.
pub(super) fn fit(values: &[f64], coefficients: &mut [f64], width: usize) -> f64 {
    for (row, weights) in coefficients.chunks_exact_mut(width).zip(&FIT) {
        row.fill(0.0);
        for (values, weight) in values.chunks_exact(width).zip(weights) {
            for (sum, value) in row.iter_mut().zip(values) {
                *sum += weight * value;
            }
        }
    }
    let last = &coefficients[(TERMS - 1) * width..];
    last.iter()
        .fold(0.0, |most: f64, last| most.max(last.abs() / LAST))
}

/// The value of one polynomial at `t`, pairs of powers side by side: generated code waits for fewer
/// operations than one after the other.
#[inline(always)]
pub(super) fn by_pairs<const FUSED: bool>(coefficient: impl Fn(usize) -> f64, t: f64) -> f64 {
    let t2 = t * t;
    let t4 = t2 * t2;
    let sum = |a: f64, factor: f64, b: f64| Scalar::mul_add::<FUSED>(b, factor, a);
    let pair = |power: usize| sum(coefficient(power), t, coefficient(power + 1));
    let low = sum(pair(0), t2, pair(2));
    let high = sum(pair(4), t2, pair(6));
    sum(low, t4, high)
}

/// The values of the polynomials at `t`.
pub(super) fn evaluate(coefficients: &[f64], t: f64, values: &mut [f64]) {
    let width = values.len();
    let mut rows = coefficients.chunks_exact(width).rev();
    values.copy_from_slice(rows.next().unwrap_or_default());
    for row in rows {
        for (value, coefficient) in values.iter_mut().zip(row) {
            *value = *value * t + coefficient;
        }
    }
}
