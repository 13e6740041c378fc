//! Equal or not, by trying.

use linkage_symbolic::program::{Binary, Source, Unary};
use linkage_symbolic::{Ex, Graph, agree};

fn symbols(graph: &Graph) -> [Ex<'_>; 3] {
    [0, 1, 2].map(|k| graph.ex(graph.source(Source::Parameter(k))))
}

#[test]
fn other_spellings_are_equal() {
    let graph = Graph::new();
    let [a, b, c] = symbols(&graph);
    let product = (a + b) * c;
    assert!(agree(product, b * c + a * c));
    assert!(!agree(product, a + b));
    assert!(agree((a + b).abs().square(), (a + b).square()));
}

#[test]
fn a_choice_is_no_equality() {
    let graph = Graph::new();
    let [a, b, _] = symbols(&graph);
    assert!(!agree(a.abs(), a), "negative numbers");
    for (op, limit) in [
        (Binary::Max, 0.0),
        (Binary::Max, 200.0),
        (Binary::Min, 2.0),
        (Binary::Min, 0.02),
    ] {
        let limit = graph.number(limit);
        let chosen = a.binary(op, limit);
        assert!(!agree(chosen, a), "{op:?}");
        assert!(!agree(chosen, limit), "{op:?}");
    }
    assert!(!agree(a.select(b, graph.number(0.0)), b));
    let angle = a.unary(Unary::Sin).unary(Unary::Asin);
    assert!(!agree(angle, a), "beyond a quarter turn");
}

#[test]
fn what_is_not_defined_everywhere_is_compared_where_it_is() {
    let graph = Graph::new();
    let [a, b, c] = symbols(&graph);
    let difference = a.square() - b.square();
    let root = difference.sqrt();
    let product = (root + c) * root;
    assert!(agree(product, difference + c * root));
    assert!(!agree(product, difference));
    let angle = a.unary(Unary::Acos);
    let twice = angle + angle;
    assert!(agree(twice - angle, angle));
    assert!(!agree(graph.number(f64::NAN), a));
}
