//! The engine against programs, for a corpus of random mechanisms; programs against the graph, and what is in programs
//! at all, for more of them.

mod dynamics;
mod oracle;
mod parts;
mod quotients;
mod slicing;

use std::sync::{Arc, OnceLock};

use linkage_compiler::Checked;
use linkage_corpus::{COUNT, Case, Kind};
use linkage_engine::Mechanism;
use linkage_random::Random;

/// How many mechanisms are kept: more than that are asked for in long runs only, and would fill the memory.
const KEPT: usize = 100;

/// The mechanism of a seed: compiled once for all tests that ask for it.
fn case(seed: u64) -> Result<Arc<Case>, String> {
    type Compiled = OnceLock<Result<Arc<Case>, String>>;
    static CASES: [Compiled; KEPT] = [const { OnceLock::new() }; KEPT];
    let compile = || Case::new(seed).map(Arc::new);
    match CASES.get(seed as usize) {
        Some(kept) => kept.get_or_init(compile).clone(),
        None => compile(),
    }
}

/// The mechanism of a case as the engine has it.
fn mechanism(case: &Case) -> Mechanism {
    let checked = Checked {
        name: Some("Generated".to_owned()),
        model: None,
        unit: Some(case.subject.unit.clone()),
        out_of_range: None,
        messages: Vec::new(),
        warnings: Vec::new(),
    };
    Mechanism::new(&checked).expect("it has no mistake")
}

#[test]
fn the_engine_agrees_with_programs() {
    let mut worst = 0.0;
    for seed in 0..COUNT {
        let case = case(seed).unwrap_or_else(|message| panic!("{message}"));
        let mechanism = mechanism(&case);
        let names = mechanism.parameters().iter().map(|own| own.name);
        assert!(names.eq(case.sample.parameters.iter().map(String::as_str)));
        let mut random = Random::new(seed);
        for round in 0..4 {
            let mut at = case.position(&mut random);
            // Other dimensions than the default ones, too.
            let amount = if round == 0 {
                0.0
            } else {
                0.1 * case.sample.range
            };
            let angles = case.sample.angles.iter();
            let changes: Vec<f64> = angles
                .map(|is_angle| amount * case.unit(*is_angle) * random.between(-1.0, 1.0))
                .collect();
            at.parameters
                .iter_mut()
                .zip(&changes)
                .for_each(|(p, change)| *p += change);
            let assembly = mechanism.assemble(&at.parameters).expect("it assembles");
            for (index, function) in case.sample.functions.iter().enumerate() {
                if function.kind == Kind::Closure {
                    continue;
                }
                let inputs = function.inputs.iter().map(|&input| at.inputs[input]);
                let found = assembly.call(index, &inputs.collect::<Vec<f64>>());
                let expected = case.subject.by_program(index, &at);
                let differences = case.differences(index, &at, &found, &expected);
                for (k, difference) in differences.into_iter().enumerate() {
                    worst = f64::max(worst, difference);
                    let (f, e) = (found[k], expected[k]);
                    let entry = function.entries.get(k);
                    let what = || {
                        format!(
                            "result {k} {entry:?}: engine {f:e}, program {e:e}, {difference} roundoffs"
                        )
                    };
                    assert!(difference <= 4.0, "{}", case.complain(function, &what()));
                }
            }
        }
    }
    println!("largest difference: {worst:.2} times what a roundoff of the data does");
}

#[test]
fn the_corpus_has_all_kinds_of_groups() {
    let cases = (0..COUNT).map(|seed| case(seed).expect("it compiles"));
    let mut kinds: Vec<String> = cases
        .flat_map(|case| case.subject.unit.groups.clone())
        .map(|group| group.kind)
        .collect();
    kinds.sort_unstable();
    println!("{} groups: {kinds:?}", kinds.len());
    let in_plane = ["RRR", "RRP", "RPR", "PRP"];
    let links = ["SSR", "SSP", "PPP"];
    let points = [
        "three distances",
        "two distances, one plane",
        "one distance, two planes",
    ];
    for kind in [&in_plane[..], &links, &points].concat() {
        assert!(kinds.iter().any(|k| k == kind), "{kind} is missing");
    }
}
