//! All programs of many mechanisms: C against the interpreter.

use std::fs;
use std::path::Path;

use linkage_compiler::unit::Unit;
use linkage_corpus::{sample, unit};
use linkage_random::Random;

use crate::machine::{Compiler, Entry};
use crate::numbers::{Numbers, ROUNDS};
use crate::printer::{Printed, print};

/// What is compiled and run together.
#[derive(Default)]
struct Batch {
    text: String,
    entries: Vec<Entry>,
    requests: Vec<(usize, Vec<f64>)>,
    /// For each request, its name and what the interpreter finds.
    expected: Vec<(String, Vec<f64>)>,
    units: usize,
}

impl Batch {
    fn new() -> Self {
        Self {
            text: "#include \"linkage.h\"\n".to_owned(),
            ..Self::default()
        }
    }

    fn add(&mut self, name: &str, unit: &Unit) {
        let Printed {
            text,
            functions,
            layout,
        } = print(name, unit);
        self.text += &format!("\n{text}");
        let first = self.entries.len();
        for (function, program) in &functions {
            self.entries.push(Entry {
                call: format!("struct {name} m; memcpy(&m, in, sizeof m); {function}(&m, out);"),
                takes: layout.len(),
                gives: program.outputs.len(),
            });
        }
        let mut random = Random::new(self.units as u64);
        for round in 0..ROUNDS {
            let numbers = Numbers::new(unit, &layout, round, &mut random);
            let data: Vec<f64> = layout.iter().map(|&source| numbers.load(source)).collect();
            for (index, (function, program)) in functions.iter().enumerate() {
                self.requests.push((first + index, data.clone()));
                let what = format!("{function}, round {round}");
                let results = numbers.run(program);
                let finite = results.iter().all(|x| x.is_finite());
                assert!(finite || round > 0, "{what}: the reference is assembled");
                self.expected.push((what, results));
            }
        }
        self.units += 1;
    }

    /// Compares all results; how many there are, and how many of them are finite.
    fn check(&self, compiler: &Compiler, file: &str) -> (usize, usize) {
        let executable = compiler.compile(file, &self.text, &self.entries);
        let results = executable.run(&self.requests);
        let mut rest = &results[..];
        for (what, expected) in &self.expected {
            let (own, others) = rest.split_at(expected.len());
            rest = others;
            for (index, (c, interpreter)) in own.iter().zip(expected).enumerate() {
                assert!(
                    same(*c, *interpreter),
                    "{what}, result {index}: {c:e} in C, {interpreter:e} by the interpreter"
                );
            }
        }
        assert!(rest.is_empty(), "no result is left");
        let finite = results.iter().filter(|x| x.is_finite()).count();
        println!(
            "{file}: {} mechanisms, {} functions, {} results, {finite} of them finite",
            self.units,
            self.entries.len(),
            results.len()
        );
        (results.len(), finite)
    }
}

/// Equal to the last bit; any NaN is one.
pub(crate) fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

#[test]
fn golden_mechanisms_give_the_same_in_c() {
    let Some(compiler) = Compiler::find() else {
        return;
    };
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../linkage-compiler/tests/golden");
    let files = fs::read_dir(folder).expect("there are golden files");
    let mut paths: Vec<_> = files.map(|file| file.expect("a file").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|end| end == "mech"));
    paths.sort();
    let mut batch = Batch::new();
    for path in paths {
        let name = path.file_stem().and_then(|name| name.to_str());
        let text = fs::read_to_string(&path).expect("the mechanism can be read");
        let unit = unit(&text).expect("it compiles");
        batch.add(name.expect("a plain name"), &unit);
    }
    let (results, finite) = batch.check(&compiler, "golden");
    assert!(
        results > 5_000 && finite > results / 2,
        "{finite} of {results}"
    );
}

/// How many random mechanisms, every fifth of those that the tests of the corpus take; `ORACLE_COUNT=1000` in the environment takes
/// more.
const COUNT: u64 = 12;

/// How many of them are compiled together.
const TOGETHER: usize = 12;

#[test]
fn random_mechanisms_give_the_same_in_c() {
    let Some(compiler) = Compiler::find() else {
        return;
    };
    let wanted = std::env::var("ORACLE_COUNT").ok();
    let count = wanted.and_then(|text| text.parse().ok()).unwrap_or(COUNT);
    let seeds: Vec<u64> = (0..count).map(|number| 5 * number).collect();
    for (number, seeds) in seeds.chunks(TOGETHER).enumerate() {
        let mut batch = Batch::new();
        for seed in seeds {
            let unit = unit(&sample(*seed, "Generated").text).expect("it compiles");
            batch.add(&format!("generated_{seed}"), &unit);
        }
        let (results, finite) = batch.check(&compiler, &format!("random_{number}"));
        let least = 1000 * seeds.len();
        assert!(
            results > least && finite > results / 2,
            "{finite} of {results}"
        );
    }
}
