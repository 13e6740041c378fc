//! The command gives what the macro's code gives on the same machine: every number of every function, to the last bit.

use std::path::Path;

use linkage_cli::{Mechanism, Source};
use linkage_command::{Subject, all};
use linkage_compiler::check;
use linkage_random::Random;

/// Positions of each function.
const POSITIONS: usize = 40;

fn read(subject: &Subject) -> Mechanism {
    let source = Source::read(Path::new(subject.path)).expect("it can be read");
    let checked = check(source.calls()[subject.number].tokens.clone());
    Mechanism::new(&checked).expect("a mechanism without a mistake")
}

/// Arguments of a function: inputs in their ranges and a little beyond, others of any size.
fn arguments(mechanism: &Mechanism, function: usize, random: &mut Random) -> Vec<f64> {
    let places = mechanism.unit.functions[function].arguments.iter();
    places
        .map(|&place| match mechanism.inputs.get(place) {
            Some(input) => {
                let (low, high) = input.ends();
                let beyond = 0.02 * (high - low);
                random.between(low - beyond, high + beyond)
            }
            None => random.between(-20.0, 20.0),
        })
        .collect()
}

/// Compares all functions with these dimensions; how many numbers there were, and how many of them are finite.
fn compare(subject: &Subject, mechanism: &Mechanism, dimensions: &[f64]) -> [usize; 2] {
    let mut random = Random::new(7);
    let macros = (subject.assembled)(dimensions);
    let own = mechanism.assemble(dimensions);
    let name = subject.name;
    let (macros, own) = match (macros, own) {
        (Ok(macros), Ok(own)) => (macros, own),
        (macros, own) => {
            let [macros, own] = [macros.err(), own.err().map(|error| error.to_string())];
            assert_eq!(macros, own, "{name}");
            return [0; 2];
        }
    };
    let (mut count, mut finite) = (0, 0);
    for (number, heading) in mechanism.headings.iter().enumerate() {
        for _ in 0..POSITIONS {
            let x = arguments(mechanism, number, &mut random);
            let (expected, found) = (macros(number, &x), own.call(number, &x));
            assert_eq!(expected.len(), heading.columns.len());
            assert_eq!(expected.len(), found.len());
            for ((a, b), column) in expected.iter().zip(&found).zip(heading.columns) {
                let same = a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
                let what = format!("{name}, {}({x:?}).{}", heading.function, column.name);
                assert!(same, "{what}: {a:e} by the macro, {b:e} by the command");
                count += 1;
                finite += usize::from(a.is_finite());
            }
        }
    }
    [count, finite]
}

#[test]
fn every_number_is_that_of_the_macro() {
    let (mut count, mut finite) = (0, 0);
    let subjects = all();
    assert!(subjects.len() > 25, "{} mechanisms", subjects.len());
    for subject in &subjects {
        let mechanism = read(subject);
        assert_eq!((subject.structure)(), mechanism.structure.to_string());
        let nominal = mechanism.dimensions();
        let mut random = Random::new(3);
        let mut off = |part: f64| -> Vec<f64> {
            let factors = nominal
                .iter()
                .map(|x| x * random.between(1.0 - part, 1.0 + part));
            factors.collect()
        };
        // Slightly others, and such that some do not assemble, or not everywhere: then it is said in the same words.
        let others = [off(0.002), off(0.15), off(0.4)];
        for dimensions in [nominal.clone()].into_iter().chain(others) {
            let [own, sound] = compare(subject, &mechanism, &dimensions);
            count += own;
            finite += sound;
        }
    }
    println!(
        "{} mechanisms, {count} numbers, {finite} of them finite",
        subjects.len()
    );
    assert!(count > 80_000 && finite > count / 2 && finite < count);
}

#[test]
fn assemblies_and_circuits_are_those_of_the_macro() {
    for subject in all() {
        let mechanism = read(&subject);
        let dimensions = mechanism.dimensions();
        let found = mechanism.assemblies(&dimensions, &mechanism.reference());
        let modes = found.iter().flatten().map(|own| own.modes().to_vec());
        assert_eq!(
            (subject.listed)(),
            modes.collect::<Vec<_>>(),
            "{}",
            subject.name
        );
        let printed = mechanism.circuits(&dimensions).map(|found| match found {
            Ok(all) => all.to_string(),
            Err(error) => error.to_string(),
        });
        assert_eq!((subject.circuits)(), printed, "{}", subject.name);
    }
}
