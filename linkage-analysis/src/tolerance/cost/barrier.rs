//! An interior point method for few conditions.
//!
//! Newton's method on the cost minus `mu` times the logarithms of the slacks of the conditions, for
//! a falling `mu`. The multipliers at the end give a bound that is valid whether or not the method
//! has converged: each condition implies the linear one along its own direction, and with linear
//! conditions the dual function is a sum of closed forms.

use alloc::vec;
use alloc::vec::Vec;

use super::problem::{Cheapest, Condition, Term, length, vector};
use linkage_core::numeric::cholesky;
use linkage_core::numeric::vector::dot;

/// Newton steps for each `mu`, and values of `mu`.
const STEPS: usize = 60;
const REDUCTIONS: usize = 9;
const REDUCTION: f64 = 0.1;
/// The gain of the last step at a value of `mu`, in units of `mu`.
const CENTRED: f64 = 1e-9;
/// Below this gain, in units of `mu`, the merit's own rounding hides how much it falls: any finite
/// merit is taken.
const HIDDEN: f64 = 1e-3;
/// The part of the gain foretold that a step must bring, Armijo's usual one.
const SUFFICIENT: f64 = 1e-4;
/// Steps are not shortened further than to this part: no progress is left to make.
const SHORTEST: f64 = 1e-12;

/// The cheapest values that hold `conditions`; `start` need not hold them, but has the right order
/// of size.
pub(super) fn solve(terms: &[Term], start: &[f64], conditions: &[Condition]) -> Cheapest {
    let problem = Problem::scaled(terms, start, conditions);
    let mut point = vec![1.0; terms.len()];
    let longest = problem
        .conditions
        .iter()
        .map(|c| length(c, &point))
        .fold(0.0, f64::max);
    point.iter_mut().for_each(|x| *x = 0.7 / longest);
    let cost: f64 = problem.cost(&point);
    let mut mu = 0.1 * cost / conditions.len() as f64;
    let mut bound = 0.0_f64;
    for _ in 0..REDUCTIONS {
        problem.descend(&mut point, mu);
        bound = bound.max(problem.bound(&point, mu));
        mu *= REDUCTION;
    }
    Cheapest {
        values: point
            .iter()
            .zip(start)
            .map(|(x, scale)| x * scale)
            .collect(),
        bound,
    }
}

/// The problem in units of the start values.
struct Problem {
    terms: Vec<Term>,
    conditions: Vec<Condition>,
}

impl Problem {
    fn scaled(terms: &[Term], start: &[f64], conditions: &[Condition]) -> Self {
        let terms = terms.iter().zip(start);
        let scale = |condition: &Condition| -> Condition {
            let rows = condition.iter().zip(start);
            rows.map(|(row, scale)| row.map(|x| x * scale)).collect()
        };
        Self {
            terms: terms
                .map(|(term, &scale)| Term {
                    cost: term.evaluate(scale),
                    ..*term
                })
                .collect(),
            conditions: conditions.iter().map(scale).collect(),
        }
    }

    fn cost(&self, point: &[f64]) -> f64 {
        self.terms
            .iter()
            .zip(point)
            .map(|(term, &x)| term.evaluate(x))
            .sum()
    }

    /// Infinite where a condition does not hold.
    fn merit(&self, point: &[f64], mu: f64) -> f64 {
        let mut merit = self.cost(point);
        for condition in &self.conditions {
            let size = length(condition, point);
            if size >= 1.0 {
                return f64::INFINITY;
            }
            merit -= mu * ((1.0 - size) * (1.0 + size)).ln();
        }
        merit
    }

    fn descend(&self, point: &mut [f64], mu: f64) {
        let mut merit = self.merit(point, mu);
        for _ in 0..STEPS {
            let (gradient, hessian) = self.derivatives(point, mu);
            let downhill: Vec<f64> = gradient.iter().map(|g| -g).collect();
            let Some(step) = cholesky::solve(&hessian, &downhill) else {
                return;
            };
            let decrement: f64 = -step.iter().zip(&gradient).map(|(s, g)| s * g).sum::<f64>();
            let close = decrement <= HIDDEN * mu;
            let mut factor = 1.0;
            let next = loop {
                let moved: Vec<f64> = point
                    .iter()
                    .zip(&step)
                    .map(|(x, s)| x + factor * s)
                    .collect();
                let positive = moved.iter().all(|&x| x > 0.0);
                let value = if positive {
                    self.merit(&moved, mu)
                } else {
                    f64::INFINITY
                };
                if value <= merit - SUFFICIENT * factor * decrement || (close && value.is_finite())
                {
                    break (moved, value);
                }
                factor *= 0.5;
                if factor < SHORTEST {
                    return;
                }
            };
            point.copy_from_slice(&next.0);
            merit = next.1;
            if decrement <= CENTRED * mu {
                return;
            }
        }
    }

    /// Gradient and Hessian matrix of the merit.
    fn derivatives(&self, point: &[f64], mu: f64) -> (Vec<f64>, Vec<Vec<f64>>) {
        let n = point.len();
        let (mut gradient, mut hessian) = (vec![0.0; n], vec![vec![0.0; n]; n]);
        for (i, (term, &x)) in self.terms.iter().zip(point).enumerate() {
            let rate = term.exponent * term.evaluate(x) / x;
            gradient[i] = -rate;
            hessian[i][i] = rate * (term.exponent + 1.0) / x;
        }
        for condition in &self.conditions {
            let sum = vector(condition, point);
            let left = 1.0 - dot(&sum, &sum);
            let along: Vec<f64> = condition
                .iter()
                .map(|row| 2.0 * dot(row, &sum) / left)
                .collect();
            for i in 0..n {
                gradient[i] += mu * along[i];
                for j in 0..=i {
                    let curved = 2.0 * dot(&condition[i], &condition[j]) / left;
                    hessian[i][j] += mu * (curved + along[i] * along[j]);
                }
            }
        }
        (gradient, hessian)
    }

    /// The dual function at the multipliers that belong to `mu`.
    fn bound(&self, point: &[f64], mu: f64) -> f64 {
        let (mut prices, mut total) = (vec![0.0; point.len()], 0.0);
        for condition in &self.conditions {
            let sum = vector(condition, point);
            let size = dot(&sum, &sum).sqrt();
            let multiplier = 2.0 * mu * size / ((1.0 - size) * (1.0 + size));
            total += multiplier;
            for (price, row) in prices.iter_mut().zip(condition) {
                *price += multiplier * dot(row, &sum) / size;
            }
        }
        if prices.iter().any(|&price| price.is_nan() || price <= 0.0) {
            return 0.0;
        }
        let pairs = self.terms.iter().zip(&prices);
        let lowest = pairs.map(|(term, &price)| {
            let x = term.lowest(price);
            term.evaluate(x) + price * x
        });
        (lowest.sum::<f64>() - total).max(0.0)
    }
}
