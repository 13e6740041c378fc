//! The engine against programs, for a corpus of random mechanisms; programs against the graph, and what is in programs
//! at all, for more of them.

mod dynamics;
mod oracle;
mod quotients;

use linkage_compiler::Checked;
use linkage_corpus::given::example;
use linkage_corpus::{COUNT, Case, Kind, Position, Subject};
use linkage_engine::Mechanism;
use linkage_random::Random;
use linkage_symbolic::program::{Instruction, Program, Source, Value};
use std::collections::BTreeSet;
use std::sync::{Arc, OnceLock};

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

// A machine of parts: its programs, some of them made of the graph of one part alone, against the graph of the whole.

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

// The evaluators' programs contain no operation that could have been done once in `assemble()`, and none without use.

/// Every operation depends on an input.
fn check_early_work(program: &Program, name: &str) {
    let mut late: Vec<bool> = Vec::new();
    for instruction in &program.instructions {
        let operands: Vec<Value> = instruction.operands().collect();
        let is_late = matches!(instruction, Instruction::Load(Source::Input(_)))
            || operands.iter().any(|operand| late[operand.0]);
        // What is made of constants is one for the compiler.
        let constant = |x: &Value| matches!(program.instructions[x.0], Instruction::Constant(_));
        assert!(
            is_late || operands.iter().all(constant),
            "{name}: {instruction:?} belongs into assemble()\n{program}"
        );
        late.push(is_late);
    }
}

/// Every operation is used by a later one or is a result; constants cost nothing.
fn check_use(program: &Program, name: &str) {
    let mut used = vec![false; program.instructions.len()];
    program
        .outputs
        .iter()
        .for_each(|output| used[output.0] = true);
    for (place, instruction) in program.instructions.iter().enumerate().rev() {
        let free = matches!(instruction, Instruction::Constant(_));
        assert!(
            free || used[place],
            "{name}: nobody needs {instruction:?}\n{program}"
        );
        instruction
            .operands()
            .for_each(|operand| used[operand.0] = true);
    }
}

#[test]
fn programs_are_sliced() {
    for seed in 0..80 {
        let case = case(seed).unwrap_or_else(|message| panic!("{message}"));
        let unit = &case.subject.unit;
        let name = format!("seed {seed}");
        for function in &unit.functions {
            check_early_work(&function.called.program, &name);
            check_use(&function.called.program, &name);
        }
        check_early_work(&unit.gaps, &name);
        check_use(&unit.gaps, &name);
        check_use(&unit.prepare, &name);
    }
}
