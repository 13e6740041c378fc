//! The graph: its symbols, what is made of what, and what it forgets.

use linkage_symbolic::inline::Inliner;
use linkage_symbolic::lookup::Map;
use linkage_symbolic::program::{Binary, Source, Unary};
use linkage_symbolic::schedule::{Slots, schedule};
use linkage_symbolic::{Binding, Ex, Graph, NodeId, evaluate, numerically_equal, substitute};

use crate::{inputs, value};

#[test]
fn a_graph_forgets_what_was_made_since_a_snapshot() {
    let graph = Graph::new();
    assert!(graph.is_empty());
    let [x, y] = inputs(&graph);
    let sum = x + y;
    assert_eq!(
        (graph.len(), graph.symbol_count(), graph.is_empty()),
        (3, 2, false)
    );
    let before = graph.snapshot();
    let product = (x * y).id();
    graph.unknown("u");
    assert_eq!((graph.len(), graph.symbol_count()), (5, 3));
    graph.restore(before);
    assert_eq!((graph.len(), graph.symbol_count()), (3, 2));
    assert_eq!(x + y, sum);
    // The place of what was forgotten is free again.
    assert_eq!((x - y).id(), product);
}

#[test]
fn symbols_are_found_by_what_they_are() {
    let graph = Graph::new();
    let source = Source::Parameter(3);
    assert_eq!(graph.find_source(source), None);
    let first = graph.symbol_count();
    let node = graph.source(source);
    assert_eq!(graph.source(source), node, "one symbol for each source");
    let (u, unknown) = graph.unknown("u");
    let (v, _) = graph.unknown("v");
    let symbol = graph.find_source(source).expect("it was made");
    assert_eq!(
        graph.symbols_since(first).collect::<Vec<_>>(),
        [symbol, u, v]
    );
    assert_eq!(graph.symbols_since(2).collect::<Vec<_>>(), [v]);
    assert_eq!([symbol, u, v].map(|own| own.index()), [0, 1, 2]);
    assert_eq!(
        [graph.symbol_node(symbol), graph.symbol_node(u)],
        [node, unknown]
    );
    assert_eq!(graph.symbol(u).name, "u");
    assert_eq!(
        (graph.symbol(symbol).source, graph.symbol(u).source),
        (Some(source), None)
    );
}

#[test]
fn values_are_known_with_the_latest_operand() {
    let graph = Graph::new();
    let [x] = inputs(&graph);
    let p = graph.ex(graph.source(Source::Parameter(0)));
    let unknown = graph.unknown("u").1;
    let two = graph.number(2.0);
    let cases = [
        (two.id(), Binding::Constant),
        (p.id(), Binding::Parameter),
        ((two * p).id(), Binding::Parameter),
        ((p + x).id(), Binding::Call),
        (x.sqrt().id(), Binding::Call),
        (unknown, Binding::Call),
        (p.select(two, x).id(), Binding::Call),
    ];
    for (id, binding) in cases {
        assert_eq!(graph.binding(id), binding, "{:?}", graph.node(id));
    }
}

#[test]
fn a_revision_is_a_change_of_a_definition() {
    let graph = Graph::new();
    let [x, y] = inputs(&graph);
    let (u, unknown) = graph.unknown("u");
    let start = graph.revision();
    graph.define(u, x.id());
    graph.define(u, x.id());
    assert_eq!(
        graph.revision(),
        start,
        "nothing was found with another one"
    );
    assert_eq!(graph.symbol(u).definition, Some(x.id()));
    let mut inliner = Inliner::default();
    let twice = graph.ex(unknown) + graph.ex(unknown);
    let copy = |inliner: &mut Inliner| {
        let copy = inliner.copy(&graph, twice.id());
        value(inliner.target.ex(copy), &[3.0, 5.0])
    };
    assert_eq!((value(twice, &[3.0, 5.0]), copy(&mut inliner)), (6.0, 6.0));
    graph.define(u, y.id());
    assert!(graph.revision() > start);
    assert_eq!(
        (value(twice, &[3.0, 5.0]), copy(&mut inliner)),
        (10.0, 10.0)
    );
    let revised = graph.revision();
    graph.define(u, x.id());
    assert!(graph.revision() > revised);
}

