//! All mechanisms of the golden files and of the folder `mechanisms`: C against the same programs on the runtime's numbers.

use linkage_compiler::ir::CompiledMechanism;
use linkage_corpus::sample;
use linkage_random::{Random, one_in};

use crate::batch::{Batch, Number, Request, UNOPTIMISED};
use crate::machine::Compiler;
use linkage_corpus::given::{self, Given, exported, turning};
use linkage_corpus::reference::Assembled;

/// Sets of dimensions of each mechanism, and positions for each: the defaults and the reference first.
const SETS: usize = 4;
pub(crate) const POSITIONS: usize = 12;

/// Mechanisms of closed forms alone.
fn with_closed_forms() -> Vec<Given> {
    let mut all = exported();
    all.retain(|own| own.unit.coupled.is_empty());
    all.extend(turning());
    all
}

/// One of so many where all have been compared in doubles: other numbers and other flags change the same lines.
fn some(count: usize) -> Vec<Given> {
    one_in(count, with_closed_forms()).collect()
}

/// Dimensions near the defaults.
fn dimensions<T: Number>(unit: &CompiledMechanism, set: usize, random: &mut Random) -> Vec<T> {
    let part = 0.03 * set as f64;
    let scalars = unit.scalars();
    let moved = scalars.map(|own| own.nominal * (1.0 + random.between(-part, part)));
    moved.map(T::from_f64).collect()
}

/// Arguments of a function as numbers of this type.
pub(crate) fn arguments<T: Number>(
    unit: &CompiledMechanism,
    function: usize,
    position: usize,
    random: &mut Random,
) -> Vec<T> {
    let values = given::arguments(unit, function, position, random);
    values.into_iter().map(T::from_f64).collect()
}

/// What is asked of all mechanisms, and what the reference gives: `None` where nothing is assembled.
fn asked<T: Number>(given: &[Given]) -> (Vec<Request<T>>, Vec<Option<Vec<T>>>) {
    let mut random = Random::new(18);
    let (mut requests, mut expected) = (Vec::new(), Vec::new());
    for (mechanism, Given { unit, name }) in given.iter().enumerate() {
        for set in 0..SETS {
            let dimensions: Vec<T> = dimensions(unit, set, &mut random);
            let assembled = Assembled::new(unit, &dimensions);
            assert!(
                set > 0 || assembled.is_some(),
                "{name} is assembled at its defaults"
            );
            for function in 0..unit.functions.len() {
                for position in 0..POSITIONS {
                    let arguments: Vec<T> = arguments(unit, function, position, &mut random);
                    let results = assembled
                        .as_ref()
                        .map(|own| own.call(&unit.functions[function], &arguments));
                    expected.push(results);
                    requests.push(Request {
                        mechanism,
                        function,
                        dimensions: dimensions.clone(),
                        arguments,
                    });
                }
            }
        }
    }
    (requests, expected)
}

/// What an optimiser may do to doubles and singles alike, without its slowest parts.
const OPTIMISED: [&str; 2] = ["-O1", "-ffp-contract=off"];

/// Compares all results to the last bit; any NaN is one.
fn same<T: Number>(name: &str, given: &[Given], flags: &[&str]) {
    let Some(compiler) = Compiler::find() else {
        return;
    };
    let batch = Batch::new::<T>(&compiler, name, given, flags);
    let (count, finite) = compare::<T>(name, given, &batch);
    assert!(
        count > 500 * given.len() && finite > count / 2 && finite < count,
        "{finite} of {count}"
    );
}

/// The same for any program. Returns how many results there are, and how many of them are finite.
pub(crate) fn compare<T: Number>(name: &str, given: &[Given], batch: &Batch) -> (usize, usize) {
    let (requests, expected) = asked::<T>(given);
    let results = batch.run(given, &requests);
    let (mut count, mut finite) = (0, 0);
    for ((request, expected), (code, own)) in requests.iter().zip(&expected).zip(&results) {
        let Given { name, unit } = &given[request.mechanism];
        let function = &unit.functions[request.function].name;
        assert_eq!(*code == 0, expected.is_some(), "{name}: code {code}");
        for (index, (c, rust)) in own.iter().zip(expected.iter().flatten()).enumerate() {
            let (c, rust) = (c.lane(0), rust.lane(0));
            let same = c.to_bits() == rust.to_bits() || (c.is_nan() && rust.is_nan());
            assert!(
                same,
                "{name}::{function}, result {index}: {c:e} in C, {rust:e} in Rust"
            );
            count += 1;
            finite += usize::from(c.is_finite());
        }
    }
    println!(
        "{name}: {} mechanisms, {count} results, {finite} of them finite",
        given.len()
    );
    (count, finite)
}

