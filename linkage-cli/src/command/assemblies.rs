//! `linkage assemblies`, `linkage circuits`: the ways in which the links can be put together.

mod numbers;

use std::fmt::Write;

use clap::Args;
use linkage_compiler::shortened;
use linkage_runtime::Input;

use super::choose::Chosen;
use super::output::print;
use super::values::{Dimensions, number, parts};
use crate::failure::{Failure, known_names};
use crate::mechanism::Mechanism;
use crate::normal::normal;
use numbers::numbers;

/// Options of `linkage circuits`.
#[derive(Debug, Args)]
pub(super) struct Options {
    #[command(flatten)]
    chosen: Chosen,
    #[command(flatten)]
    dimensions: Dimensions,
}

/// Options of `linkage assemblies`.
#[derive(Debug, Args)]
pub(super) struct AtInputs {
    #[command(flatten)]
    options: Options,
    /// Where the input is, as `phi=45deg`; at its reference by default
    #[arg(long = "at", value_name = "NAME=VALUE", value_parser = normal)]
    at: Vec<String>,
}

/// Lists the assemblies of each mechanism.
pub(super) fn run(options: &AtInputs) -> Result<(), Failure> {
    let AtInputs { options, at } = options;
    for mechanism in options.chosen.all()? {
        let dimensions = options.dimensions.of(&mechanism)?;
        let at = inputs(&mechanism, at)?;
        let all = mechanism.assemblies(&dimensions, &at)?;
        let pairs = mechanism.inputs.iter().zip(&at);
        let places: Vec<String> = pairs.map(|(input, &x)| placed(input, x)).collect();
        let places = match places.is_empty() {
            true => String::new(),
            false => format!(" at {}", places.join(", ")),
        };
        let mut text = match all.len() {
            0 => format!("{}{places}: no assembly\n", mechanism.name),
            1 => format!("{}{places}: 1 assembly\n", mechanism.name),
            count => format!("{}{places}: {count} assemblies\n", mechanism.name),
        };
        for (index, assembly) in all.iter().enumerate() {
            let modes: String = assembly.modes().iter().map(ToString::to_string).collect();
            let modes = match modes.is_empty() {
                true => String::new(),
                false => format!("modes {modes}: "),
            };
            let unknowns = assembly.unknowns(&at).into_iter();
            let unknowns: Vec<String> = unknowns.map(|own| own.to_string()).collect();
            let _ = writeln!(text, "{}  {modes}{}", index + 1, unknowns.join(", "));
        }
        if let Some(left_out) = not_listed(&mechanism) {
            let _ = writeln!(text, "{left_out}");
        }
        print(&text)?;
    }
    Ok(())
}

/// Which groups may have other assemblies than those that are found, in words.
pub(super) fn not_listed(mechanism: &Mechanism) -> Option<String> {
    let followed = mechanism.followed();
    let numbers: Vec<String> = followed.map(|group| (group + 1).to_string()).collect();
    let groups = match &numbers[..] {
        [] => return None,
        [one] => format!("group {one} is"),
        several => format!("groups {} are", several.join(", ")),
    };
    Some(format!(
        "{groups} followed from the estimates: only that assembly is found, others of the same loops are not listed"
    ))
}

/// Prints the circuits of each mechanism.
pub(super) fn circuits(options: &Options) -> Result<(), Failure> {
    let mut without = Vec::new();
    let mut some = false;
    for mechanism in options.chosen.all()? {
        let dimensions = options.dimensions.of(&mechanism)?;
        let name = mechanism.name;
        match mechanism.circuits(&dimensions) {
            Some(found) => {
                let found = found?;
                let numbers = numbers(&mechanism, &dimensions, &found);
                print(&format!("{name}\n{}", found.numbered(&numbers)))?;
                some = true;
            }
            None => without.push(format!(
                "{name} has no circuits: they are for mechanisms with loops and one input"
            )),
        }
    }
    match (some, without.first()) {
        (false, Some(text)) => Err(Failure::Told(text.clone())),
        _ => {
            without.iter().for_each(|text| eprintln!("note: {text}"));
            Ok(())
        }
    }
}

/// All inputs: at their references, unless `given` says another value.
fn inputs(mechanism: &Mechanism, given: &[String]) -> Result<Vec<f64>, Failure> {
    let mut at = mechanism.reference();
    for given in given {
        let (name, text) = parts("--at", given)?;
        let Some(index) = mechanism.inputs.iter().position(|own| own.name == name) else {
            return Err(Failure::Told(format!(
                "{} has no input `{}`; it has {}",
                mechanism.name,
                shortened(name),
                known_names(name, mechanism.inputs.iter().map(|own| own.name))
            )));
        };
        at[index] = number(mechanism, name, text, mechanism.inputs[index].unit)?;
    }
    Ok(at)
}

/// `phi = 30 deg`
pub(super) fn placed(input: &Input, x: f64) -> String {
    format!("{} = {}", input.name, shown(input, x))
}

/// `30 deg`, without the last bits of the conversion.
pub(super) fn shown(input: &Input, x: f64) -> String {
    match input.unit {
        "rad" => format!("{} deg", (x.to_degrees() * 1e9).round() / 1e9 + 0.0),
        unit => format!("{} {unit}", x + 0.0),
    }
}
