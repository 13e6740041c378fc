//! Singles on an emulated Cortex-M4: results to the last bit, and how many instructions a call takes. Where formulas close all loops results are
//! those of Rust. Rust has tables of coupled groups in doubles: there results are those of the same C on this machine, which the tests of these
//! groups compare with Rust.

use std::fmt::Write;
use std::path::Path;

use linkage_c::{Real, Sources, sources};
use linkage_compiler::ir::Function;
use linkage_random::{Random, one_in};

use crate::batch::{Batch, Request, UNOPTIMISED};
use crate::coupled;
use crate::emulated::{COMPILER, FLAGS, build, emulate, printed, tools};
use crate::machine::{self, Compiler};
use crate::mechanisms::{POSITIONS, arguments};
use crate::page;
use linkage_corpus::given::{Given, examples, golden};
use linkage_corpus::reference::Assembled;

/// The page that has figures.
pub(crate) const PAGE: &str = include_str!("../../../docs/c.md");

/// Functions that the page has figures of.
const FIGURES: [&str; 6] = [
    "press_motion",
    "crank_rocker_path",
    "crank_rocker_motion",
    "favorit_needle",
    "favorit_motion",
    "eye_needle_motion",
];

/// Arguments in which no mechanism is assembled, or all are alike.
const SPECIAL: [f32; 6] = [0.0, -0.0, 1e7, -1e30, f32::INFINITY, f32::NAN];

/// A function and its positions.
pub(crate) struct Asked<'a> {
    given: &'a Given,
    mechanism: usize,
    index: usize,
    function: &'a Function,
    dimensions: Vec<f32>,
    positions: Vec<Vec<f32>>,
}

/// Of each function its results at each position.
pub(crate) type Results = Vec<Vec<Vec<f32>>>;

