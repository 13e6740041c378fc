//! Generated code against the interpreter, for a corpus of random mechanisms; the interpreter against the graph, and what is in programs at
//! all, for more of them.
//!
//! `UPDATE=1 cargo test -p linkage-corpus --test corpus` writes the corpus anew.

mod oracle;
mod parts;
mod quotients;
mod slicing;

use std::path::Path;
use std::sync::{Arc, OnceLock};

use linkage::{Vector2, Vector3};
use linkage_corpus::{COUNT, Case, Kind, Part, code};
use linkage_random::Random;

mod mechanisms;
#[cfg(feature = "whole")]
mod more_mechanisms;

/// The mechanisms that are compiled, by their seeds.
fn compiled() -> Vec<(u64, Results)> {
    let parts = [
        mechanisms::ALL,
        #[cfg(feature = "whole")]
        more_mechanisms::ALL,
    ];
    parts.concat()
}

/// Assembles with changed parameters and calls all functions at inputs; one list of numbers for each function.
type Results = fn(changes: &[f64], inputs: &[f64]) -> Vec<Vec<f64>>;

/// The numbers of a result, in order.
trait Numbers {
    fn append(&self, numbers: &mut Vec<f64>);
}

impl Numbers for f64 {
    fn append(&self, numbers: &mut Vec<f64>) {
        numbers.push(*self);
    }
}

impl Numbers for Vector2<f64> {
    fn append(&self, numbers: &mut Vec<f64>) {
        numbers.extend([self.x, self.y]);
    }
}

impl Numbers for Vector3<f64> {
    fn append(&self, numbers: &mut Vec<f64>) {
        numbers.extend([self.x, self.y, self.z]);
    }
}

impl<N: Numbers, const COUNT: usize> Numbers for [N; COUNT] {
    fn append(&self, numbers: &mut Vec<f64>) {
        self.iter().for_each(|entry| entry.append(numbers));
    }
}

fn numbers(fields: &[&dyn Numbers]) -> Vec<f64> {
    let mut numbers = Vec::new();
    fields.iter().for_each(|field| field.append(&mut numbers));
    numbers
}

/// A module with a mechanism and its results.
macro_rules! corpus {
    ($module:ident $name:ident [$($($parameter:ident).+),*] { $($text:tt)* }
     $($function:ident($($input:literal),*): $($field:ident),*;)*) => {
        // Random mechanisms have parameters that nothing uses.
        #[allow(deprecated)]
        mod $module {
            linkage::mechanism! { $($text)* }

            pub(super) fn results(changes: &[f64], inputs: &[f64]) -> Vec<Vec<f64>> {
                let mut mechanism = $name::default();
                let mut changes = changes.iter();
                $(mechanism.$($parameter).+ += changes.next().expect("one for each parameter");)*
                let linkage = mechanism.assemble().expect("it assembles");
                vec![$({
                    let result = linkage.$function($(inputs[$input]),*);
                    crate::numbers(&[$(&result.$field),*])
                }),*]
            }
        }
    };
}
pub(crate) use corpus;

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

#[test]
fn the_corpus_is_what_the_generator_writes() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus");
    for (part, file) in [
        (Part::Always, "mechanisms.rs"),
        (Part::Long, "more_mechanisms.rs"),
    ] {
        let (text, path) = (code(part), folder.join(file));
        if std::env::var_os("UPDATE").is_some() {
            std::fs::write(path, text).expect("the corpus can be written");
            continue;
        }
        let there = std::fs::read_to_string(path).expect("the corpus can be read");
        assert!(
            there == text,
            "the generator has changed: UPDATE=1 writes the corpus anew"
        );
    }
}

#[test]
fn generated_code_agrees_with_the_interpreter() {
    let mut worst = 0.0;
    for (seed, results) in compiled() {
        let case = case(seed).unwrap_or_else(|message| panic!("{message}"));
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
            let compiled = results(&changes, &at.inputs);
            for (index, function) in case.sample.functions.iter().enumerate() {
                if function.kind == Kind::Closure {
                    continue;
                }
                let expected = case.subject.by_program(index, &at);
                let differences = case.differences(index, &at, &compiled[index], &expected);
                for (k, difference) in differences.into_iter().enumerate() {
                    worst = f64::max(worst, difference);
                    let (c, e) = (compiled[index][k], expected[k]);
                    let entry = function.entries.get(k);
                    let what = || {
                        format!(
                            "result {k} {entry:?}: compiled {c:e}, interpreted {e:e}, {difference} roundoffs"
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
