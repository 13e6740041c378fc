//! The same four-bar in several crates: agreement, hard positions, times, and runs whose instructions are counted.

use std::f64::consts::{PI, TAU};
use std::process::ExitCode;
use std::time::Duration;

mod evaluators;
mod hard;
mod timing;

use evaluators::{Dimensions, all};
use timing::interleave;

/// The crank-rocker of the comparison.
const DIMENSIONS: Dimensions = [50.0, 120.0, 100.0, 140.0, 0.0, 70.0, 25.0 * PI / 180.0];

/// Angles of the crank in an order that no processor predicts.
fn angles() -> Vec<f64> {
    (0..1000)
        .map(|i| TAU * f64::from(i * 617 % 1000) / 1000.0 + 0.001)
        .collect()
}

/// Panics unless all crates have the values of the first one, within a relative error.
fn agree(dimensions: Dimensions, angles: &[f64], tolerance: f64) {
    let crates = all(dimensions);
    let reference = &crates[0];
    for &phi in angles {
        for with in &crates[1..] {
            for ((name, function), (_, expected)) in
                with.functions().into_iter().zip(reference.functions())
            {
                let (Some(function), Some(expected)) = (function, expected) else {
                    continue;
                };
                let values = (function.values)(phi);
                let expected = (expected.values)(phi);
                for (value, expected) in values.iter().zip(&expected) {
                    let error = (value - expected).abs() / (1.0 + expected.abs());
                    assert!(
                        error < tolerance,
                        "{} {name} at {phi}: {value}, expected {expected}",
                        with.name
                    );
                }
            }
        }
    }
    println!("all values of {dimensions:?} agree within {tolerance:e}");
}

/// Prints medians and quartiles of nanoseconds, and of ratios to the first crate.
fn times() {
    let (crates, angles) = (all(DIMENSIONS), angles());
    for index in 0..4 {
        let (mut names, mut candidates) = (Vec::new(), Vec::new());
        for with in &crates {
            if let (name, Some(function)) = &with.functions()[index] {
                names.push(format!("{} {name}", with.name));
                candidates.push(*function);
            }
        }
        let times = interleave(&candidates, &angles, Duration::from_secs(5));
        for (name, own) in names.iter().zip(&times) {
            let [low, median, high] = own.nanoseconds();
            let [least, ratio, most] = own.ratios(&times[0]);
            println!(
                "{name:<26} {median:.1} ns ({low:.1}-{high:.1}), ratio {ratio:.2} ({least:.2}-{most:.2})"
            );
        }
    }
}

/// Runs one function `passes` times 1000 times: the difference of two counts of instructions is that of its calls.
fn count(with: &str, name: &str, passes: usize) -> Option<()> {
    let crates = all(DIMENSIONS);
    let with = crates.iter().find(|own| own.name == with)?;
    let (_, function) = with.functions().into_iter().find(|own| own.0 == name)?;
    let angles = angles();
    for _ in 0..passes {
        (function?.pass)(&angles);
    }
    Some(())
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match words[..] {
        [] => {
            agree(DIMENSIONS, &angles(), 1e-10);
            agree(hard::UPRIGHT, &hard::upright_angles(), 1e-12);
            agree(hard::ROCKING, &[hard::dead_point() - 1e-6], 1e-9);
            hard::print();
            times();
        }
        ["hard"] => hard::print(),
        ["count", with, name, passes] => {
            if passes
                .parse()
                .ok()
                .and_then(|passes| count(with, name, passes))
                .is_none()
            {
                eprintln!("no function `{name}` of `{with}`");
                return ExitCode::FAILURE;
            }
        }
        _ => {
            eprintln!("usage: compare [hard | count CRATE FUNCTION PASSES]");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}