/// All functions, of dimensions that are larger than the defaults by a part of them.
fn asked(all: &[Given], part: f64) -> Vec<Asked<'_>> {
    let mut random = Random::new(4);
    let mut asked = Vec::new();
    for (mechanism, given) in all.iter().enumerate() {
        for (index, function) in given.unit.functions.iter().enumerate() {
            let mut one = |position| arguments(&given.unit, index, position, &mut random);
            let mut positions: Vec<Vec<f32>> = (0..2 * POSITIONS).map(&mut one).collect();
            let alike = |x| vec![x; function.arguments.len()];
            positions.extend(SPECIAL.map(alike));
            asked.push(Asked {
                given,
                mechanism,
                index,
                function,
                dimensions: dimensions(given, part),
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
        let numbers = own.dimensions.iter().chain(own.positions.iter().flatten());
        bytes.extend(numbers.flat_map(|x| x.to_le_bytes()));
    }
    bytes
}

fn dimensions(given: &Given, part: f64) -> Vec<f32> {
    let scalars = given.unit.scalars();
    scalars
        .map(|own| (own.nominal * (1.0 + part)) as f32)
        .collect()
}

pub(crate) fn by_rust(asked: &[Asked]) -> Results {
    let one = |own: &Asked| {
        let assembled = Assembled::new(&own.given.unit, &own.dimensions);
        let assembled = assembled.expect("it is assembled");
        let positions = own.positions.iter();
        positions
            .map(|at| assembled.call(own.function, at))
            .collect()
    };
    asked.iter().map(one).collect()
}

fn by_c(batch: &Batch, all: &[Given], asked: &[Asked]) -> Results {
    let one = |own: &Asked| {
        let request = |at: &Vec<f32>| Request {
            mechanism: own.mechanism,
            function: own.index,
            dimensions: own.dimensions.clone(),
            arguments: at.clone(),
        };
        let requests: Vec<Request<f32>> = own.positions.iter().map(request).collect();
        let results = batch.run(all, &requests).into_iter();
        results.map(|(_, numbers)| numbers).collect()
    };
    asked.iter().map(one).collect()
}

/// Compares results to the last bit; the least and the largest number of instructions of each function.
fn counts(asked: &[Asked], expected: &Results, mut words: &[u32]) -> Vec<[u32; 2]> {
    let mut take = |count: usize| {
        let (own, rest) = words.split_at(count);
        words = rest;
        own
    };
    let (mut counts, mut finite) = (Vec::new(), 0);
    for (asked, expected) in asked.iter().zip(expected) {
        let name = format!("{}::{}", asked.given.name, asked.function.name);
        assert_eq!(
            take(2),
            [0, 1000],
            "{name}: the code, and known instructions"
        );
        let mut own = Vec::new();
        for (position, expected) in asked.positions.iter().zip(expected) {
            own.push(take(1)[0]);
            for (&bits, here) in take(expected.len()).iter().zip(expected) {
                let c = f32::from_bits(bits);
                let same = bits == here.to_bits() || (c.is_nan() && here.is_nan());
                assert!(same, "{name} at {position:?}: {c:e} there, {here:e} here");
                finite += usize::from(c.is_finite());
            }
        }
        let least = own.iter().fold(u32::MAX, |least, one| least.min(*one));
        let most = own.iter().fold(0, |most, one| most.max(*one));
        counts.push([least, most]);
    }
    assert!(words.is_empty(), "no result is left");
    assert!(finite > 20 * asked.len(), "{finite} finite results");
    counts
}

/// The bytes that a program takes for a function, with its constants and what it calls.
fn bytes(compiler: &Compiler, sources: &Sources, function: &str) -> u32 {
    let folder = machine::folder("controller_bytes");
    machine::write(&folder, sources);
    let (entry, file) = (
        format!("-Wl,--gc-sections,-e,{function}"),
        format!("{}.c", sources.name),
    );
    let mut all = FLAGS.to_vec();
    all.extend(["-nostdlib", &entry, &file, "-o", "one"]);
    compiler.run(&folder, &all);
    // Numbers stand under their names; the first one is of code and constants.
    let sizes = printed("arm-none-eabi-size", &folder, &["one"]);
    let numbers = sizes.lines().nth(1).expect("a line of numbers");
    let first = numbers.split_whitespace().next();
    first.and_then(|x| x.parse().ok()).expect("a number")
}

/// A compiler with its version, as the page calls it.
pub(crate) fn version(compiler: &str) -> String {
    let version = printed(compiler, Path::new("."), &["-dumpfullversion"]);
    format!("`{compiler}` {}", version.trim())
}

/// What a call of a function takes, and its sources.
pub(crate) struct Figure {
    pub(crate) call: String,
    /// The least and the largest number over all positions.
    pub(crate) instructions: [u32; 2],
    sources: Sources,
}

/// Figures of all functions of the program in a folder, whose results must be those expected.
pub(crate) fn measure(
    folder: &Path,
    all: &[Given],
    part: f64,
    expected: impl Fn(&[Asked]) -> Results,
) -> Vec<Figure> {
    let asked = asked(all, part);
    let words = emulate(folder, &requests(&asked));
    let counts = counts(&asked, &expected(&asked), &words);
    let figure = |(own, instructions): (&Asked, [u32; 2])| {
        let sources = sources(&own.given.name, &own.given.unit, Real::Single);
        let sources = sources.expect("it can be exported");
        let call = format!("{}_{}", sources.name, own.function.name);
        Figure {
            call,
            instructions,
            sources,
        }
    };
    asked.iter().zip(counts).map(figure).collect()
}

/// The table of the page.
fn table(compiler: &Compiler, figures: &[Figure]) -> String {
    let mut table = "| function | instructions | bytes |\n|---|---|---|\n".to_owned();
    for call in FIGURES {
        let own = figures.iter().find(|own| own.call == call);
        let own = own.expect("it was asked for");
        let bytes = bytes(compiler, &own.sources, call);
        let [instructions, _] = own.instructions;
        let _ = writeln!(table, "| `{call}` | {instructions} | {bytes} |");
    }
    table
}

#[test]
fn a_controller_executes_the_same_instructions_at_all_inputs() {
    let Some(compiler) = tools() else {
        return;
    };
    let mut closed = vec![page::press()];
    // The page has figures of golden mechanisms; examples take as long as all else.
    closed.extend(golden());
    closed.extend(one_in(8, examples()));
    closed.retain(|own| own.unit.coupled.is_empty());
    let built = |name, all: &[Given]| {
        let folder = machine::folder(name);
        build(&compiler, &FLAGS, &folder, all);
        folder
    };
    let mut figures = measure(&built("controller", &closed), &closed, 0.0, by_rust);
    let coupled: Vec<Given> = coupled::some().collect();
    let folder = built("controller_coupled", &coupled);
    let here = Compiler::find().expect("who compiles for controllers can compile for this machine");
    let batch = Batch::new::<f32>(&here, "controller_here", &coupled, &UNOPTIMISED);
    // The second time with the steps that lead from tables to other dimensions.
    for part in [0.0, 1e-3] {
        figures.extend(measure(&folder, &coupled, part, |asked| {
            by_c(&batch, &coupled, asked)
        }));
    }
    for own in &figures {
        println!("{}: {}", own.call, own.instructions[0]);
    }
    let uneven = figures
        .iter()
        .filter(|own| own.instructions[0] != own.instructions[1]);
    let uneven: Vec<_> = uneven.map(|own| (&own.call, own.instructions)).collect();
    assert!(uneven.is_empty(), "instructions differ: {uneven:?}");
    let version = version(COMPILER);
    let table = table(&compiler, &figures);
    println!("\n{version}:\n{table}");
    // Another version has figures of its own.
    let told = !PAGE.contains(&version) || PAGE.contains(&table);
    assert!(
        told,
        "the page has other figures of {version} than\n{table}"
    );
}
