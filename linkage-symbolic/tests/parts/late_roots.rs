//! What is done before a root instead of behind it: values stay what they are, and no more operations are needed.

use linkage_random::Random;
use linkage_symbolic::count::{chain, time};
use linkage_symbolic::passes::polished;
use linkage_symbolic::program::Source;
use linkage_symbolic::schedule::{Slots, schedule};
use linkage_symbolic::{Ex, Graph, NodeId, evaluate, late_roots};

use crate::inputs;

fn cost(graph: &Graph, outputs: &[NodeId]) -> (u32, u32) {
    let program = polished(schedule(graph, outputs, &mut Slots::default()));
    (time(&program), chain(&program))
}

/// A number or its opposite, written in some way.
fn signed<'g>(random: &mut Random, x: Ex<'g>) -> Ex<'g> {
    match random.below(3) {
        0 => -x,
        _ => x,
    }
}

/// The vector `z v`, or what is nearly that.
fn turned<'g>(random: &mut Random, [a, b]: [Ex<'g>; 2], [x, y]: [Ex<'g>; 2]) -> [Ex<'g>; 2] {
    let [ax, by, ay, bx] = [a * x, b * y, a * y, b * x];
    match random.below(4) {
        0 => [ax + by, bx - ay],
        1 => [by - ax, ay + bx],
        // No rotation.
        2 => [ax + by, ay + bx],
        _ => [ax - by, ay + bx],
    }
}

#[test]
fn turned_vectors_and_sums_are_what_they_were() {
    let mut random = Random::new(72);
    let mut shorter = 0;
    for case in 0..400 {
        let graph = Graph::new();
        let [x, y, n, q] = inputs(&graph);
        let [p, r] = [0, 1].map(|k| graph.ex(graph.source(Source::Parameter(k))));
        let h = signed(&mut random, q.root(n));
        let direction = [signed(&mut random, x), y];
        let feet = [signed(&mut random, n), h];
        let [u, v] = turned(&mut random, feet, direction);
        let arm = [signed(&mut random, p), signed(&mut random, r)];
        let [right, up] = turned(&mut random, arm, [u, v]);
        let mut roots = vec![x + right, y - up];
        if random.below(4) == 0 {
            // Somebody else asks for the vector in between.
            roots.push(u * v);
        }
        if random.below(2) == 0 {
            roots.push((x - n) - (y * n - h * x));
        }
        let ids: Vec<NodeId> = roots.iter().map(|own| own.id()).collect();
        let numbers = [0; 6].map(|_| random.between(0.5, 2.0));
        let load = |source| match source {
            Source::Parameter(k) => numbers[k],
            Source::Input(k) => numbers[2 + k],
            _ => unreachable!("inputs and parameters"),
        };
        let expected = evaluate(&roots, load);
        let before = cost(&graph, &ids);
        let [turned, added] = late_roots(&graph, &ids);
        for ids in [&turned, &added] {
            let own: Vec<Ex> = ids.iter().map(|&id| graph.ex(id)).collect();
            for (x, y) in expected.iter().zip(evaluate(&own, load)) {
                assert!((x - y).abs() <= 1e-13 * (1.0 + x.abs()), "{case}: {x} {y}");
            }
        }
        if roots.len() == 2 {
            // Nobody else uses a product of what is turned.
            assert!(cost(&graph, &turned).0 <= before.0, "{case}");
        }
        shorter += usize::from(cost(&graph, &added).1 < before.1);
    }
    assert!(shorter > 100, "{shorter}");
}
