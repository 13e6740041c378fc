//! The equation of motion of a mechanism, from a function that returns its accelerations.

use linkage_compiler::ir::Role;
use linkage_engine::{Assembly, Mechanism};

use super::super::choose::Chosen;
use super::super::sweep::arguments;
use crate::failure::{Failure, listed};

/// A function with the accelerations of all inputs without drives.
pub(super) struct Driven<'m> {
    pub(super) mechanism: &'m Mechanism,
    pub(super) function: usize,
    /// The arguments at the start.
    given: Vec<f64>,
    /// For each input the indices of its value, its speed and its acceleration among the arguments.
    inputs: Vec<Indices>,
    /// For each input the index of its acceleration among the columns.
    accelerations: Vec<usize>,
}

/// Indices among the arguments of a function.
#[derive(Clone, Copy)]
struct Indices {
    value: usize,
    speed: usize,
    acceleration: Option<usize>,
}

/// Returns the mechanism and its function of this name, else the only mechanism that has a function
/// with the accelerations of all inputs, and the first such function.
pub(super) fn chosen(
    chosen: &Chosen,
    function: Option<&str>,
) -> Result<(Mechanism, usize), Failure> {
    if let Some(name) = function {
        return chosen.with_function(name);
    }
    let moved = |mechanism: &Mechanism| {
        (0..mechanism.headings().len()).find(|&f| accelerations(mechanism, f).is_some())
    };
    let all = chosen.all()?;
    let titles: Vec<&'static str> = all.iter().map(Mechanism::name).collect();
    let mut found: Vec<_> = all
        .into_iter()
        .filter_map(|mechanism| moved(&mechanism).map(|function| (mechanism, function)))
        .collect();
    match &found[..] {
        [] => Err(Failure::Told(format!(
            "no function of {} has the accelerations of all inputs\n{}",
            listed(titles),
            advice("phi", "omega")
        ))),
        [_] => Ok(found.swap_remove(0)),
        several => Err(Failure::Told(format!(
            "{} have accelerations of all inputs: choose one by `--mechanism NAME`",
            listed(several.iter().map(|(mechanism, _)| mechanism.name()))
        ))),
    }
}

/// The columns of a function with the accelerations of all inputs, in the order of the inputs.
fn accelerations(mechanism: &Mechanism, function: usize) -> Option<Vec<usize>> {
    let fields = &mechanism.compiled().functions[function].fields;
    let mut first = 0;
    let mut columns = vec![None; mechanism.inputs().len()];
    for field in fields {
        if let Some(input) = field.driven_acceleration {
            columns[input].get_or_insert(first);
        }
        first += field.shape.width();
    }
    let columns: Option<Vec<usize>> = columns.into_iter().collect();
    columns.filter(|columns| !columns.is_empty())
}

/// The help for a function without accelerations.
fn advice(input: &str, speed: &str) -> String {
    format!(
        "help: declare bodies with masses and `input {input} = ... at {speed}`, and write a function such as \
         `fn motion({input}, {speed}) -> Motion {{ a: driven_acceleration({input}) }}`"
    )
}

impl<'m> Driven<'m> {
    /// Resolves the arguments that are given. Speeds and accelerations are zero without.
    pub(super) fn new(
        mechanism: &'m Mechanism,
        function: usize,
        given: &[String],
    ) -> Result<Self, Failure> {
        let name = mechanism.headings()[function].function;
        let unit = mechanism.compiled();
        let listed = &unit.functions[function].arguments;
        let inputs = mechanism.inputs();
        let at = |wanted: usize| listed.iter().position(|&argument| argument == wanted);
        let of_role = |role: Role| {
            let all = unit.arguments.iter();
            let index = all.clone().position(|argument| argument.role == role)?;
            Some((inputs.len() + index, unit.arguments[index].name.as_str()))
        };
        let mut all = Vec::new();
        for (index, input) in inputs.iter().enumerate() {
            let speed = of_role(Role::Speed(index));
            let speed_name = speed.map_or("omega", |(_, name)| name);
            let lacks = |what: String| {
                Failure::Told(format!(
                    "`{name}` {what}\n{}",
                    advice(input.name, speed_name)
                ))
            };
            let Some(value) = at(index) else {
                return Err(lacks(format!("does not take the input `{}`", input.name)));
            };
            let Some(speed) = speed.and_then(|(argument, _)| at(argument)) else {
                return Err(lacks(format!(
                    "does not take the speed of `{}`, so that it leaves out what speeds do",
                    input.name
                )));
            };
            let acceleration =
                of_role(Role::Acceleration(index)).and_then(|(argument, _)| at(argument));
            all.push(Indices {
                value,
                speed,
                acceleration,
            });
        }
        let Some(accelerations) = accelerations(mechanism, function) else {
            let [input, ..] = inputs else {
                return Err(Failure::Told(format!(
                    "{} has no input that could move",
                    mechanism.name()
                )));
            };
            let speed = of_role(Role::Speed(0)).map_or("omega", |(_, name)| name);
            return Err(Failure::Told(format!(
                "`{name}` does not have the accelerations of all inputs\n{}",
                advice(input.name, speed)
            )));
        };
        Ok(Self {
            mechanism,
            function,
            given: arguments(mechanism, function, given)?.or(0.0),
            inputs: all,
            accelerations,
        })
    }

