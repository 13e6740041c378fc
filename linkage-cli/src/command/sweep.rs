//! Functions over a range of one input.

use linkage_compiler::shortened;
use linkage_engine::Mechanism;
use linkage_runtime::Input;

use super::arguments_given::help_with_rate;
use super::memory::Held;
use super::values::{number, parts};
use crate::failure::{Failure, known_names};

/// The arguments of a function, as far as they are known.
pub(super) struct Given {
    names: &'static [&'static str],
    values: Vec<Option<f64>>,
}

impl Given {
    /// All arguments, with a value for those that are not given.
    pub(super) fn or(self, value: f64) -> Vec<f64> {
        let values = self.values.into_iter();
        values.map(|given| given.unwrap_or(value)).collect()
    }

    /// All arguments, or which one is missing.
    pub(super) fn complete(self) -> Result<Vec<f64>, String> {
        let pairs = self.names.iter().zip(self.values);
        pairs
            .map(|(name, value)| {
                value.ok_or_else(|| {
                    format!("it takes `{name}`, too, which is given by `--at {name}=VALUE`")
                })
            })
            .collect()
    }
}

/// The arguments of a function: inputs at their references and loads as declared, unless `given`
/// has another value. Speeds and accelerations must be given.
pub(super) fn arguments(
    mechanism: &Mechanism,
    function: usize,
    given: &[String],
) -> Result<Given, Failure> {
    let heading = mechanism.headings()[function];
    let places = &mechanism.compiled().functions[function].arguments;
    let mut values: Vec<Option<f64>> = places
        .iter()
        .map(|&argument_index| mechanism.default_argument(argument_index))
        .collect();
    for given in given {
        let (name, text) = parts("--at", given)?;
        let Some(index) = heading
            .arguments
            .iter()
            .position(|argument| *argument == name)
        else {
            return Err(Failure::Told(format!(
                "`{}` does not take `{}`; it takes {}{}",
                heading.function,
                shortened(name),
                known_names(name, heading.arguments.iter().copied()),
                help_with_rate(name)
            )));
        };
        let (_, unit) = mechanism.argument(places[index]);
        values[index] = Some(number(mechanism, name, text, unit)?);
    }
    Ok(Given {
        names: heading.arguments,
        values,
    })
}

/// All arguments of a function.
pub(super) fn all_arguments(
    mechanism: &Mechanism,
    function: usize,
    given: &[String],
) -> Result<Vec<f64>, Failure> {
    let all = arguments(mechanism, function, given)?.complete();
    let name = mechanism.headings()[function].function;
    all.map_err(|why| Failure::Told(format!("`{name}` cannot be evaluated: {why}")))
}

/// The input that runs: the one of this name, else the first one of the function. `None` for a
/// function without inputs.
pub(super) fn running(
    mechanism: &Mechanism,
    function: usize,
    name: Option<&str>,
) -> Result<Option<(usize, &'static Input)>, Failure> {
    let places = &mechanism.compiled().functions[function].arguments;
    let mut inputs = places
        .iter()
        .enumerate()
        .filter_map(|(index, &argument_index)| {
            let input: Option<&'static Input> = mechanism.inputs().get(argument_index);
            Some((index, input?))
        });
    let Some(name) = name else {
        return Ok(inputs.next());
    };
    let found = inputs.clone().find(|(_, input)| input.name == name);
    match found {
        Some(found) => Ok(Some(found)),
        None => Err(Failure::Told(format!(
            "`{}` has no input `{}`; it has {}",
            mechanism.headings()[function].function,
            shortened(name),
            known_names(name, inputs.map(|(_, input)| input.name))
        ))),
    }
}

/// Returns true if the given arguments stay constant.
pub(super) fn still(running: &Input, given: &[String]) -> Result<(), Failure> {
    for given in given {
        let (name, _) = parts("--at", given)?;
        if name == running.name {
            return Err(runs(name));
        }
    }
    Ok(())
}

/// Returns the message for a given value of the input that runs.
pub(super) fn runs(name: &str) -> Failure {
    Failure::Told(format!(
        "`{name}` runs from one position to the next and cannot be given by `--at`, too"
    ))
}

/// Evenly spaced values of an input; a single number that is none if nothing runs.
#[derive(Clone, Copy)]
pub(super) struct Positions {
    input: Option<Input>,
    pub(super) count: usize,
}

impl Positions {
    /// The row of a function without inputs.
    pub(super) fn none() -> Self {
        Self {
            input: None,
            count: 1,
        }
    }

    /// One after the other.
    pub(super) fn iter(self) -> impl Iterator<Item = f64> {
        let Self { input, count } = self;
        (0..count).map(move |index| input.map_or(f64::NAN, |input| input.position(index, count)))
    }

    /// Returns all positions, unless they and their results do not fit into the memory.
    pub(super) fn held(self, columns: usize, bytes: usize) -> Result<Vec<f64>, Failure> {
        let held = Held {
            rows: self.count,
            columns: columns + 1,
            bytes,
        };
        held.fits()?;
        Ok(self.iter().collect())
    }
}

/// Evenly spaced values over the input's range, or over another one.
pub(super) fn positions(
    mechanism: &Mechanism,
    input: &Input,
    [from, to]: [Option<&str>; 2],
    steps: u32,
) -> Result<Positions, Failure> {
    let (mut low, mut high) = input.ends();
    if let Some(from) = from {
        low = number(mechanism, input.name, from, input.unit)?;
    }
    if let Some(to) = to {
        high = number(mechanism, input.name, to, input.unit)?;
    }
    let over = Input {
        range: Some((low, high)),
        ..*input
    };
    Ok(Positions {
        input: Some(over),
        count: steps as usize,
    })
}
