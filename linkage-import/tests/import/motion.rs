//! Imported texts, compiled and moved: the drawn pose, and 361 positions against the solver.

use linkage_engine::Mechanism;
use linkage_import::Options;

use crate::facts::{Facts, Input, facts};
use crate::files::{all, imported, name};
use crate::newton::{Positions, Solver};

const POSITIONS: usize = 361;
/// Of the size of the mechanism.
const TOLERANCE: f64 = 1e-9;

/// The inputs of the facts, for files that name none.
fn options(facts: &Facts) -> Options {
    let inputs = facts.inputs.iter().filter_map(|input| match *input {
        Input::Crank { pivot, other } => {
            Some(format!("{},{}", facts.names[pivot], facts.names[other]))
        }
        Input::Length(..) => None,
    });
    Options {
        inputs: inputs.collect(),
        ..Options::default()
    }
}

/// Returns the positions in a text: numbers of `joint NAME = (X, Y);`.
fn written(text: &str, facts: &Facts) -> Positions {
    let read = |name: &String| {
        let start = format!("    joint {name} = (");
        let from = text
            .find(&start)
            .unwrap_or_else(|| panic!("{name}: {text}"));
        let pair = &text[from + start.len()..];
        let pair = &pair[..pair.find(')').expect("a bracket")];
        let numbers = pair.split(',').map(|number| {
            let is_unit = |letter: char| letter.is_ascii_alphabetic();
            number
                .trim()
                .trim_end_matches(is_unit)
                .parse()
                .expect("a number")
        });
        let numbers: Vec<f64> = numbers.collect();
        [numbers[0], numbers[1]]
    };
    facts.names.iter().map(read).collect()
}

#[test]
fn files_have_the_positions_of_the_facts() {
    for file in all() {
        let facts = facts(&name(&file));
        let text = imported(&file, &options(&facts)).text;
        for (found, (joint, wanted)) in written(&text, &facts).iter().zip(&facts.joints) {
            for axis in 0..2 {
                let error = (found[axis] - wanted[axis]).abs();
                assert!(
                    error < 1e-9 * facts.size,
                    "{}: {joint} {error}",
                    file.display()
                );
            }
        }
    }
}

/// All joints that move, from the function of the imported text.
fn computed(mechanism: &linkage_engine::Assembly, facts: &Facts, inputs: &[f64]) -> Positions {
    let results = mechanism.results("points", inputs);
    let joints = facts.joints.iter().enumerate();
    let point = |(index, joint): (usize, &(String, [f64; 2]))| {
        if facts.fixed.contains(&index) {
            joint.1
        } else {
            results.vector::<2>(&facts.names[index])
        }
    };
    joints.map(point).collect()
}

fn farthest(a: &Positions, b: &Positions) -> f64 {
    let pairs = a.iter().zip(b);
    let distances = pairs.map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]));
    distances.fold(0.0, |most, distance| {
        if distance > most || distance.is_nan() {
            distance
        } else {
            most
        }
    })
}

/// Sets the joints that cranks point to: those that the text has chosen.
fn point_cranks(facts: &mut Facts, text: &str) {
    let is_crank = |input: &&Input| matches!(input, Input::Crank { .. });
    let count = facts.inputs.iter().filter(is_crank).count();
    let mut index = 0;
    for input in &mut facts.inputs {
        let Input::Crank { other, .. } = input else {
            continue;
        };
        index += 1;
        let end = if count > 1 {
            format!(" at phi{index};")
        } else {
            " at phi;".to_owned()
        };
        let line = text.lines().find(|line| line.ends_with(&end));
        let (_, joints) = line
            .and_then(|line| line.split_once(": "))
            .expect("a crank");
        let name = joints
            .split([',', ' '])
            .filter(|name| !name.is_empty())
            .nth(1);
        let found = facts
            .names
            .iter()
            .position(|known| Some(&known[..]) == name);
        *other = found.expect("a joint of the facts");
    }
}

fn moves(prefix: &str) {
    let mut failures = Vec::new();
    for file in all().iter().filter(|file| name(file).starts_with(prefix)) {
        if let Err(failure) = compared(file) {
            failures.push(format!("{}: {failure}", name(file)));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

fn compared(file: &std::path::Path) -> Result<(), String> {
    let mut facts = facts(&name(file));
    let is_named = file
        .extension()
        .is_some_and(|extension| extension == "pyslvs");
    let options = if is_named {
        options(&facts)
    } else {
        Options::default()
    };
    let text = imported(file, &options).text;
    point_cranks(&mut facts, &text);
    let mechanism = Mechanism::compile(&text).map_err(|error| format!("{error}\n{text}"))?;
    let assembly = mechanism
        .assemble(&mechanism.dimensions())
        .map_err(|error| error.to_string())?;
    let reference = mechanism.reference();
    let drawn = written(&text, &facts);
    let pose = computed(&assembly, &facts, &reference);
    let error = farthest(&pose, &drawn) / facts.size;
    // Pins of slots are drawn beside them by the rounding of the file.
    let is_rounded = file
        .extension()
        .is_some_and(|extension| extension == "pmks");
    let tolerance = if is_rounded { 2e-3 / facts.size } else { 1e-6 };
    if error.is_nan() || error > tolerance {
        return Err(format!("the drawn pose is {error:e} away"));
    }
    let solver = Solver::new(&facts, drawn);
    if facts.inputs.len() != reference.len() {
        return Err(format!("{} inputs", reference.len()));
    }
    let mut count = 0;
    for (index, input) in mechanism.inputs().iter().enumerate() {
        let (low, high) = input.ends();
        let start = solver
            .solve(&pose, &reference)
            .ok_or("the solver fails at the start")?;
        for end in [low, high] {
            let mut positions = start.clone();
            let part = ((end - reference[index]).abs() / (high - low) * POSITIONS as f64).ceil();
            for step in 1..=part as usize {
                let mut inputs = reference.clone();
                inputs[index] += (end - reference[index]) * step as f64 / part;
                positions = solver
                    .solve(&positions, &inputs)
                    .ok_or_else(|| format!("the solver fails at {inputs:?}"))?;
                count += 1;
                let found = computed(&assembly, &facts, &inputs);
                let error = farthest(&found, &positions) / facts.size;
                if error.is_nan() || error > TOLERANCE {
                    return Err(format!("{error:e} at {inputs:?}"));
                }
            }
        }
    }
    if count < POSITIONS {
        return Err(format!("{count} positions"));
    }
    Ok(())
}

#[test]
fn drawings_of_linkage() {
    moves("l2");
}

#[test]
fn drawings_of_galleries() {
    moves("g");
}

#[test]
fn drawings_of_addresses() {
    moves("u");
}

#[test]
fn drawings_of_payloads() {
    moves("b_");
    moves("c_");
}

#[test]
fn drawings_of_expressions() {
    moves("e");
}

#[test]
fn public_examples() {
    moves("x");
}
