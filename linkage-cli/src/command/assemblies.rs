//! `linkage assemblies`, `linkage circuits`: the ways in which the links can be put together.

mod numbers;

use std::collections::BTreeSet;
use std::fmt::Write;

use clap::Args;
use linkage_compiler::{length_as_written, shortened};
use linkage_engine::{Assembly, Mechanism};
use linkage_runtime::Input;

use super::arguments_given::titles;
use super::choose::Chosen;
use super::output::print;
use super::range::warn_of_negative_lengths;
use super::values::{Dimensions, number, parts};
use crate::failure::{Failure, known_names};
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
    let all = options.chosen.all_in_any_range()?;
    options.dimensions.known_to_any(&all)?;
    refuse_unknown_inputs(&all, at)?;
    for mechanism in all {
        let dimensions = options.dimensions.known_to(&mechanism);
        warn_of_negative_lengths(&dimensions, &mechanism)?;
        let dimensions = dimensions.resolve(&mechanism)?;
        let at = inputs(&mechanism, at)?;
        let all = mechanism.assemblies(&dimensions, &at)?;
        let pairs = mechanism.inputs().iter().zip(&at);
        let places: Vec<String> = pairs.map(|(input, &x)| placed(input, x)).collect();
        let places = match places.is_empty() {
            true => String::new(),
            false => format!(" at {}", places.join(", ")),
        };
        let mut text = match all.len() {
            0 => format!("{}{places}: no assembly\n", mechanism.name()),
            1 => format!("{}{places}: 1 assembly\n", mechanism.name()),
            count => format!("{}{places}: {count} assemblies\n", mechanism.name()),
        };
        for (index, assembly) in all.iter().enumerate() {
            let modes: String = assembly.modes().iter().map(ToString::to_string).collect();
            let modes = match modes.is_empty() {
                true => String::new(),
                false => format!("modes {modes}: "),
            };
            let unknowns = assembly.unknowns(&at).into_iter();
            let unknowns: Vec<String> = unknowns.map(|unknown| unknown.to_string()).collect();
            let _ = writeln!(text, "{}  {modes}{}", index + 1, unknowns.join(", "));
        }
        for meeting in meeting(&mechanism, &all, &at) {
            let _ = writeln!(text, "{meeting}");
        }
        if let Some(left_out) = not_listed(&mechanism) {
            let _ = writeln!(text, "{left_out}");
        }
        print(&text)?;
    }
    Ok(())
}

/// Two assemblies are one here if their unknowns differ by less, compared with the largest: at a
/// dead point a place is known to half of its digits.
const SAME: f64 = 1e-6;

/// At this distance, in radians or as a part of the range, two assemblies that meet in a change
/// point exist on both sides.
const ASIDE: f64 = 1e-3;

/// A line for each pair of assemblies that are one at these inputs.
fn meeting(mechanism: &Mechanism, all: &[Assembly], at: &[f64]) -> Vec<String> {
    let numbers: Vec<Vec<f64>> = all.iter().map(|assembly| assembly.places(at)).collect();
    let same = |a: &[f64], b: &[f64]| {
        let size = a
            .iter()
            .chain(b)
            .fold(0.0, |size: f64, x| size.max(x.abs()));
        a.iter().zip(b).all(|(x, y)| (x - y).abs() <= SAME * size)
    };
    let goes_on = |assembly: &Assembly| match mechanism.inputs() {
        [input] => {
            let step = match input.range {
                Some((low, high)) if input.unit != "rad" => ASIDE * (high - low),
                _ => ASIDE,
            };
            let closes = |x: f64| {
                assembly
                    .places(&[x])
                    .iter()
                    .all(|position| position.is_finite())
            };
            Some(closes(at[0] - step) && closes(at[0] + step))
        }
        _ => None,
    };
    let mut lines = Vec::new();
    for (one, first) in numbers.iter().enumerate() {
        for (other, second) in numbers.iter().enumerate().skip(one + 1) {
            if !same(first, second) {
                continue;
            }
            let [a, b] = [one + 1, other + 1];
            lines.push(match goes_on(&all[one]) {
                Some(true) => format!(
                    "{a} and {b} are equal: they meet here in a change point, from which the mechanism can go on in either"
                ),
                Some(false) => {
                    format!("{a} and {b} are equal: they meet here in a dead point, where both end")
                }
                None => format!("{a} and {b} are equal: they meet here"),
            });
        }
    }
    lines
}

/// Returns the note about groups that may have other assemblies than those that are found.
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
    let all = options.chosen.all_in_any_range()?;
    options.dimensions.known_to_any(&all)?;
    for mechanism in all {
        let dimensions = options.dimensions.known_to(&mechanism);
        warn_of_negative_lengths(&dimensions, &mechanism)?;
        let dimensions = dimensions.resolve(&mechanism)?;
        let name = mechanism.name();
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

/// Fails at the first given value whose input none of the mechanisms has.
fn refuse_unknown_inputs(all: &[Mechanism], given: &[String]) -> Result<(), Failure> {
    let inputs = all.iter().flat_map(|mechanism| mechanism.inputs());
    let names: BTreeSet<&str> = inputs.map(|input| input.name).collect();
    for given in given {
        let (name, _) = parts("--at", given)?;
        if names.contains(name) {
            continue;
        }
        let unknown = shortened(name);
        let known = known_names(name, names);
        return Err(Failure::Told(match all {
            [only] => format!("{} has no input `{unknown}`; it has {known}", only.name()),
            several => format!(
                "none of {} has an input `{unknown}`; they have {known}",
                titles(several)
            ),
        }));
    }
    Ok(())
}

/// All inputs: at their references, except for those that have a given value.
fn inputs(mechanism: &Mechanism, given: &[String]) -> Result<Vec<f64>, Failure> {
    let mut at = mechanism.reference();
    for given in given {
        let (name, text) = parts("--at", given)?;
        let mut inputs = mechanism.inputs().iter();
        if let Some(index) = inputs.position(|input| input.name == name) {
            at[index] = number(mechanism, name, text, mechanism.inputs()[index].unit)?;
        }
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
        unit => {
            let (x, unit) = length_as_written(x + 0.0, unit);
            format!("{x} {unit}")
        }
    }
}