    /// The number of inputs.
    pub(super) fn count(&self) -> usize {
        self.inputs.len()
    }

    /// Inputs and speeds at the start.
    pub(super) fn start<const N: usize>(&self) -> [[f64; N]; 2] {
        [
            std::array::from_fn(|k| self.given[self.inputs[k].value]),
            std::array::from_fn(|k| self.given[self.inputs[k].speed]),
        ]
    }

    /// The index of an input or of a speed, by the name of the argument.
    pub(super) fn moving(&self, name: &str) -> Option<Moving> {
        let names = self.mechanism.headings()[self.function].arguments;
        let index = names.iter().position(|argument| *argument == name)?;
        let mut inputs = self.inputs.iter().enumerate();
        inputs.find_map(|(input, indices)| match index {
            _ if index == indices.value => Some(Moving::Input(input)),
            _ if index == indices.speed => Some(Moving::Speed(input)),
            _ => None,
        })
    }

    /// Names and units of all inputs, then of all speeds.
    pub(super) fn titles(&self) -> Vec<(&str, &str)> {
        let arguments = &self.mechanism.compiled().functions[self.function].arguments;
        let values = self.inputs.iter().map(|indices| indices.value);
        let speeds = self.inputs.iter().map(|indices| indices.speed);
        let all = values.chain(speeds);
        all.map(|index| self.mechanism.argument(arguments[index]))
            .collect()
    }

    /// The accelerations of all inputs; NaN where the loops do not close, whether accelerations
    /// depend on them or not.
    pub(super) fn accelerations<const N: usize>(
        &self,
        assembly: &Assembly<'_>,
        inputs: [f64; N],
        speeds: [f64; N],
    ) -> [f64; N] {
        if assembly.gaps(&inputs).iter().any(|gap| *gap > 0.0) {
            return [f64::NAN; N];
        }
        let results = assembly.call(self.function, &self.arguments(inputs, speeds));
        std::array::from_fn(|input| results[self.accelerations[input]])
    }

    /// All results, with the accelerations of this state where the function takes them.
    pub(super) fn results<const N: usize>(
        &self,
        assembly: &Assembly<'_>,
        inputs: [f64; N],
        speeds: [f64; N],
    ) -> Vec<f64> {
        let mut arguments = self.arguments(inputs, speeds);
        let results = assembly.call(self.function, &arguments);
        let taken = self.inputs.iter().zip(&self.accelerations);
        let taken = taken.filter_map(|(indices, &column)| Some((indices.acceleration?, column)));
        let taken: Vec<(usize, usize)> = taken.collect();
        if taken.is_empty() {
            return results;
        }
        for (argument, column) in taken {
            arguments[argument] = results[column];
        }
        assembly.call(self.function, &arguments)
    }

    /// The arguments of a state.
    fn arguments<const N: usize>(&self, inputs: [f64; N], speeds: [f64; N]) -> Vec<f64> {
        let mut arguments = self.given.clone();
        for (k, indices) in self.inputs.iter().enumerate() {
            arguments[indices.value] = inputs[k];
            arguments[indices.speed] = speeds[k];
        }
        arguments
    }
}

/// An input that moves, or its speed.
#[derive(Clone, Copy)]
pub(super) enum Moving {
    Input(usize),
    Speed(usize),
}
