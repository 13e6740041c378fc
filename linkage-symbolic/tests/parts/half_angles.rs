//! Vectors that turn with an angle, by the sine pair of its half: values stay what they are, and early parts are put together.

use linkage_random::Random;
use linkage_symbolic::count::time;
use linkage_symbolic::passes::polished;
use linkage_symbolic::program::{Source, Unary};
use linkage_symbolic::schedule::{Slots, schedule};
use linkage_symbolic::{Ex, Graph, NodeId, by_half_angles, evaluate};

use crate::inputs;

fn cost(graph: &Graph, outputs: &[NodeId]) -> u32 {
    time(&polished(schedule(graph, outputs, &mut Slots::default())))
}

fn cos(x: Ex) -> Ex {
    x.unary(Unary::Cos)
}

fn sin(x: Ex) -> Ex {
    x.unary(Unary::Sin)
}

#[test]
fn vectors_by_half_angles_are_what_they_were() {
    let mut random = Random::new(73);
    let mut cheaper = 0;
    for case in 0..200 {
        let graph = Graph::new();
        let [x, y] = inputs(&graph);
        let [p, q, r] = [0, 1, 2].map(|k| graph.ex(graph.source(Source::Parameter(k))));
        let half = *random.pick(&[0.5, -0.5]) * x;
        let p = *random.pick(&[p, -p, p * r]);
        let (along, across) = (p * cos(x), p * sin(x));
        let roots = match random.below(4) {
            0 => vec![q + along, r - across],
            1 => vec![along - q, q + across, y * along],
            2 => vec![q - along, across * y, y + cos(x)],
            _ => vec![along * across, y - along],
        };
        // Somebody asks for the half anyway.
        let roots = [&roots[..], &[cos(half) + sin(half)]].concat();
        let ids: Vec<NodeId> = roots.iter().map(|own| own.id()).collect();
        let halved = by_half_angles(&graph, &ids).expect("an angle and its half");
        let own: Vec<Ex> = halved.iter().map(|&id| graph.ex(id)).collect();
        let numbers = [0; 5].map(|_| random.between(-2.0, 2.0));
        let load = |source| match source {
            Source::Parameter(k) => numbers[k],
            Source::Input(k) => numbers[3 + k],
            _ => unreachable!("inputs and parameters"),
        };
        for (x, y) in evaluate(&roots, load).into_iter().zip(evaluate(&own, load)) {
            assert!((x - y).abs() <= 1e-13, "{case}: {x} {y}");
        }
        cheaper += usize::from(cost(&graph, &halved) < cost(&graph, &ids));
    }
    assert!(cheaper > 50, "{cheaper}");
}

#[test]
fn without_an_angle_and_its_half_nothing_is_done() {
    let graph = Graph::new();
    let [x, y] = inputs(&graph);
    let third = (1.0 / 3.0) * x;
    let roots = [cos(x) + cos(third), sin(y) * (0.5 * x)];
    let ids = roots.map(|own| own.id());
    assert_eq!(by_half_angles(&graph, &ids), None);
}
