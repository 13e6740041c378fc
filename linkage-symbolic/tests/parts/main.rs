//! The parts of the engine one by one, each against numbers that were found in another way.

mod common_factors;
mod counts;
mod cuts;
mod derivatives;
mod expressions;
mod graphs;
mod half_angles;
mod late_roots;
mod lengths;
mod operations;
mod polynomials;
mod programs;
mod stages;
mod vectors;

use linkage_symbolic::program::Source;
use linkage_symbolic::{Ex, Graph, evaluate};

/// Expressions that are known at a call.
fn inputs<const N: usize>(graph: &Graph) -> [Ex<'_>; N] {
    std::array::from_fn(|k| graph.ex(graph.source(Source::Input(k))))
}

/// What expressions are where input `k` is `at[k]`.
fn values(
    all: impl IntoIterator<Item = impl Into<linkage_symbolic::NodeId>>,
    graph: &Graph,
    at: &[f64],
) -> Vec<f64> {
    let all: Vec<Ex> = all.into_iter().map(|x| graph.ex(x.into())).collect();
    evaluate(&all, |source| match source {
        Source::Input(k) => at[k],
        other => panic!("{other} is not an input"),
    })
}

/// What an expression is where input `k` is `at[k]`.
fn value(x: Ex, at: &[f64]) -> f64 {
    values([x], x.graph(), at)[0]
}

fn assert_near(found: &[f64], expected: &[f64], error: f64) {
    assert_eq!(found.len(), expected.len(), "{found:?} {expected:?}");
    for (x, y) in found.iter().zip(expected) {
        assert!((x - y).abs() <= error, "{found:?} instead of {expected:?}");
    }
}