#[test]
fn what_a_value_is_made_of() {
    let graph = Graph::new();
    let [x, y, z] = inputs(&graph);
    let (u, unknown) = graph.unknown("u");
    graph.define(u, z.id());
    let product = x * y;
    let other = x + graph.ex(unknown);
    let root = (product + 1.0).sqrt();
    let ids = |list: &[Ex]| list.iter().map(|own| own.id()).collect::<Vec<NodeId>>();
    let mut expected = ids(&[x, y, product, graph.number(1.0), product + 1.0, root]);
    expected.sort_unstable();
    assert_eq!(graph.reachable(&ids(&[root, product])), expected);
    for part in expected {
        assert!(graph.contains(root.id(), part), "{part:?}");
    }
    for part in ids(&[z, other]) {
        assert!(!graph.contains(root.id(), part), "{part:?}");
    }
    assert!(!graph.contains(product.id(), root.id()));
    let symbols = |roots: &[Ex]| graph.symbols_of(&ids(roots));
    let of = |own: Ex| match own.id() {
        id if id == unknown => u,
        id => symbols(&[graph.ex(id)])[0],
    };
    assert_eq!(symbols(&[root]), [x, y].map(of));
    assert_eq!(symbols(&[other, root]), [x, y, graph.ex(unknown)].map(of));
    assert_eq!(symbols(&[graph.number(2.0)]), []);
}

/// The sine and the cosine of one angle are not independent.
#[test]
fn pairs_are_of_one_angle() {
    let graph = Graph::new();
    let ((c, cos), (s, sin)) = (graph.unknown("c"), graph.unknown("s"));
    let [cos, sin] = [cos, sin].map(|id| graph.ex(id));
    let circle = cos.square() + sin.square();
    let one = graph.number(1.0);
    assert!(!numerically_equal(circle, one));
    graph.pair(c, s);
    assert!(numerically_equal(circle, one));
    assert!(!numerically_equal(cos, sin) && !numerically_equal(cos + sin, one));
}

#[test]
fn substitution_leaves_what_has_none() {
    let graph = Graph::new();
    let [x, y] = inputs(&graph);
    let (u, unknown) = graph.unknown("u");
    let unknown = graph.ex(unknown);
    let root = (unknown.square() + x).select(unknown, y).sqrt();
    let map = Map::from([(u, x * y)]);
    let found = substitute(&[root, x + y, unknown], &map);
    assert_eq!(found[1..], [x + y, x * y]);
    let product = x * y;
    assert_eq!(found[0], (product.square() + x).select(product, y).sqrt());
    assert_eq!(substitute(&[], &map), []);
    assert!(evaluate(&[], |_| f64::NAN).is_empty());
}

/// A shared value is one slot, also of another graph that has its factors in another order.
#[test]
fn graphs_share_their_slots() {
    let mut slots = Slots::default();
    let program = |first: usize, slots: &mut Slots| {
        let graph = Graph::new();
        let [p, q] = [first, 1 - first].map(|k| graph.ex(graph.source(Source::Parameter(k))));
        let [x] = inputs(&graph);
        let all = [p * q + p, p / q, p.atan2(q), p * q, p + q];
        let outputs = all.map(|own| (own.abs() * x).id());
        schedule(&graph, &outputs, slots)
    };
    let prepared = |program: &linkage_symbolic::program::Program| {
        let loads = program.instructions.iter();
        loads
            .filter(|own| own.to_string().starts_with("prepared"))
            .count()
    };
    let one = program(0, &mut slots);
    assert_eq!((prepared(&one), slots.prepare().outputs.len()), (5, 5));
    let again = program(0, &mut slots);
    assert_eq!((again == one, slots.prepare().outputs.len()), (true, 5));
    program(1, &mut slots);
    assert_eq!(
        slots.prepare().outputs.len(),
        8,
        "q p + q, q / p and the other angle are new"
    );
    let values = linkage_symbolic::interpret::run(&slots.prepare(), |source| match source {
        Source::Parameter(0) => -3.0,
        _ => 2.0,
    });
    let angles = [(-3.0_f64).atan2(2.0), 2.0_f64.atan2(-3.0)].map(f64::abs);
    assert_eq!(
        values,
        [9.0, 1.5, angles[0], 6.0, 1.0, 4.0, 2.0 / 3.0, angles[1]]
    );
}

/// Negative zero has no node, and the numbers 0 and 1 are what they are.
#[test]
fn constants_are_numbers() {
    let graph = Graph::new();
    for number in [0.0, 1.0, -1.0, 2.5, f64::INFINITY, f64::MIN_POSITIVE] {
        assert_eq!(graph.constant_value(graph.constant(number)), Some(number));
    }
    let zero = graph
        .constant_value(graph.constant(-0.0))
        .expect("a number");
    assert!(zero.is_sign_positive());
    assert!(
        graph
            .constant_value(graph.constant(f64::NAN))
            .is_some_and(f64::is_nan)
    );
    let [x] = inputs(&graph);
    assert_eq!(graph.constant_value(x.id()), None);
    assert_eq!(graph.constant_value(x.unary(Unary::Sin).id()), None);
    let folded = graph.binary(Binary::Atan2, graph.one(), graph.one());
    assert_eq!(
        graph.constant_value(folded),
        Some(std::f64::consts::FRAC_PI_4)
    );
}
