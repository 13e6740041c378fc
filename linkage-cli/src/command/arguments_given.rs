//! Arguments that the command line gives to the functions of a file, which may have several
//! mechanisms.

use std::collections::BTreeSet;

use linkage_compiler::shortened;
use linkage_engine::Mechanism;

use super::values::parts;
use crate::failure::{Failure, known_names, listed};

/// Fails at the first argument that no function of these mechanisms takes.
pub(super) fn refuse_unknown(all: &[Mechanism], given: &[String]) -> Result<(), Failure> {
    for given in given {
        let (name, _) = parts("--at", given)?;
        if !all.iter().any(|mechanism| takes(mechanism, name)) {
            let names: BTreeSet<&str> = all.iter().flat_map(arguments).collect();
            return Err(Failure::Told(format!(
                "no function of {} takes `{}`; they take {}{}",
                titles(all),
                shortened(name),
                known_names(name, names),
                help_with_rate(name)
            )));
        }
    }
    Ok(())
}

/// Returns true if a function of the mechanism takes an argument of this name.
pub(super) fn takes(mechanism: &Mechanism, name: &str) -> bool {
    arguments(mechanism).any(|argument| argument == name)
}

/// Returns all inputs: those among the arguments of a function, the others at their references.
pub(super) fn inputs_given(mechanism: &Mechanism, function: usize, arguments: &[f64]) -> Vec<f64> {
    let mut inputs = mechanism.reference();
    let indices = &mechanism.compiled().functions[function].arguments;
    for (&index, &x) in indices.iter().zip(arguments) {
        if let Some(input) = inputs.get_mut(index) {
            *input = x;
        }
    }
    inputs
}

/// Selects the options for arguments with one of these names.
pub(super) fn among(names: &[&str], given: &[String]) -> Vec<String> {
    let is_known = |given: &&String| {
        let name = given.split_once('=').map_or("", |pair| pair.0.trim());
        names.contains(&name)
    };
    given.iter().filter(is_known).cloned().collect()
}

/// Returns the help for the usual name of a speed or an acceleration that no function takes.
pub(super) fn help_with_rate(name: &str) -> &'static str {
    match name {
        "omega" | "speed" | "epsilon" | "alpha" | "acceleration" => {
            "\nhelp: speed and acceleration of an input are declared with it, `input phi = ... at omega, epsilon`, and listed by functions"
        }
        _ => "",
    }
}

/// `Press`, or a list of several names in back-ticks.
pub(super) fn titles(all: &[Mechanism]) -> String {
    match all {
        [only] => only.name().to_owned(),
        several => listed(several.iter().map(|mechanism| mechanism.name())),
    }
}

/// The arguments of all functions.
fn arguments(mechanism: &Mechanism) -> impl Iterator<Item = &'static str> {
    let headings = mechanism.headings().iter();
    headings.flat_map(|heading| heading.arguments.iter().copied())
}
