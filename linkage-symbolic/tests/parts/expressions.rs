//! Operators and methods of expressions against those of numbers.

use std::hash::{BuildHasher, BuildHasherDefault, DefaultHasher};

use linkage_symbolic::program::{Binary, Source, Ternary, Unary};
use linkage_symbolic::{Ex, Graph, NodeId};

use crate::{inputs, value};

#[test]
fn expressions_compute_what_numbers_do() {
    let graph = Graph::new();
    let [x, y, z] = inputs(&graph);
    for [a, b, c] in [[3.0, -0.7, 1.9], [0.4, 2.5, -1.1], [-2.0, -3.5, 0.0]] {
        let is = |own: Ex, expected: f64| {
            let found = value(own, &[a, b, c]);
            let same = found.to_bits() == expected.to_bits() || found.is_nan() && expected.is_nan();
            assert!(same, "{:?}: {found} instead of {expected}", own.node());
        };
        is(x + y, a + b);
        is(x - y, a - b);
        is(x * y, a * b);
        is(x / y, a / b);
        is(-x, -a);
        is(x + 2.5, a + 2.5);
        is(x - 2.5, a - 2.5);
        is(2.5 - x, 2.5 - a);
        is(2.5 * x, a * 2.5);
        is(2.5 / x, 2.5 / a);
        is(x.abs(), a.abs());
        is(x.sqrt(), a.sqrt());
        is(x.square(), a * a);
        is(x.min(y), a.min(b));
        is(x.max(y), a.max(b));
        is(x.hypot(y), libm::hypot(a, b));
        is(x.atan2(y), libm::atan2(a, b));
        is(x.root(y), a.sqrt());
        is(y.unary(Unary::Slack), 8.0 * f64::EPSILON * b.abs());
        is(z.select(x, y), if c >= 0.0 { a } else { b });
        is(x.difference_of_squares(y), (a - b) * (a + b));
        let (mut sum, mut difference) = (x, x);
        sum += y;
        difference -= y;
        is(sum, a + b);
        is(difference, a - b);
    }
}

#[test]
fn a_scale_is_a_power_of_two_near_the_reciprocal() {
    let graph = Graph::new();
    let [x] = inputs(&graph);
    for number in [1.0, -3.0, 0.011, 7e200, 4e-290] {
        let scaled = value(x.inverse_scale() * x, &[number]);
        assert!((1.0..2.0).contains(&scaled.abs()), "{number}: {scaled}");
    }
}

/// The methods of a graph make what the operators make.
#[test]
fn graphs_and_operators_make_the_same_nodes() {
    let graph = Graph::new();
    let [x, y] = inputs(&graph);
    let [a, b]: [NodeId; 2] = [x.into(), y.into()];
    let pairs = [
        (graph.neg(a), -x),
        (graph.abs(a), x.abs()),
        (graph.add(a, b), x + y),
        (graph.sub(a, b), x - y),
        (graph.mul(a, b), x * y),
        (graph.div(a, b), x / y),
        (graph.hypot(a, b), x.hypot(y)),
        (graph.sqrt(a), x.sqrt()),
        (graph.square(a), x.square()),
        (graph.zero(), graph.number(0.0)),
        (graph.one(), graph.number(1.0)),
    ];
    for (place, (node, own)) in pairs.into_iter().enumerate() {
        assert_eq!(node, own.id(), "{place}");
        assert_eq!(graph.ex(node), own);
        assert_eq!(own.graph().node(node), own.node());
    }
    assert_eq!((x + 1.0).number(7.0).constant_value(), Some(7.0));
    assert_eq!(
        (graph.number(-2.5).constant_value(), x.constant_value()),
        (Some(-2.5), None)
    );
    assert_eq!(
        [graph.number(0.0), graph.number(1.0), x].map(Ex::is_zero),
        [true, false, false]
    );
    assert_eq!(
        [graph.zero(), graph.one(), a].map(|id| graph.is_zero(id)),
        [true, false, false]
    );
}

#[test]
fn what_is_divided_by_zero_is_infinite() {
    let graph = Graph::new();
    let [x] = inputs(&graph);
    for dividend in [x, -x, 2.0 * x] {
        let quotient = dividend / 0.0;
        for number in [3.0, -0.5] {
            let infinite = value(dividend, &[number]).signum() * f64::INFINITY;
            assert_eq!(value(quotient, &[number]), infinite);
        }
        assert!(value(quotient, &[0.0]).is_nan());
    }
}

#[test]
fn operations_of_numbers_are_numbers() {
    let graph = Graph::new();
    let numbers = [0.75, 0.3, 12.0];
    let [a, b, c] = numbers.map(|own| graph.number(own));
    // How much rounding takes depends on the numbers that a program runs on.
    let unary = Unary::ALL.iter().filter(|&&op| op != Unary::Slack);
    let unary = unary.map(|&op| (a.unary(op), op.apply([0.75])));
    let binary = Binary::ALL.iter();
    let binary = binary.map(|&op| (a.binary(op, b), op.apply([0.75, 0.3])));
    let ternary = Ternary::ALL.iter();
    let ternary = ternary.map(|&op| (a.ternary(op, b, c), op.apply(numbers)));
    for (made, expected) in unary.chain(binary).chain(ternary) {
        assert_eq!(made.constant_value(), Some(expected));
    }
}

#[test]
fn expressions_are_equal_as_nodes() {
    let graph = Graph::new();
    let [x, y] = inputs(&graph);
    let p = graph.ex(graph.source(Source::Parameter(0)));
    assert!(x == graph.ex(x.id()) && x != y);
    assert_eq!([x + y, x * y, x.hypot(y)], [y + x, y * x, y.hypot(x)]);
    assert!(x.atan2(y) != y.atan2(x));
    let hasher = BuildHasherDefault::<DefaultHasher>::default();
    assert_eq!(hasher.hash_one(x), hasher.hash_one(x.id()));
    let hashes = [x, y, p].map(|own| hasher.hash_one(own));
    assert!(hashes[0] != hashes[1] && hashes[1] != hashes[2]);
    assert_eq!(format!("{y:?}"), format!("{:?}", y.id()));
    assert_eq!(x.binding(), graph.binding(x.id()));
    assert!(p.binding() < x.binding());
}
