//! All programs of many mechanisms: C against the same programs on the runtime's numbers, on positions, and on numbers that are none.

use std::collections::BTreeSet;

use linkage_corpus::sample;
use linkage_random::Random;
use linkage_symbolic::program::Source;

use crate::batch::{Batch, Request, UNOPTIMISED};
use crate::machine::Compiler;
use linkage_corpus::given::{Given, golden};
use linkage_corpus::numbers::{Numbers, ROUNDS};
use linkage_corpus::programs::{Named, as_functions, loaded, programs, results, same};

/// Compares all results of all programs; how many there are, and how many of them are finite.
fn compare(compiler: &Compiler, file: &str, given: &[Given]) -> (usize, usize) {
    let all: Vec<Vec<Named>> = given.iter().map(|own| programs(&own.unit)).collect();
    let printed = all.iter().zip(given).map(|(programs, own)| Given {
        name: own.name.clone(),
        unit: as_functions(programs),
    });
    let printed: Vec<Given> = printed.collect();
    let (mut requests, mut expected) = (Vec::new(), Vec::new());
    for (mechanism, (programs, own)) in all.iter().zip(given).enumerate() {
        let sources = programs.iter().flat_map(|own| loaded(own.program));
        let sources: BTreeSet<Source> = sources.collect();
        let layout: Vec<Source> = sources.into_iter().collect();
        let mut random = Random::new(mechanism as u64);
        for round in 0..ROUNDS {
            let numbers = Numbers::new(&own.unit, &layout, round, &mut random);
            let results = results(programs, &|source| numbers.load(source));
            for (function, (arguments, rust)) in results.into_iter().enumerate() {
                let what = format!("{}, {}, round {round}", own.name, programs[function].name);
                let finite = rust.iter().all(|x| x.is_finite());
                assert!(finite || round > 0, "{what}: the reference is assembled");
                requests.push(Request {
                    mechanism,
                    function,
                    dimensions: Vec::new(),
                    arguments,
                });
                expected.push((what, rust));
            }
        }
    }
    let batch = Batch::new::<f64>(compiler, file, &printed, &UNOPTIMISED);
    let (mut count, mut finite) = (0, 0);
    for ((what, rust), (_, c)) in expected.iter().zip(batch.run(&printed, &requests)) {
        for (index, (c, rust)) in c.iter().zip(rust).enumerate() {
            assert!(
                same(*c, *rust),
                "{what}, result {index}: {c:e} in C, {rust:e} in Rust"
            );
            count += 1;
            finite += usize::from(c.is_finite());
        }
    }
    let functions: usize = all.iter().map(Vec::len).sum();
    let mechanisms = given.len();
    println!(
        "{file}: {mechanisms} mechanisms, {functions} programs, {count} results, {finite} of them finite"
    );
    (count, finite)
}

#[test]
fn all_programs_of_golden_mechanisms_are_those_of_rust() {
    let Some(compiler) = Compiler::find() else {
        return;
    };
    let (count, finite) = compare(&compiler, "programs_golden", &golden());
    assert!(count > 5_000 && finite > count / 2, "{finite} of {count}");
}

/// How many random mechanisms, every fifth of those that the tests of the corpus take; `ORACLE_COUNT=1000` in the environment takes
/// more.
const COUNT: u64 = 12;

/// How many of them are compiled together.
const TOGETHER: usize = 12;

#[test]
fn all_programs_of_random_mechanisms_are_those_of_rust() {
    let Some(compiler) = Compiler::find() else {
        return;
    };
    let wanted = std::env::var("ORACLE_COUNT").ok();
    let count = wanted.and_then(|text| text.parse().ok()).unwrap_or(COUNT);
    let seeds: Vec<u64> = (0..count).map(|number| 5 * number).collect();
    for (number, seeds) in seeds.chunks(TOGETHER).enumerate() {
        let texts = seeds.iter().map(|seed| sample(*seed, "Generated").text);
        let given: Vec<Given> = texts.map(|text| Given::text(&text)).collect();
        let (count, finite) = compare(&compiler, &format!("programs_random_{number}"), &given);
        let least = 1000 * seeds.len();
        assert!(count > least && finite > count / 2, "{finite} of {count}");
    }
}
