//! Prints values of the macro's code for other languages to compare with: a line for each call of
//! a function, for each sweep, and for each sweep over sets.
//!
//! Its parts are separated by tabs: `call`, `sweep`, `sets` or `near`, the file, the number of the
//! mechanism in it, the number of the function, then rows of numbers. A row is a list with commas,
//! rows are separated by semicolons, and numbers are the digits of their bits. Rows of `call` and
//! `sweep` are arguments, then results; those of the others begin with the dimensions. Results of
//! `near` are those of coupled groups that are followed to other dimensions, on another way.

use std::fmt::Write;
use std::path::Path;

use linkage_command::{Subject, all, arguments, read};
use linkage_compiler::check_all;
use linkage_engine::Source;
use linkage_random::Random;

/// Calls of each function.
const CALLS: usize = 8;

/// Positions of a sweep: not a multiple of a block.
const POSITIONS: usize = 75;

/// Mechanisms of a sweep over sets.
const SETS: usize = 20;

fn main() {
    let mut text = String::new();
    for subject in &all() {
        print(subject, &mut text);
    }
    print!("{text}");
}

/// Prints the values of a mechanism.
fn print(subject: &Subject, text: &mut String) {
    let mechanism = read(subject);
    let source = Source::read(Path::new(subject.path)).expect("it can be read");
    let until = source.calls()[..=subject.number].iter();
    let counts = until.map(|call| check_all(call.tokens.clone()).len());
    let index = counts.sum::<usize>() - 1;
    let nominal = mechanism.dimensions();
    let call = (subject.assembled)(&nominal).expect("the compiler has closed it");
    let mut random = Random::new(23);
    for (function, compiled) in mechanism.compiled().functions.iter().enumerate() {
        let start = format!("{}\t{index}\t{function}", subject.path);
        for _ in 0..CALLS {
            let x = arguments(&mechanism, function, &mut random);
            let results = [call(function, &x)];
            let _ = writeln!(text, "call\t{start}\t{}\t{}", rows(&[x]), rows(&results));
        }
        let x: Vec<Vec<f64>> = (0..POSITIONS)
            .map(|_| arguments(&mechanism, function, &mut random))
            .collect();
        let columns = columns(&x, compiled.arguments.len());
        let slices: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
        if let Some(results) = (subject.swept)(&nominal, function, &slices) {
            let _ = writeln!(text, "sweep\t{start}\t{}\t{}", rows(&x), rows(&results));
        }
        let slices: Vec<&[f64]> = columns.iter().map(|column| &column[..SETS]).collect();
        let mut off = || -> Vec<f64> {
            let factors = nominal.iter();
            factors.map(|x| x * random.between(0.97, 1.03)).collect()
        };
        let sets: Vec<Vec<f64>> = (0..SETS).map(|_| off()).collect();
        if let Some(results) = (subject.swept_sets)(&nominal, function, &sets, &slices) {
            let kind = if compiled.states.is_empty() {
                "sets"
            } else {
                "near"
            };
            let [sets, x, results] = [&sets[..], &x[..SETS], &results].map(rows);
            let _ = writeln!(text, "{kind}\t{start}\t{sets}\t{x}\t{results}");
        }
    }
}

/// The columns of rows.
fn columns(rows: &[Vec<f64>], count: usize) -> Vec<Vec<f64>> {
    let column = |k: usize| rows.iter().map(|row| row[k]).collect();
    (0..count).map(column).collect()
}

/// Rows as digits of the bits of their numbers.
fn rows(rows: &[Vec<f64>]) -> String {
    let row = |row: &Vec<f64>| {
        let numbers = row.iter().map(|x| format!("{:x}", x.to_bits()));
        numbers.collect::<Vec<_>>().join(",")
    };
    rows.iter().map(row).collect::<Vec<_>>().join(";")
}
