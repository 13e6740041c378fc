//! A random mechanism, compiled, and how much its results may differ.

use crate::{Entry, Function, Position, Sample, Subject, Unknown, Variable, sample};
use linkage_random::Random;

/// A random mechanism, compiled.
#[derive(Debug)]
pub struct Case {
    /// Its seed.
    pub seed: u64,
    /// The text, and what is known about it.
    pub sample: Sample,
    /// The compiled mechanism.
    pub subject: Subject,
}

impl Case {
    /// Generates and compiles the mechanism of a seed.
    ///
    /// # Errors
    /// The compiler's messages and the text.
    pub fn new(seed: u64) -> Result<Self, String> {
        let sample = sample(seed, "Generated");
        match Subject::new(&sample.text) {
            Ok(subject) => Ok(Self {
                seed,
                sample,
                subject,
            }),
            Err(messages) => Err(format!(
                "seed {seed}: {}\n{}",
                messages.join("\n"),
                sample.text
            )),
        }
    }

    /// A position within the declared ranges.
    pub fn position(&self, random: &mut Random) -> Position {
        let mut at = self.subject.reference();
        for (input, is_angle) in at.inputs.iter_mut().zip(&self.sample.angle_inputs) {
            *input += self.unit(*is_angle) * self.sample.range * random.between(-1.0, 1.0);
        }
        at
    }

    /// A radian, or 50 mm in the mechanism's unit.
    pub fn unit(&self, is_angle: bool) -> f64 {
        if is_angle {
            1.0
        } else {
            50.0 * self.sample.millimetre
        }
    }

    /// The unit of a variable.
    pub fn unit_of(&self, variable: Variable) -> f64 {
        match variable {
            Variable::Input(k) => self.unit(self.sample.angle_inputs[k]),
            Variable::Parameter(k) => self.unit(self.sample.angles[k]),
        }
    }

    /// The size of a result, apart from how far motions are magnified.
    fn size(&self, entry: Option<&Entry>) -> f64 {
        let Some(entry) = entry else { return 1.0 };
        let is_angle = |u: &Unknown| u.name == entry.name && u.is_angle;
        let own = self.unit(self.sample.unknowns.iter().any(is_angle));
        entry
            .by
            .iter()
            .fold(own, |size, variable| size / self.unit_of(*variable))
    }

    /// A position with one number changed.
    pub fn shifted(&self, at: &Position, variable: Variable, step: f64) -> Position {
        let mut at = at.clone();
        match variable {
            Variable::Input(k) => at.inputs[k] += step,
            Variable::Parameter(k) => at.parameters[k] += step,
        }
        at
    }

    /// What a change of all data by about `amount` (relative) does to each result.
    fn sway(&self, function: usize, at: &Position, amount: f64) -> Vec<f64> {
        let centre = self.subject.by_program(function, at);
        let mut sway = vec![0.0; centre.len()];
        for round in 0..6 {
            let mut random = Random::new(round + 1);
            let mut near = at.clone();
            let angles = self.sample.angle_inputs.iter().chain(&self.sample.angles);
            let numbers = near.inputs.iter_mut().chain(&mut near.parameters);
            for (x, is_angle) in numbers.zip(angles) {
                *x += amount * self.unit(*is_angle) * random.between(-1.0, 1.0);
            }
            let moved = self.subject.by_program(function, &near);
            for ((sway, a), b) in sway.iter_mut().zip(&moved).zip(&centre) {
                *sway = f64::max(*sway, (a - b).abs());
            }
        }
        sway
    }

    /// Differences between results of a function that were computed in two ways, as multiples of what a roundoff of
    /// every number that goes in does to them.
    pub fn differences(&self, function: usize, at: &Position, a: &[f64], b: &[f64]) -> Vec<f64> {
        assert_eq!(a.len(), b.len(), "as many results");
        let amount = 1e-10;
        let sway = self.sway(function, at, amount);
        let entries = &self.sample.functions[function].entries;
        // Derivatives that are zero in truth are what is left of others.
        let sizes = entries.iter().map(|entry| self.size(Some(entry)));
        let ratios = a.iter().zip(sizes).map(|(a, size)| a.abs() / size);
        let largest = ratios.fold(1.0, f64::max);
        let difference = |k: usize| {
            let size = largest * self.size(entries.get(k));
            let inherent = f64::EPSILON * (sway[k] / amount + b[k].abs() + size);
            (a[k] - b[k]).abs() / inherent
        };
        (0..a.len()).map(difference).collect()
    }

    /// A message about a function.
    pub fn complain(&self, function: &Function, what: &str) -> String {
        format!(
            "seed {}, {}: {what}\n{}",
            self.seed, function.name, self.sample.text
        )
    }
}
