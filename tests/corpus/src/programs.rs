//! All programs of a mechanism, not only those that exported C runs: each printed as a function of what it loads.

use std::collections::{BTreeMap, BTreeSet};

use linkage_compiler::ir::{
    Body, Column, CompiledMechanism, Field, Function, Input, Meaning, Shape,
};
use linkage_symbolic::passes::stages::Stage;
use linkage_symbolic::program::{Instruction, Program, Source};

use crate::reference::run;

/// A program with its name.
pub struct Named<'a> {
    /// What it is in the unit.
    pub name: String,
    /// Itself.
    pub program: &'a Program,
    /// What it is the next stage of, if it is no whole program.
    pub stage: Option<(&'a Stage, usize)>,
}

/// All of a unit; stages stand behind the program that they are cut from.
pub fn programs(unit: &CompiledMechanism) -> Vec<Named<'_>> {
    // All fields are named, so that a program that is added is not forgotten here.
    let CompiledMechanism {
        prepare,
        gaps,
        directions,
        bearings,
        survey,
        coupled,
        functions,
        documentation: _,
        length: _,
        parameters: _,
        inputs: _,
        arguments: _,
        unknowns: _,
        angles: _,
        groups: _,
        mobility: _,
        longest: _,
        picture: _,
        surveyed: _,
        surveying: _,
    } = unit;
    let whole = |name: String, program| Named {
        name,
        program,
        stage: None,
    };
    let mut all = vec![
        whole("prepare".to_owned(), prepare),
        whole("gaps".to_owned(), gaps),
        whole("directions".to_owned(), directions),
        whole("bearings".to_owned(), bearings),
        whole("survey".to_owned(), survey),
    ];
    for (number, group) in coupled.iter().enumerate() {
        all.push(whole(format!("system {number}"), &group.system));
        all.push(whole(format!("correct {number}"), &group.correct));
        all.push(whole(format!("placed {number}"), &group.placed));
    }
    for own in functions {
        let beside = own.beside.iter().map(|body| ("beside", body));
        let settled = own.settled.iter().map(|body| ("settled", body));
        let others = beside.chain(settled);
        for (word, body) in [("called", &own.called)].into_iter().chain(others) {
            let name = format!("{word} {}", own.name);
            let given = body.stages.iter().flat_map(|own| &own.results);
            let given: BTreeSet<usize> = given.copied().collect();
            assert!(
                given.into_iter().eq(0..body.program.outputs.len()),
                "{name}: stages give all results"
            );
            let stages = body.stages.iter().enumerate();
            let stages = stages.map(|(number, stage)| Named {
                name: format!("stage {number} of {name}"),
                program: &stage.program,
                stage: Some((stage, number)),
            });
            let stages: Vec<Named> = stages.collect();
            all.push(whole(name, &body.program));
            all.extend(stages);
        }
    }
    all
}

/// What a program loads, each once, but for what is the same for all mechanisms.
pub fn loaded(program: &Program) -> Vec<Source> {
    let mut loaded = Vec::new();
    for instruction in &program.instructions {
        match instruction {
            Instruction::Load(source) if *source != Source::Limit && !loaded.contains(source) => {
                loaded.push(*source);
            }
            _ => {}
        }
    }
    loaded
}

/// A unit with a function for each program, of what that loads.
pub fn as_functions(programs: &[Named]) -> CompiledMechanism {
    let input = |index: usize| Input {
        name: format!("x{index}"),
        unit: String::new(),
        angle: false,
        reference: 0.0,
        range: None,
        followed: (0.0, 0.0),
        rates: Vec::new(),
    };
    let widths = programs.iter().map(|own| loaded(own.program).len());
    CompiledMechanism {
        inputs: (0..widths.max().unwrap_or_default()).map(input).collect(),
        functions: programs.iter().enumerate().map(as_function).collect(),
        ..CompiledMechanism::default()
    }
}

fn as_function((index, own): (usize, &Named)) -> Function {
    let sources = loaded(own.program);
    let places: BTreeMap<Source, usize> = sources.iter().copied().zip(0..).collect();
    let mut program = own.program.clone();
    for instruction in &mut program.instructions {
        if let Instruction::Load(source) = instruction {
            *source = places
                .get(source)
                .map_or(*source, |&place| Source::Input(place));
        }
    }
    let results = 0..program.outputs.len();
    let field = |index: usize| Field {
        name: format!("r{index}"),
        documentation: String::new(),
        shape: Shape::Scalar,
        unit: String::new(),
        about: String::new(),
        reaction: None,
        driven_acceleration: None,
    };
    let column = |index: usize| Column {
        name: format!("r{index}"),
        unit: String::new(),
        meaning: Meaning::Value,
    };
    Function {
        name: format!("program_{index}"),
        documentation: String::new(),
        arguments: (0..sources.len()).collect(),
        states: Vec::new(),
        fields: results.clone().map(field).collect(),
        columns: results.map(column).collect(),
        called: Body {
            program,
            ..Body::default()
        },
        beside: None,
        settled: None,
        sensitivities: None,
    }
}

/// Runs all programs; for each what it was given, then its results. Stages must give the results of the program that they are cut from.
pub fn results(programs: &[Named], load: &dyn Fn(Source) -> f64) -> Vec<(Vec<f64>, Vec<f64>)> {
    let mut whole: Vec<f64> = Vec::new();
    let mut memory: BTreeMap<usize, f64> = BTreeMap::new();
    let mut all = Vec::new();
    for own in programs {
        if own.stage.is_none_or(|(_, number)| number == 0) {
            memory.clear();
        }
        let place = |source: Source| match source {
            Source::Carried(index) => {
                let (stage, _) = own.stage.expect("only stages take from others");
                memory[&stage.taken[index]]
            }
            other => load(other),
        };
        let given = loaded(own.program).into_iter().map(place).collect();
        let results = run(own.program, place);
        match own.stage {
            None => whole.clone_from(&results),
            Some((stage, _)) => {
                let (kept, last) = results.split_at(stage.kept.len());
                for (&index, x) in stage.results.iter().zip(last) {
                    assert!(same(*x, whole[index]), "{}, result {index}", own.name);
                }
                memory.extend(stage.kept.iter().copied().zip(kept.iter().copied()));
            }
        }
        all.push((given, results));
    }
    all
}

/// Equal to the last bit; any NaN is one.
pub fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}
