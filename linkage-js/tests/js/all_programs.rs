//! All programs of many mechanisms to the last bit, on positions and on numbers that are none. Tangents and arcs of single numbers are the browser's
//! and not Rust's, so both get others here, which are made of sums, products and quotients.

use std::collections::BTreeSet;

use linkage_compiler::ir::Generated;
use linkage_corpus::given::{Given, golden};
use linkage_corpus::numbers::{Numbers, ROUNDS};
use linkage_corpus::programs::{Named, as_functions, loaded, programs, same};
use linkage_corpus::sample;
use linkage_random::Random;
use linkage_symbolic::interpret::{Arithmetic, run_by};
use linkage_symbolic::program::{Binary, Fused, Source, Ternary, Unary};

use crate::page::{WRITTEN, list, page, read};

/// In place of the browser's functions.
const SIMPLE: &str = "
    Math.tan = (x) => x / (2 + x * x);
    Math.atan = (x) => x / (3 + x * x);
    Math.asin = (x) => Math.sqrt(1 - x * x) + x;
    Math.acos = (x) => Math.sqrt(1 - x * x) - x;
";

/// The same in Rust.
struct Simple;

impl Arithmetic for Simple {
    type Number = f64;

    fn constant(x: f64) -> f64 {
        x
    }

    fn unary(op: Unary, a: f64) -> f64 {
        let limited = if a.abs() < 1_073_741_824.0 {
            a
        } else {
            f64::NAN
        };
        match op {
            Unary::Tan => limited / (2.0 + limited * limited),
            Unary::Atan => a / (3.0 + a * a),
            Unary::Asin => (1.0 - a * a).sqrt() + a,
            Unary::Acos => (1.0 - a * a).sqrt() - a,
            Unary::Neg
            | Unary::Abs
            | Unary::Sqrt
            | Unary::Sin
            | Unary::Cos
            | Unary::Sign
            | Unary::Round
            | Unary::Slack
            | Unary::InverseScale => Generated::<f64, false>::unary(op, a),
        }
    }

    fn binary(op: Binary, a: f64, b: f64) -> f64 {
        Generated::<f64, false>::binary(op, a, b)
    }

    fn ternary(op: Ternary, a: f64, b: f64, c: f64) -> f64 {
        Generated::<f64, false>::ternary(op, a, b, c)
    }

    fn fused(op: Fused, a: f64, b: f64, c: f64) -> f64 {
        Generated::<f64, false>::fused(op, a, b, c)
    }
}

/// Compares all results of all whole programs; how many there are, and how many of them are finite.
fn compare(given: &[Given]) -> Option<(usize, usize)> {
    let all: Vec<Vec<Named>> = given.iter().map(whole).collect();
    let printed = all.iter().zip(given).map(|(programs, own)| Given {
        name: own.name.clone(),
        unit: as_functions(programs),
    });
    let mut page = page(&printed.collect::<Vec<_>>(), &format!("{WRITTEN}{SIMPLE}"))?;
    let (mut count, mut finite) = (0, 0);
    for (mechanism, (programs, own)) in all.iter().zip(given).enumerate() {
        let sources = programs.iter().flat_map(|own| loaded(own.program));
        let sources: BTreeSet<Source> = sources.collect();
        let layout: Vec<Source> = sources.into_iter().collect();
        let mut random = Random::new(mechanism as u64);
        let rounds: Vec<Numbers> = (0..ROUNDS)
            .map(|round| Numbers::new(&own.unit, &layout, round, &mut random))
            .collect();
        for (function, program) in programs.iter().enumerate() {
            let places = loaded(program.program);
            let given = rounds.iter().map(|numbers| {
                let own: Vec<f64> = places.iter().map(|&place| numbers.load(place)).collect();
                list(&own)
            });
            let given = given.collect::<Vec<_>>().join(",");
            let answer = page.words(&format!(
                "(() => {{ const own = mechanisms[{mechanism}].assemble(); const run = (given) => Object.values(own.program_{function}(...given)); return \
                 [{given}].map((given) => written(run(given))).join(\" \"); }})()"
            ));
            let expected = rounds.iter().flat_map(|numbers| {
                run_by::<Simple>(program.program, |source| numbers.load(source))
            });
            let expected: Vec<f64> = expected.collect();
            let answer = read(&answer);
            assert_eq!(answer.len(), expected.len());
            for (index, (js, rust)) in answer.iter().zip(&expected).enumerate() {
                let name = &program.name;
                assert!(
                    same(*js, *rust),
                    "{}, {name}, number {index}: {js:e} in JavaScript, {rust:e} in Rust",
                    own.name
                );
                count += 1;
                finite += usize::from(js.is_finite());
            }
        }
    }
    Some((count, finite))
}

/// Stages are for loops over many positions, and not printed.
fn whole(own: &Given) -> Vec<Named<'_>> {
    let mut all = programs(&own.unit);
    all.retain(|own| own.stage.is_none());
    all
}

#[test]
fn all_programs_of_golden_mechanisms_are_those_of_rust() {
    let Some((count, finite)) = compare(&golden()) else {
        return;
    };
    println!("{count} results, {finite} of them finite");
    assert!(count > 5_000 && finite > count / 2, "{finite} of {count}");
}

/// How many random mechanisms; `ORACLE_COUNT=1000` in the environment takes more.
const COUNT: u64 = 12;

#[test]
fn all_programs_of_random_mechanisms_are_those_of_rust() {
    let wanted = std::env::var("ORACLE_COUNT").ok();
    let count = wanted.and_then(|text| text.parse().ok()).unwrap_or(COUNT);
    let texts = (0..count).map(|number| sample(7 * number + 3, "Generated").text);
    let given: Vec<Given> = texts.map(|text| Given::text(&text)).collect();
    let Some((results, finite)) = compare(&given) else {
        return;
    };
    let least = 500 * count as usize;
    assert!(
        results > least && finite > results / 2,
        "{finite} of {results}"
    );
}
