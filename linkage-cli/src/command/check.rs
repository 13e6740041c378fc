//! `linkage check`: all messages, then the known facts about a mechanism.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use annotate_snippets::Level;
use linkage_compiler::check_all;
use linkage_engine::{Mechanism, Source, rendered};
use linkage_runtime::Input;

use super::assemblies::{not_listed, placed, shown};
use super::output::print;
use super::range;
use super::terminal::is_coloured;
use super::unbounded;
use super::values::Dimensions;
use crate::failure::Failure;
use crate::look_alike::look_alikes;

/// Checks files. Mistakes go to the standard error, facts about mechanisms without one to the
/// standard output.
pub(super) fn run(files: &[PathBuf], given: &Dimensions) -> Result<(), Failure> {
    let mut sound = true;
    for file in files {
        match one(file, given) {
            Ok(is_sound) => sound &= is_sound,
            Err(failure) => {
                eprintln!("{failure}");
                sound = false;
            }
        }
    }
    match sound {
        true => Ok(()),
        false => Err(Failure::Silent),
    }
}

fn one(file: &Path, given: &Dimensions) -> Result<bool, Failure> {
    let source = Source::read(file)?;
    let mut sound = true;
    let mut all = Vec::new();
    for found in source.calls() {
        eprint!("{}", look_alikes(&source, found, is_coloured()));
        for checked in check_all(found.tokens.clone()) {
            eprint!("{}", rendered(&source, found, &checked, is_coloured()));
            match Mechanism::new(&checked) {
                Some(mechanism) => all.push(mechanism),
                None => sound = false,
            }
        }
    }
    if sound {
        given.known_to_any(&all)?;
    }
    for mechanism in &all {
        let dimensions_known = given.known_to(mechanism);
        range::warn_of_negative_lengths(&dimensions_known, mechanism)?;
        let dimensions = dimensions_known.resolve(mechanism)?;
        print(&known(mechanism, &dimensions))?;
        if dimensions_known.are_given() {
            sound &= works(mechanism, &dimensions, &dimensions_known)?;
        }
        warn_of_singular_positions(mechanism, &dimensions)?;
    }
    Ok(sound)
}

/// Returns true if a mechanism closes with other dimensions and runs through its range.
fn works(mechanism: &Mechanism, dimensions: &[f64], given: &Dimensions) -> Result<bool, Failure> {
    let report = mechanism.assemble(dimensions)?.check_range();
    // Without a range, the compiler warns.
    let is_declared = report.input.is_some_and(|input| input.range.is_some());
    let level = match is_declared {
        true => Level::ERROR,
        false => Level::WARNING,
    };
    eprint!("{}", range::rendered(&level, given, &report));
    Ok(report.is_sound() || !is_declared)
}

/// Warns of positions at which forces grow without bound.
fn warn_of_singular_positions(mechanism: &Mechanism, dimensions: &[f64]) -> Result<(), Failure> {
    if !unbounded::has_forces(mechanism) {
        return Ok(());
    }
    // Without an assembly there is a message already.
    let Ok(assembly) = mechanism.assemble(dimensions) else {
        return Ok(());
    };
    let Some(input) = mechanism.inputs().first() else {
        return Ok(());
    };
    for message in unbounded::singular_positions(&assembly, mechanism)? {
        eprintln!(
            "warning: {message}\nhelp: end the range of `{}` before it, or write the estimates of the assembly that is meant\n",
            input.name
        );
    }
    Ok(())
}

/// Structure, assemblies, ranges, operation counts.
fn known(mechanism: &Mechanism, dimensions: &[f64]) -> String {
    let mut text = format!("{}: {}", mechanism.name(), mechanism.structure());
    for input in mechanism.inputs() {
        let _ = writeln!(text, "{}", declared(input));
    }
    let assemblies = match mechanism.assemblies(dimensions, &mechanism.reference()) {
        Ok(all) => match not_listed(mechanism) {
            None => format!("assemblies at the reference: {}", all.len()),
            Some(left_out) => format!(
                "assemblies at the reference: {} found; {left_out}",
                all.len()
            ),
        },
        Err(error) => format!("assemblies at the reference: {error}"),
    };
    let _ = writeln!(text, "{assemblies}\n");
    text
}

/// `input phi = 30 deg, in 0 deg .. 360 deg`
fn declared(input: &Input) -> String {
    let reference = placed(input, input.reference);
    match input.range {
        Some((low, high)) => {
            let [low, high] = [low, high].map(|x| shown(input, x));
            format!("input {reference}, in {low} .. {high}")
        }
        None => format!("input {reference}, without a range"),
    }
}
