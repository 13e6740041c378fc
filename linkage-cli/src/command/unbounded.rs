//! Forces that grow without bound: the mechanism passes a singular position, at which it is held by
//! no finite force. The loops close there, so their margins do not show it.

use linkage_engine::{Assembly, Mechanism};
use linkage_runtime::Input;

use super::assemblies::placed;
use super::sweep::positions;
use crate::failure::{Failure, listed};

/// Beyond a pole, the reciprocal of the second number is at least so many times that of the first.
const FALL: f64 = 4.0 / 3.0;

/// Numbers below this part of the largest force at their position are rounding.
const ROUNDING: f64 = 1e-6;

/// Halvings of the step in which a pole is, and the growth of the force over them.
const HALVINGS: usize = 40;
const GROWTH: f64 = 1e4;

/// Positions over the range at which a check evaluates forces.
const POSITIONS: u32 = 361;

/// Speeds and accelerations for a check: the positions of poles do not depend on them.
const RATE: f64 = 1.0;

/// Forces of a function that are seen one position after the other.
pub(super) struct Unbounded {
    /// The columns that are forces or torques.
    columns: Vec<usize>,
    /// The inputs and the forces at the last positions, the newest last.
    last: Vec<(f64, Vec<f64>)>,
    /// Steps of the input in which a force seems to have a pole, with the column.
    steps: Vec<(usize, [f64; 2])>,
}

impl Unbounded {
    pub(super) fn new(mechanism: &Mechanism, function: usize) -> Self {
        let columns = mechanism.headings()[function].columns.iter().enumerate();
        let forces = columns.filter(|(_, column)| is_force(column.unit));
        Self {
            columns: forces.map(|(index, _)| index).collect(),
            last: Vec::new(),
            steps: Vec::new(),
        }
    }

    /// Takes the results of the next position.
    pub(super) fn add(&mut self, x: f64, results: &[f64]) {
        if self.columns.is_empty() {
            return;
        }
        let forces = self.columns.iter().map(|&column| results[column]);
        self.last.push((x, forces.collect()));
        match self.last.len() {
            3 => self.search([None, Some(0), Some(1), Some(2)]),
            4 => {
                self.search([0, 1, 2, 3].map(Some));
                self.last.remove(0);
            }
            _ => {}
        }
    }

    /// Searches the step between the second and the third of the last positions.
    fn search(&mut self, indices: [Option<usize>; 4]) {
        let positions = indices.map(|index| index.and_then(|index| self.last.get(index)));
        let [before, Some(low), Some(high), after] = positions else {
            return;
        };
        let forces = low.1.iter().chain(&high.1);
        let least = ROUNDING * forces.fold(0.0, |most: f64, force| most.max(force.abs()));
        let columns = self.columns.iter().enumerate();
        let columns = columns.filter(|&(k, _)| {
            let [before, after] = [before, after].map(|row| row.map(|(_, forces)| forces[k]));
            let pair = [low.1[k], high.1[k]];
            pair.iter().any(|force| force.abs() > least) && has_pole(before, pair, after)
        });
        let step = [low.0, high.0];
        let steps: Vec<_> = columns.map(|(_, &column)| (column, step)).collect();
        self.steps.extend(steps);
    }

    /// Returns a message for each singular position; `results` are those of the function at another
    /// position.
    pub(super) fn messages(
        mut self,
        mechanism: &Mechanism,
        function: usize,
        input: &Input,
        results: impl Fn(f64) -> Vec<f64>,
    ) -> Vec<String> {
        if self.last.len() == 3 {
            self.search([Some(0), Some(1), Some(2), None]);
        }
        let heading = mechanism.headings()[function];
        let mut found: Vec<([f64; 2], Vec<&str>, f64)> = Vec::new();
        for (column, step) in self.steps {
            let Some(x) = pole(step, |x| results(x)[column]) else {
                continue;
            };
            let name = heading.columns[column].name;
            match found.iter_mut().find(|(other, ..)| *other == step) {
                Some((_, names, _)) => names.push(name),
                None => found.push((step, vec![name], x)),
            }
        }
        let message = |(_, names, x): ([f64; 2], Vec<&str>, f64)| {
            let verb = if names.len() == 1 { "grows" } else { "grow" };
            format!(
                "{}: {} of `{}` {verb} without bound at `{}`: the mechanism passes a singular position",
                mechanism.name(),
                listed(names),
                heading.function,
                placed(input, rounded(x, input.unit)),
            )
        };
        found.into_iter().map(message).collect()
    }
}

