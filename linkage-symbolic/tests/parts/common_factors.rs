//! Sums that share factors: what they are stays the same, whatever the factors are.

use linkage_random::Random;
use linkage_symbolic::program::{Binary, Source};
use linkage_symbolic::{Ex, Graph, Node, evaluate, share_common_factors};

use crate::inputs;

/// A product of numbers and parameters, or a quotient.
fn factor<'g>(random: &mut Random, parameters: &[Ex<'g>]) -> Ex<'g> {
    let mut product = parameters[0].number(*random.pick(&[1.0, -1.0, 2.0, -0.3]));
    for _ in 0..random.below(3) {
        let other = *random.pick(parameters);
        product = match random.below(4) {
            0 => product / other,
            1 => -product * other,
            _ => product * other,
        };
    }
    product
}

fn sums(graph: &Graph, roots: &[Ex]) -> usize {
    let roots: Vec<_> = roots.iter().map(|own| own.id()).collect();
    let is_sum = |own: &Node| matches!(own, Node::Binary(Binary::Add | Binary::Sub, ..));
    let nodes = graph.reachable(&roots).into_iter().map(|id| graph.node(id));
    nodes.filter(is_sum).count()
}

#[test]
fn shared_sums_are_what_they_were() {
    let mut random = Random::new(71);
    let mut spared = 0;
    for case in 0..300 {
        let graph = Graph::new();
        let [x, y] = inputs(&graph);
        let parameters = [0, 1, 2].map(|k| graph.ex(graph.source(Source::Parameter(k))));
        let [first, second, other] = [0; 3].map(|_| factor(&mut random, &parameters));
        // Multiples of two sums in other orders and with other signs.
        let roots = [0; 5].map(|_| {
            let common = factor(&mut random, &parameters);
            let b = *random.pick(&[second, -second, second, other]);
            let (left, right) = ((common * first) * x, (common * b) * y);
            match random.below(4) {
                0 => right + left,
                1 => left - right,
                2 => (left + right).sqrt(),
                _ => left + right,
            }
        });
        let ids = roots.map(|own| own.id());
        let shared = share_common_factors(&graph, &ids);
        let shared: Vec<Ex> = shared.into_iter().map(|id| graph.ex(id)).collect();
        let [before, after] = [&roots[..], &shared].map(|all| sums(&graph, all));
        assert!(after <= before, "{case}: {after} sums of {before}");
        spared += before - after;
        let numbers = [0; 5].map(|_| random.ratio(0.5, 2.0));
        let load = |source| match source {
            Source::Parameter(k) => numbers[k],
            Source::Input(k) => numbers[3 + k],
            other => panic!("{other}"),
        };
        let pairs = evaluate(&roots, load).into_iter();
        for (a, b) in pairs.zip(evaluate(&shared, load)) {
            // Terms are below a hundred. The root of a sum that nearly vanishes is known less well.
            let close = (a - b).abs() < 1e-11 || a.is_nan() && b.is_nan();
            let vanishes = a.abs().min(b.abs()) < 1e-5;
            assert!(close || vanishes, "{case}: {a} became {b}");
        }
    }
    assert!(spared > 300, "{spared}");
}

/// A sum is no multiple of one that has a factor more, and none of one with another factor.
#[test]
fn nothing_is_divided_by_a_factor() {
    let graph = Graph::new();
    let [x, y] = inputs(&graph);
    let [p, q, r, s] = [0, 1, 2, 3].map(|k| graph.ex(graph.source(Source::Parameter(k))));
    let sum = |common: Ex| ((common * p) * x + (common * q) * y).id();
    let [of_r, of_s, both] = [sum(r), sum(s), sum(r * s)];
    assert_eq!(share_common_factors(&graph, &[of_r, of_s]), [of_r, of_s]);
    let shared = share_common_factors(&graph, &[both, of_r]);
    assert_eq!(shared[1], of_r);
    assert!(graph.contains(shared[0], of_r) && shared[0] != both);
}

/// Only what is known before a call is gathered in front of terms, and only that is a common factor.
#[test]
fn factors_are_known_before_a_call() {
    for source in [Source::Input, Source::Parameter] {
        let graph = Graph::new();
        let [u, v] = [4, 5].map(|k| graph.ex(graph.source(source(k))));
        let both = u * v;
        let [x, y] = inputs(&graph);
        let sums = [u, both].map(|own| (own * x + own * y).id());
        let shared = share_common_factors(&graph, &sums) != sums;
        assert_eq!(shared, u.is_fixed());
    }
}
