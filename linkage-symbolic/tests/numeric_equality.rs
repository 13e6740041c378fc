//! Equal or not, by trying.

use linkage_symbolic::program::{Binary, Source, Unary};
use linkage_symbolic::{Ex, Graph, numerically_equal, numerically_equal_within};

fn symbols(graph: &Graph) -> [Ex<'_>; 3] {
    [0, 1, 2].map(|k| graph.ex(graph.source(Source::Parameter(k))))
}

#[test]
fn other_spellings_are_equal() {
    let graph = Graph::new();
    let [a, b, c] = symbols(&graph);
    let product = (a + b) * c;
    assert!(numerically_equal(product, b * c + a * c));
    assert!(!numerically_equal(product, a + b));
    assert!(numerically_equal((a + b).abs().square(), (a + b).square()));
}

#[test]
fn a_choice_is_no_equality() {
    let graph = Graph::new();
    let [a, b, _] = symbols(&graph);
    assert!(!numerically_equal(a.abs(), a), "negative numbers");
    for (op, limit) in [
        (Binary::Max, 0.0),
        (Binary::Max, 200.0),
        (Binary::Min, 2.0),
        (Binary::Min, 0.02),
    ] {
        let limit = graph.number(limit);
        let chosen = a.binary(op, limit);
        assert!(!numerically_equal(chosen, a), "{op:?}");
        assert!(!numerically_equal(chosen, limit), "{op:?}");
    }
    assert!(!numerically_equal(a.select(b, graph.number(0.0)), b));
    let angle = a.unary(Unary::Sin).unary(Unary::Asin);
    assert!(!numerically_equal(angle, a), "beyond a quarter turn");
}

#[test]
fn what_is_not_defined_everywhere_is_compared_where_it_is() {
    let graph = Graph::new();
    let [a, b, c] = symbols(&graph);
    let difference = a.square() - b.square();
    let root = difference.sqrt();
    let product = (root + c) * root;
    assert!(numerically_equal(product, difference + c * root));
    assert!(!numerically_equal(product, difference));
    let angle = a.unary(Unary::Acos);
    let twice = angle + angle;
    assert!(numerically_equal(twice - angle, angle));
    assert!(!numerically_equal(graph.number(f64::NAN), a));
}

/// The share is of the larger side.
#[test]
fn a_difference_counts_beside_its_terms() {
    let graph = Graph::new();
    let [a, b, _] = symbols(&graph);
    for scale in [1e-200, 1.0, 1e200] {
        let product = scale * (a * b);
        assert!(numerically_equal(product * (1.0 + 1e-11), product));
        assert!(!numerically_equal(product * (1.0 + 1e-9), product));
        assert!(numerically_equal_within(product * 1.01, product, 0.02));
        assert!(!numerically_equal_within(product * 1.01, product, 0.005));
        assert!(!numerically_equal(product, -product));
    }
    let nothing = graph.number(0.0);
    assert!(
        !numerically_equal(1e-30 * a, nothing),
        "small is not nothing"
    );
}

/// A square as what remains of terms that are `size^2` times as large: it is known less well.
fn remainder<'g>([a, b, _]: [Ex<'g>; 3], size: f64) -> Ex<'g> {
    let large = size * a;
    (large + b).square() - large.square() - 2.0 * (large * b)
}

#[test]
fn what_remains_of_large_terms_is_known_less_well() {
    let graph = Graph::new();
    let all = symbols(&graph);
    let [_, b, c] = all;
    let (rounded, exact) = (remainder(all, 1e5), b.square());
    assert!(numerically_equal(rounded, exact) && !numerically_equal(rounded, exact + 100.0));
    // What it is multiplied by or divided by multiplies the error, too.
    let (factor, divisor) = (1e12 * c, 1e-12 * c);
    assert!(numerically_equal(rounded * factor, exact * factor));
    assert!(numerically_equal(factor * rounded, exact * factor));
    assert!(numerically_equal(rounded / divisor, exact / divisor));
    assert!(!numerically_equal(
        rounded * factor,
        (exact + 100.0) * factor
    ));
    assert!(!numerically_equal(
        rounded / divisor,
        (exact + 100.0) / divisor
    ));
    // A root of it is known as well as the root's share of it.
    let (rounded, exact) = (remainder(all, 1e4), b.square());
    let root = (rounded * factor).sqrt();
    assert!(numerically_equal(root, (exact * factor).sqrt()));
    assert!(!numerically_equal(root, 2.0 * (exact * factor).sqrt()));
}

#[test]
fn both_sides_must_be_defined_somewhere() {
    let graph = Graph::new();
    let [a, b, _] = symbols(&graph);
    let nowhere = (-1.0 - a.square()).sqrt();
    assert!(!numerically_equal(nowhere, 2.0 * nowhere));
    // Defined on one side only is no equality.
    let below = (a - 1.0).sqrt();
    assert!(!numerically_equal(below.square(), a - 1.0));
    // Roots are compared where all symbols are positive.
    assert!(numerically_equal((a * b).sqrt(), a.sqrt() * b.sqrt()));
}
