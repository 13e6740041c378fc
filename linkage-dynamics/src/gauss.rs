//! Rules of Gauss and Legendre over any scalar: nodes of `f64`, refined where a scalar has more
//! digits.

use gauss_quad::GaussLegendre;
use linkage_core::Scalar;
use std::num::NonZeroUsize;

/// Newton steps from a node of `f64`. Each of them doubles the digits: enough for a hundred.
const REFINEMENTS: usize = 3;

/// Nodes between -1 and 1 with their weights.
#[derive(Debug)]
pub(crate) struct GaussRule<T> {
    points: Vec<(T, T)>,
}

impl<T: Scalar> GaussRule<T> {
    /// Returns the rule with a number of nodes.
    pub(crate) fn new(count: NonZeroUsize) -> Self {
        let rule = GaussLegendre::new(count);
        let points = rule.iter().map(|&(node, weight)| {
            let node = T::from_f64(node);
            if T::REFINES {
                refined(count.get(), node)
            } else {
                (node, T::from_f64(weight))
            }
        });
        Self {
            points: points.collect(),
        }
    }

    /// Returns the integral of a function between two limits.
    pub(crate) fn integrate(&self, from: T, to: T, mut function: impl FnMut(T) -> T) -> T {
        let half = T::from_f64(0.5);
        let (range, sum) = (to - from, to + from);
        let values = self
            .points
            .iter()
            .map(|&(node, weight)| function(half * (range * node + sum)) * weight);
        let total = values.fold(T::from_f64(-0.0), |total, value| total + value);
        half * range * total
    }
}

/// Returns a node of a rule and its weight `2 / ((1 - x^2) P'(x)^2)`, with all digits.
fn refined<T: Scalar>(count: usize, mut node: T) -> (T, T) {
    for _ in 0..REFINEMENTS {
        let [value, slope] = legendre(count, node);
        node = node - value / slope;
    }
    let [_, slope] = legendre(count, node);
    let one = T::from_f64(1.0);
    let weight = T::from_f64(2.0) / ((one - node * node) * slope * slope);
    (node, weight)
}

/// Returns the value and the slope of Legendre's polynomial of a degree, by Bonnet's recursion.
fn legendre<T: Scalar>(degree: usize, x: T) -> [T; 2] {
    let whole = |number: usize| T::from_f64(number as f64);
    let one = T::from_f64(1.0);
    let (mut before, mut value) = (one, x);
    for k in 1..degree {
        let next = (whole(2 * k + 1) * x * value - whole(k) * before) / whole(k + 1);
        (before, value) = (value, next);
    }
    let slope = whole(degree) * (x * value - before) / (x * x - one);
    [value, slope]
}

#[cfg(test)]
mod tests {
    use super::{GaussLegendre, refined};
    use std::num::NonZeroUsize;

    /// Newton's method finds the nodes of a table from places near them, and the weights with them.
    #[test]
    fn refined_nodes_are_those_of_the_table() {
        for count in [1, 2, 10, 16] {
            let rule = GaussLegendre::new(NonZeroUsize::new(count).expect("nodes"));
            for &(node, weight) in rule.iter() {
                let (found, found_weight) = refined(count, node + 1e-4);
                assert!((found - node).abs() < 1e-15, "{count}: {node}");
                assert!(
                    (found_weight - weight).abs() < 1e-14 * weight,
                    "{count}: {node}"
                );
            }
        }
    }
}
