//! The command gives what the macro's code gives on the same machine: every number of every function, to the last bit.

use linkage_command::{Subject, all, arguments, read};
use linkage_engine::{Columns, Mechanism, Table};
use linkage_random::Random;

/// Positions of each function.
const POSITIONS: usize = 40;

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
    for (number, heading) in mechanism.headings().iter().enumerate() {
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
        assert_eq!((subject.structure)(), mechanism.structure().to_string());
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

/// Compares the rows of a sweep; how many numbers there were. Rows of coupled groups that are followed to other dimensions have the
/// same values, on another way with other steps: `near` allows that.
fn compare_rows(name: &str, macros: &[Vec<f64>], found: &Columns, near: f64) -> usize {
    assert_eq!(macros.len(), found.rows(), "{name}");
    let mut count = 0;
    for (row, numbers) in macros.iter().enumerate() {
        for (column, a) in numbers.iter().enumerate() {
            let b = found.column(column)[row];
            let size = numbers.iter().fold(1.0, |size: f64, x| size.max(x.abs()));
            let same = a.to_bits() == b.to_bits()
                || (a.is_nan() && b.is_nan())
                || (a - b).abs() <= near * size;
            let title = found.heading().columns[column].name;
            assert!(
                same,
                "{name}.{title}, row {row}: {a:e} by the macro, {b:e} by the engine"
            );
            count += 1;
        }
    }
    count
}

/// Without optimisation a sweep over sets of a mechanism with coupled groups takes two megabytes of stack, all that a test has.
#[test]
fn sweeps_are_those_of_the_macro() {
    let thread = std::thread::Builder::new().stack_size(1 << 23);
    let compared = thread.spawn(compare_sweeps).expect("a thread starts");
    compared.join().expect("all are equal");
}

fn compare_sweeps() {
    let mut count = 0;
    for subject in &all() {
        let mechanism = read(subject);
        let nominal = mechanism.dimensions();
        let assembly = mechanism
            .assemble(&nominal)
            .expect("the compiler has closed it");
        let mut random = Random::new(11);
        for (number, heading) in mechanism.headings().iter().enumerate() {
            if !subject.is_swept[number] {
                continue;
            }
            let name = format!("{}, {}", subject.name, heading.function);
            // Not a multiple of a block, in several threads, and one argument that stands still.
            let rows: Vec<Vec<f64>> = (0..1100)
                .map(|_| arguments(&mechanism, number, &mut random))
                .collect();
            let columns: Vec<Vec<f64>> = (0..heading.arguments.len())
                .map(|k| rows.iter().map(|row| row[k]).collect())
                .collect();
            let mut slices: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
            if let [_, .., last] = &mut slices[..] {
                *last = &last[..1];
            }
            let Some(macros) = (subject.swept)(&nominal, number, &slices) else {
                assert!(heading.arguments.is_empty(), "{name}");
                continue;
            };
            let found = assembly.sweep(number, &slices);
            count += compare_rows(&name, &macros, &found, 0.0);
            let mut parallel = found.clone();
            assembly.sweep_parallel_into(number, &slices, &mut parallel);
            count += compare_rows(&name, &macros, &parallel, 0.0);

            let sets: Vec<Vec<f64>> = (0..100)
                .map(|_| {
                    nominal
                        .iter()
                        .map(|x| x * random.between(0.97, 1.03))
                        .collect()
                })
                .collect();
            let slices: Vec<&[f64]> = columns.iter().map(|column| &column[..sets.len()]).collect();
            let Some(macros) = (subject.swept_sets)(&nominal, number, &sets, &slices) else {
                continue;
            };
            let dimensions: Vec<Vec<f64>> = (0..nominal.len())
                .map(|k| sets.iter().map(|set| set[k]).collect())
                .collect();
            let dimensions: Vec<&[f64]> = dimensions.iter().map(Vec::as_slice).collect();
            let is_followed = !mechanism.compiled().functions[number].states.is_empty();
            let near = if is_followed { 1e-9 } else { 0.0 };
            let found = assembly.sweep_sets(number, &dimensions, &slices);
            count += compare_rows(&format!("{name} of sets"), &macros, &found, near);
        }
    }
    println!("{count} numbers");
    assert!(count > 300_000, "{count}");
}

#[test]
fn continued_assemblies_are_those_of_the_macro() {
    let (mut followed, mut refused) = (0, 0);
    for subject in &all() {
        let mechanism = read(subject);
        let nominal = mechanism.dimensions();
        let from = mechanism
            .assemble(&nominal)
            .expect("the compiler has closed it");
        let mut random = Random::new(5);
        for part in [0.01, 0.1, 0.5] {
            let to: Vec<f64> = nominal
                .iter()
                .map(|x| x * random.between(1.0 - part, 1.0 + part))
                .collect();
            let macros = (subject.assembled_from)(&nominal, &to);
            let found = mechanism
                .assemble_from(&to, &from)
                .map_err(|error| error.to_string());
            let name = subject.name;
            match (macros, found) {
                (Ok(macros), Ok(found)) => {
                    for number in 0..mechanism.headings().len() {
                        let x = arguments(&mechanism, number, &mut random);
                        let [a, b] = [macros(number, &x), found.call(number, &x)];
                        let bits = |all: &[f64]| -> Vec<u64> {
                            let quiet = all.iter().map(|x| if x.is_nan() { f64::NAN } else { *x });
                            quiet.map(f64::to_bits).collect()
                        };
                        assert_eq!(bits(&a), bits(&b), "{name} {part} {number}");
                    }
                    followed += 1;
                }
                (macros, found) => {
                    assert_eq!(macros.err(), found.err(), "{name} {part}");
                    refused += 1;
                }
            }
        }
    }
    println!("{followed} followed, {refused} refused");
    assert!(followed > 40 && refused > 2, "{followed} {refused}");
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
