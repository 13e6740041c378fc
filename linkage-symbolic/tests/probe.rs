//! Equal or not, by trying.

use linkage_symbolic::program::{Binary, Source, Ternary, Unary};
use linkage_symbolic::{Graph, NodeId, agree};

fn graph() -> (Graph, [NodeId; 3]) {
    let graph = Graph::default();
    let symbols = [0, 1, 2].map(|k| graph.source(Source::Parameter(k)));
    (graph, symbols)
}

#[test]
fn other_spellings_are_equal() {
    let (graph, [a, b, c]) = graph();
    let sum = graph.add(a, b);
    let product = graph.mul(sum, c);
    let parts = [graph.mul(b, c), graph.mul(a, c)];
    let expanded = graph.add(parts[0], parts[1]);
    assert!(agree(&graph, product, expanded));
    assert!(!agree(&graph, product, sum));

    let size = graph.abs(sum);
    let squares = [graph.square(size), graph.square(sum)];
    assert!(agree(&graph, squares[0], squares[1]));
}

#[test]
fn a_choice_is_no_equality() {
    let (graph, [a, b, _]) = graph();
    let size = graph.abs(a);
    assert!(!agree(&graph, size, a), "negative numbers");
    for (op, limit) in [
        (Binary::Max, 0.0),
        (Binary::Max, 200.0),
        (Binary::Min, 2.0),
        (Binary::Min, 0.02),
    ] {
        let limit = graph.constant(limit);
        let chosen = graph.binary(op, a, limit);
        assert!(!agree(&graph, chosen, a), "{op:?}");
        assert!(!agree(&graph, chosen, limit), "{op:?}");
    }
    let zero = graph.zero();
    let selected = graph.ternary(Ternary::Select, a, b, zero);
    assert!(!agree(&graph, selected, b));
    let sine = graph.unary(Unary::Sin, a);
    let angle = graph.unary(Unary::Asin, sine);
    assert!(!agree(&graph, angle, a), "beyond a quarter turn");
}

#[test]
fn what_is_not_defined_everywhere_is_compared_where_it_is() {
    let (graph, [a, b, c]) = graph();
    let squares = [graph.square(a), graph.square(b)];
    let difference = graph.sub(squares[0], squares[1]);
    let root = graph.sqrt(difference);
    let sum = graph.add(root, c);
    let product = graph.mul(sum, root);
    let part = graph.mul(c, root);
    let expanded = graph.add(difference, part);
    assert!(agree(&graph, product, expanded));
    assert!(!agree(&graph, product, difference));
    let angle = graph.unary(Unary::Acos, a);
    let twice = graph.add(angle, angle);
    let other = graph.sub(twice, angle);
    assert!(agree(&graph, other, angle));

    let nowhere = graph.constant(f64::NAN);
    assert!(!agree(&graph, nowhere, a));
}