#[test]
fn doubles_are_those_of_rust() {
    same::<f64>("doubles", &with_closed_forms(), &UNOPTIMISED);
}

#[test]
fn optimised_doubles_are_those_of_rust() {
    same::<f64>("optimised", &some(4), &OPTIMISED);
}

#[test]
fn singles_are_those_of_rust() {
    same::<f32>("singles", &some(8), &OPTIMISED);
}

/// How many random mechanisms: other ones than the corpus's own tests take.
const RANDOM: u64 = 10;

#[test]
fn random_mechanisms_are_those_of_rust() {
    let texts = (0..RANDOM).map(|number| sample(5 * number + 3, "Generated").text);
    let mut given: Vec<Given> = texts.map(|text| Given::text(&text)).collect();
    given.retain(|own| own.unit.coupled.is_empty());
    assert!(given.len() > 3, "{} have closed forms", given.len());
    same::<f64>("random", &given, &OPTIMISED);
}

/// Roundoffs by which fused multiply-adds may change most results; positions next to a dead point multiply roundings.
const FEW: f64 = 2.0;
const MANY: f64 = 4096.0;

/// Fused multiply-adds change roundings and nothing else.
fn fused<T: Number>(name: &str) {
    let Some(compiler) = Compiler::find() else {
        return;
    };
    if !machine_has_fma() {
        println!("skipped: this machine has no fused multiply-add");
        return;
    }
    let given = some(8);
    // What makes multiply-adds, without the rest of `-O2`, which takes as long again.
    let mut arguments = vec!["-O1", "-fexpensive-optimizations", "-ffp-contract=fast"];
    if cfg!(target_arch = "x86_64") {
        arguments.push("-mfma");
    }
    let batch = Batch::new::<T>(&compiler, name, &given, &arguments);
    let (requests, expected) = asked::<T>(&given);
    let results = batch.run(&given, &requests);
    let (mut count, mut few, mut different) = (0, 0, 0);
    for ((request, expected), (_, own)) in requests.iter().zip(&expected).zip(&results) {
        let Given { name, unit } = &given[request.mechanism];
        let function = &unit.functions[request.function].name;
        let rust: Vec<f64> = expected.iter().flatten().map(|x| x.lane(0)).collect();
        let finite = rust.iter().filter(|x| x.is_finite());
        let size = finite.fold(1.0_f64, |most, x| most.max(x.abs()));
        for (index, (c, rust)) in own.iter().zip(&rust).enumerate() {
            let c = c.lane(0);
            let off = match c.is_nan() && rust.is_nan() {
                true => 0.0,
                false => (c - rust).abs() / (size * T::ROUNDOFF),
            };
            assert!(
                off <= MANY,
                "{name}::{function}, result {index}: {c:e} in C, {rust:e} in Rust"
            );
            count += 1;
            few += usize::from(off <= FEW);
            different += usize::from(off > 0.0);
        }
    }
    println!("{name}: {count} results, {different} differ, {few} by {FEW} roundoffs at most");
    assert!(few * 100 > count * 98, "{few} of {count}");
    assert!(
        different * 10 > count,
        "multiply-adds are fused: {different} of {count}"
    );
}

#[cfg(target_arch = "x86_64")]
pub(crate) fn machine_has_fma() -> bool {
    std::arch::is_x86_feature_detected!("fma")
}

#[cfg(not(target_arch = "x86_64"))]
pub(crate) fn machine_has_fma() -> bool {
    cfg!(target_arch = "aarch64")
}

#[test]
fn fused_doubles_are_near() {
    fused::<f64>("fused_doubles");
}

#[test]
fn fused_singles_are_near() {
    fused::<f32>("fused_singles");
}