/// Returns true if a function of the mechanism has forces among its results.
pub(super) fn has_forces(mechanism: &Mechanism) -> bool {
    let headings = mechanism.headings().iter();
    let mut columns = headings.flat_map(|heading| heading.columns);
    columns.any(|column| is_force(column.unit))
}

/// Returns the messages about all functions with forces over the range of the first input.
pub(super) fn singular_positions(
    assembly: &Assembly<'_>,
    mechanism: &Mechanism,
) -> Result<Vec<String>, Failure> {
    let mut all = Vec::new();
    let Some(input) = mechanism
        .inputs()
        .first()
        .filter(|input| input.range.is_some())
    else {
        return Ok(all);
    };
    let positions = positions(mechanism, input, [None; 2], POSITIONS)?;
    for (function, heading) in mechanism.headings().iter().enumerate() {
        let mut unbounded = Unbounded::new(mechanism, function);
        let index = heading
            .arguments
            .iter()
            .position(|name| *name == input.name);
        let Some(index) = index.filter(|_| !unbounded.columns.is_empty()) else {
            continue;
        };
        let given = mechanism.compiled().functions[function].arguments.iter();
        let given = given.map(|&argument| mechanism.default_argument(argument).unwrap_or(RATE));
        let given: Vec<f64> = given.collect();
        let results = |x: f64| {
            let mut arguments = given.clone();
            arguments[index] = x;
            assembly.call(function, &arguments)
        };
        for x in positions.iter() {
            unbounded.add(x, &results(x));
        }
        all.extend(unbounded.messages(mechanism, function, input, results));
    }
    Ok(all)
}

/// Returns true for units of forces and torques.
fn is_force(unit: &str) -> bool {
    let mut words = unit.split(|letter: char| !letter.is_alphabetic());
    words.any(|word| word == "N")
}

/// Returns true if the numbers of neighbouring positions change their sign at a pole and not at
/// zero: they grow towards it, and at a jump they stay as they are.
fn has_pole(before: Option<f64>, [low, high]: [f64; 2], after: Option<f64>) -> bool {
    let falls = |near: f64, far: Option<f64>| {
        far.filter(|x| x.is_finite())
            .map(|far| near * far > 0.0 && near.abs() > FALL * far.abs())
    };
    let sides = [falls(low, before), falls(high, after)];
    let is_known = sides.iter().any(Option::is_some);
    low * high < 0.0 && is_known && sides.iter().flatten().all(|falls| *falls)
}

/// Returns the position of a pole in a step; nothing if the force stays finite.
fn pole([mut low, mut high]: [f64; 2], force: impl Fn(f64) -> f64) -> Option<f64> {
    let [mut below, above] = [low, high].map(&force);
    let first = below.abs().max(above.abs());
    let mut middle = 0.5 * (low + high);
    let mut size = 0.0_f64;
    for _ in 0..HALVINGS {
        middle = 0.5 * (low + high);
        let here = force(middle);
        if !here.is_finite() {
            // At the pole itself.
            return Some(middle);
        }
        size = size.max(here.abs());
        if here * below > 0.0 {
            (low, below) = (middle, here);
        } else {
            high = middle;
        }
    }
    (size > GROWTH * first).then_some(middle)
}

/// Four digits of a position, of an angle in degrees.
fn rounded(x: f64, unit: &str) -> f64 {
    let four_digits = |x: f64| format!("{x:.3e}").parse().unwrap_or(x);
    match unit {
        "rad" => four_digits(x.to_degrees()).to_radians(),
        _ => four_digits(x),
    }
}
