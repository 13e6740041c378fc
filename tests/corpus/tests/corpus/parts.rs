//! A machine of parts: its programs, some of them made of the graph of one part alone, against the graph of the whole.

use linkage_corpus::given::example;
use linkage_corpus::{Position, Subject};
use linkage_random::Random;
use std::collections::BTreeSet;

/// Of the largest number of a function.
const ROUNDING: f64 = 1e-14;

#[test]
fn programs_of_a_machine_agree_with_its_graph() {
    let machine = Subject::new(&example("knitting_machine.rs"));
    let machine = machine.unwrap_or_else(|messages| panic!("{messages:?}"));
    let mut random = Random::new(22);
    let mut largest = 0.0_f64;
    let mut compared = BTreeSet::new();
    for round in 0..8 {
        // The defaults first, then other dimensions and positions near the reference.
        let part = if round == 0 { 0.0 } else { 1.0 };
        let mut near = |x: &f64, by: f64| x + part * by * random.between(-1.0, 1.0);
        let Position { parameters, inputs } = machine.reference();
        let at = Position {
            parameters: parameters.iter().map(|x| near(x, 1e-3 * x.abs())).collect(),
            inputs: inputs.iter().map(|x| near(x, 0.2)).collect(),
        };
        for (index, function) in machine.unit.functions.iter().enumerate() {
            // Coupled groups begin from states that only an assembly has.
            if !function.states.is_empty() {
                continue;
            }
            compared.insert(&*function.name);
            let (program, graph) = (machine.by_program(index, &at), machine.by_graph(index, &at));
            assert_eq!(program.len(), graph.len());
            let size = graph.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
            for (p, g) in program.iter().zip(&graph) {
                let difference = (p - g).abs() / size;
                assert!(
                    difference <= ROUNDING,
                    "{}: {p:e} by the program, {g:e} by the graph",
                    function.name
                );
                largest = largest.max(difference);
            }
        }
    }
    assert_eq!(
        compared.into_iter().collect::<Vec<_>>(),
        ["hook", "hook_accuracy", "press", "press_accuracy"]
    );
    println!("largest difference: {largest:.1e} of a function's largest number");
}
