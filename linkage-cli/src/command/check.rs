//! `linkage check`: all messages, then what there is to know of a mechanism.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use linkage_compiler::check_all;
use linkage_runtime::Input;

use super::assemblies::{not_listed, placed, shown};
use super::is_coloured;
use super::output::print;
use crate::failure::Failure;
use crate::look_alike::look_alikes;
use crate::mechanism::Mechanism;
use crate::messages::rendered;
use crate::source::Source;

/// Checks files; mistakes go to the standard error, what is known of mechanisms without one to the standard output.
pub(super) fn run(files: &[PathBuf]) -> Result<(), Failure> {
    let mut sound = true;
    for file in files {
        match one(file) {
            Ok(own) => sound &= own,
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

fn one(file: &Path) -> Result<bool, Failure> {
    let source = Source::read(file)?;
    let mut sound = true;
    for found in source.calls() {
        eprint!("{}", look_alikes(&source, found, is_coloured()));
        for checked in check_all(found.tokens.clone()) {
            eprint!("{}", rendered(&source, found, &checked, is_coloured()));
            match Mechanism::new(&checked) {
                Some(mechanism) => print(&known(&mechanism))?,
                None => sound = false,
            }
        }
    }
    Ok(sound)
}

/// Structure, assemblies, ranges, operation counts.
fn known(mechanism: &Mechanism) -> String {
    let mut text = format!("{}: {}", mechanism.name, mechanism.structure);
    for input in mechanism.inputs {
        let _ = writeln!(text, "{}", range(input));
    }
    let assemblies = match mechanism.assemblies(&mechanism.dimensions(), &mechanism.reference()) {
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
fn range(input: &Input) -> String {
    let reference = placed(input, input.reference);
    match input.range {
        Some((low, high)) => {
            let [low, high] = [low, high].map(|x| shown(input, x));
            format!("input {reference}, in {low} .. {high}")
        }
        None => format!("input {reference}, without a range"),
    }
}
