//! The function of a command line that is an equation of motion.

use linkage_engine::{Driven, Mechanism, NotDriven};

use super::super::choose::Chosen;
use super::super::sweep::arguments;
use crate::failure::{Failure, listed};

/// Returns the mechanism and its function of this name, else the only mechanism that has a function
/// with the accelerations of all inputs, and the first such function.
pub(super) fn chosen(
    chosen: &Chosen,
    function: Option<&str>,
) -> Result<(Mechanism, usize), Failure> {
    if let Some(name) = function {
        return chosen.with_function(name);
    }
    let all = chosen.all()?;
    let titles: Vec<&'static str> = all.iter().map(Mechanism::name).collect();
    let mut found: Vec<_> = all
        .into_iter()
        .filter_map(|mechanism| {
            let function = mechanism.driven_function()?;
            Some((mechanism, function))
        })
        .collect();
    match &found[..] {
        [] => Err(Failure::Told(format!(
            "no function of {} has the accelerations of all inputs\n{}",
            listed(titles),
            NotDriven::help("phi", "omega")
        ))),
        [_] => Ok(found.swap_remove(0)),
        several => Err(Failure::Told(format!(
            "{} have accelerations of all inputs: choose one by `--mechanism NAME`",
            listed(several.iter().map(|(mechanism, _)| mechanism.name()))
        ))),
    }
}

/// Resolves the arguments at the start. Speeds and accelerations that are not given are zero.
pub(super) fn driven<'m>(
    mechanism: &'m Mechanism,
    function: usize,
    given: &[String],
) -> Result<Driven<'m>, Failure> {
    let start = arguments(mechanism, function, given)?.or(0.0);
    let driven = mechanism.driven(function, &start);
    driven.map_err(|error| Failure::Told(error.to_string()))
}

/// An input that moves, or its speed.
#[derive(Clone, Copy)]
pub(super) enum Moving {
    Input(usize),
    Speed(usize),
}

/// Returns the input or the speed of this name.
pub(super) fn moving(driven: &Driven<'_>, name: &str) -> Option<Moving> {
    let names = driven.mechanism().headings()[driven.function()].arguments;
    let index = names.iter().position(|argument| *argument == name)?;
    let mut inputs = driven.inputs().iter().enumerate();
    inputs.find_map(|(input, indices)| match index {
        _ if index == indices.value => Some(Moving::Input(input)),
        _ if index == indices.speed => Some(Moving::Speed(input)),
        _ => None,
    })
}
