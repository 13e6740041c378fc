//! The least cost under convex conditions.
//!
//! Minimises the sum of `c / u^k` where vectors `sum of row_i u_i` must not be longer than 1. Each
//! position of a cycle has many such conditions, of which few matter. So a small set of them is
//! solved, the tightest ones at the solution are added, and so on until nothing is violated.

mod barrier;
mod problem;

use alloc::vec::Vec;
pub(super) use problem::{Cheapest, Term};
use problem::{Condition, length, norm};

/// The number of times that conditions are added.
const ROUNDS: usize = 60;
/// A condition that is violated by less holds.
const HOLDS: f64 = 1e-9;

/// `start` holds all conditions; `tightest` gives the conditions that are tightest at some values,
/// one for each position.
pub(super) fn cheapest(
    terms: &[Term],
    start: &[f64],
    tightest: &mut dyn FnMut(&[f64]) -> Vec<Condition>,
) -> Cheapest {
    let mut used = first(&tightest(start), start);
    let mut best = solve(terms, &used);
    for _ in 0..ROUNDS {
        let violated = tightest(&best.values)
            .into_iter()
            .filter(|condition| length(condition, &best.values) > 1.0 + HOLDS);
        let before = used.len();
        used.extend(violated);
        if used.len() == before {
            break;
        }
        best = solve(terms, &used);
    }
    best
}

fn solve(terms: &[Term], conditions: &[Condition]) -> Cheapest {
    if let [only] = conditions
        && let Some(row) = scalar(only)
    {
        return closed(terms, &row);
    }
    // The right order of size: every value at its largest weight, as if all were one plain sum.
    let weight = |i: usize| conditions.iter().map(|c| norm(&c[i])).fold(0.0, f64::max);
    let row: Vec<f64> = (0..terms.len()).map(weight).collect();
    barrier::solve(terms, &closed(terms, &row).values, conditions)
}

/// For each value the condition in which it weighs most, so that each is limited.
fn first(conditions: &[Condition], values: &[f64]) -> Vec<Condition> {
    let mut chosen = Vec::new();
    for (i, value) in values.iter().enumerate() {
        let weight = |condition: &Condition| value * norm(&condition[i]);
        let heavier =
            |&a: &usize, &b: &usize| weight(&conditions[a]).total_cmp(&weight(&conditions[b]));
        chosen.extend((0..conditions.len()).max_by(heavier));
    }
    chosen.sort_unstable();
    chosen.dedup();
    chosen
        .into_iter()
        .map(|index| conditions[index].clone())
        .collect()
}

/// The coefficients of a condition that is a plain sum.
fn scalar(condition: &Condition) -> Option<Vec<f64>> {
    let plain = |row: &[f64; 3]| (row[1] == 0.0 && row[2] == 0.0).then_some(row[0].abs());
    condition.iter().map(plain).collect()
}

/// One condition `sum of a_i u_i <= 1`: by Lagrange's multiplier, the rate at which a cost falls is
/// `a_i` times a common price. The price follows from the sum being 1; with a common exponent in
/// closed form, else by bisection of its logarithm.
fn closed(terms: &[Term], row: &[f64]) -> Cheapest {
    let values = |price: f64| -> Vec<f64> {
        let pairs = terms.iter().zip(row);
        pairs.map(|(term, a)| term.lowest(price * a)).collect()
    };
    let sum = |price: f64| -> f64 { values(price).iter().zip(row).map(|(u, a)| u * a).sum() };
    let exponent = terms.first().map_or(1.0, |term| term.exponent);
    let price = if terms.iter().all(|term| term.exponent == exponent) {
        sum(1.0).powf(exponent + 1.0)
    } else {
        let (mut low, mut high) = (-700.0_f64, 700.0_f64);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            let side = if sum(middle.exp()) > 1.0 {
                &mut low
            } else {
                &mut high
            };
            *side = middle;
        }
        low.exp()
    };
    let values = values(price);
    // The dual function at this price; both agree up to rounding.
    let total: f64 = terms
        .iter()
        .zip(&values)
        .map(|(term, &u)| term.evaluate(u))
        .sum();
    let used: f64 = values.iter().zip(row).map(|(u, a)| u * a).sum();
    Cheapest {
        values,
        bound: total + price * (used - 1.0),
    }
}

#[cfg(test)]
mod tests {
    use super::{Term, closed};

    /// Nothing is cheaper than the cost that one condition allows: the bound is the cost itself,
    /// with one exponent and with two.
    #[test]
    fn one_condition_is_solved_to_its_bound() {
        for exponents in [[1.0, 1.0], [1.0, 2.0]] {
            let [first, second] = exponents;
            let term = |cost, exponent| Term { cost, exponent };
            let terms = [term(3.0, first), term(5.0, second)];
            let row = [0.5, 2.0];
            let found = closed(&terms, &row);
            let used = found.values[0] * row[0] + found.values[1] * row[1];
            let cost = terms[0].evaluate(found.values[0]) + terms[1].evaluate(found.values[1]);
            assert!((used - 1.0).abs() < 1e-12, "{used}");
            assert!(
                (found.bound - cost).abs() < 1e-12 * cost,
                "{} and {cost}",
                found.bound
            );
        }
    }
}
