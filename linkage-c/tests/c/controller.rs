//! Singles on an emulated Cortex-M4: results to the last bit, and how many instructions a call takes.

use std::fmt::Write;
use std::path::Path;

use linkage_c::{Real, sources};
use linkage_compiler::unit::Function;
use linkage_random::Random;

use crate::emulated::{COMPILER, FLAGS, build, emulate, printed, tools};
use crate::given::{Given, exported};
use crate::machine::{self, Compiler};
use crate::mechanisms::{POSITIONS, arguments};
use crate::page;
use crate::reference::Assembled;

/// The page that has figures.
const PAGE: &str = include_str!("../../../docs/c.md");

/// Mechanisms and functions that the page has figures of.
const FIGURES: [(&str, &str); 5] = [
    ("Press", "motion"),
    ("CrankRocker", "path"),
    ("CrankRocker", "motion"),
    ("Favorit", "needle"),
    ("Favorit", "motion"),
];

/// Arguments in which no mechanism is assembled, or all are alike.
const SPECIAL: [f32; 6] = [0.0, -0.0, 1e7, -1e30, f32::INFINITY, f32::NAN];

/// A function and its positions.
struct Asked<'a> {
    given: &'a Given,
    function: &'a Function,
    positions: Vec<Vec<f32>>,
}

fn asked(all: &[Given]) -> Vec<Asked<'_>> {
    let mut random = Random::new(4);
    let mut asked = Vec::new();
    for given in all {
        for (index, function) in given.unit.functions.iter().enumerate() {
            let mut one = |position| arguments(&given.unit, index, position, &mut random);
            let mut positions: Vec<Vec<f32>> = (0..2 * POSITIONS).map(&mut one).collect();
            let alike = |x| vec![x; function.arguments.len()];
            positions.extend(SPECIAL.map(alike));
            asked.push(Asked {
                given,
                function,
                positions,
            });
        }
    }
    asked
}

fn requests(asked: &[Asked]) -> Vec<u8> {
    let mut bytes = Vec::new();
    for (number, own) in asked.iter().enumerate() {
        let head = [number as u32, own.positions.len() as u32];
        bytes.extend(head.into_iter().flat_map(u32::to_le_bytes));
        let dimensions = dimensions(own.given);
        let numbers = dimensions.iter().chain(own.positions.iter().flatten());
        bytes.extend(numbers.flat_map(|x| x.to_le_bytes()));
    }
    bytes
}

fn dimensions(given: &Given) -> Vec<f32> {
    let scalars = given.unit.scalars();
    scalars.map(|own| own.nominal as f32).collect()
}

/// Compares results to the last bit; the number of instructions of each function, which is the same in all positions.
fn counts(asked: &[Asked], mut words: &[u32]) -> Vec<u32> {
    let mut take = |count: usize| {
        let (own, rest) = words.split_at(count);
        words = rest;
        own
    };
    let (mut counts, mut uneven, mut finite) = (Vec::new(), String::new(), 0);
    for Asked {
        given,
        function,
        positions,
    } in asked
    {
        let name = format!("{}::{}", given.name, function.name);
        let reference = Assembled::new(&given.unit, &dimensions(given)).expect("it is assembled");
        assert_eq!(
            take(2),
            [0, 1000],
            "{name}: the code, and known instructions"
        );
        let mut own = Vec::new();
        for position in positions {
            own.push(take(1)[0]);
            let expected: Vec<f32> = reference.call(function, position);
            for (&bits, rust) in take(expected.len()).iter().zip(expected) {
                let c = f32::from_bits(bits);
                let same = bits == rust.to_bits() || (c.is_nan() && rust.is_nan());
                assert!(same, "{name} at {position:?}: {c:e} in C, {rust:e} in Rust");
                finite += usize::from(c.is_finite());
            }
        }
        let (least, most) = (own.iter().min(), own.iter().max());
        if least != most {
            let _ = writeln!(uneven, "{name}: {own:?}");
        }
        counts.push(own[0]);
    }
    assert!(words.is_empty(), "no result is left");
    assert!(finite > 20 * asked.len(), "{finite} finite results");
    assert!(uneven.is_empty(), "instructions differ:\n{uneven}");
    counts
}

/// The bytes that a program takes for a function, with its constants and what it calls.
fn bytes(compiler: &Compiler, folder: &Path, source: &str, function: &str) -> u32 {
    let entry = format!("-Wl,--gc-sections,-e,{function}");
    let mut all = FLAGS.to_vec();
    all.extend(["-nostdlib", &entry, source, "-o", "one"]);
    compiler.run(folder, &all);
    // Numbers stand under their names; the first one is of code and constants.
    let sizes = printed("arm-none-eabi-size", folder, &["one"]);
    let numbers = sizes.lines().nth(1).expect("a line of numbers");
    let first = numbers.split_whitespace().next();
    first.and_then(|x| x.parse().ok()).expect("a number")
}

/// The table of the page.
fn table(compiler: &Compiler, folder: &Path, asked: &[Asked], counts: &[u32]) -> String {
    let mut table = "| function | instructions | bytes |\n|---|---|---|\n".to_owned();
    for (mechanism, function) in FIGURES {
        let place = asked
            .iter()
            .position(|own| own.given.name == mechanism && own.function.name == function);
        let place = place.expect("it was asked for");
        let given = asked[place].given;
        let sources = sources(mechanism, &given.unit, Real::Single).expect("it can be exported");
        machine::write(folder, &sources);
        let call = format!("{}_{function}", sources.name);
        let bytes = bytes(compiler, folder, &format!("{}.c", sources.name), &call);
        let _ = writeln!(table, "| `{call}` | {} | {bytes} |", counts[place]);
    }
    table
}

#[test]
fn a_controller_executes_the_same_instructions_at_all_inputs() {
    let Some(compiler) = tools() else {
        return;
    };
    let mut all = vec![page::press()];
    all.extend(exported());
    all.retain(|own| own.unit.coupled.is_empty());
    let folder = machine::folder("controller");
    build(&compiler, &folder, &all);
    let asked = asked(&all);
    let counts = counts(&asked, &emulate(&folder, &requests(&asked)));
    for (own, count) in asked.iter().zip(&counts) {
        println!("{}::{}: {count}", own.given.name, own.function.name);
    }
    let version = printed(COMPILER, &folder, &["-dumpfullversion"]);
    let version = format!("`{COMPILER}` {}", version.trim());
    let table = table(&compiler, &folder, &asked, &counts);
    println!("\n{version}:\n{table}");
    // Another version has figures of its own.
    let told = !PAGE.contains(&version) || PAGE.contains(&table);
    assert!(
        told,
        "the page has other figures of {version} than\n{table}"
    );
}
