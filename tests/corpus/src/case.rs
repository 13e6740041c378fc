//! A random mechanism: its whole text, its compiled form, and how much its results may differ.

use crate::builder::{Builder, Unknown, millimetres, radians};
use crate::functions::{Function, functions};
use crate::{Entry, Position, Subject, Variable};
use linkage_random::Random;

// A random mechanism, compiled, and how much its results may differ.

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

// A whole mechanism as text.

/// Length units of the generated mechanisms, and how many of them a millimetre is.
const UNITS: [(&str, f64); 4] = [("mm", 1.0), ("mm", 1.0), ("cm", 0.1), ("m", 1e-3)];

/// A mechanism and what is known about it.
#[derive(Clone, Debug)]
pub struct Sample {
    /// The tokens of the macro's input.
    pub text: String,
    /// The unknowns at the reference inputs, in millimetres and radians. Lengths in the text are rounded to 0.1
    /// micrometres, so the true values differ a little.
    pub unknowns: Vec<Unknown>,
    /// The functions of the text.
    pub functions: Vec<Function>,
    /// Names of the scalar parameters: `crank`, `pivot.x`.
    pub parameters: Vec<String>,
    /// True for the scalar parameters that are angles or numbers.
    pub angles: Vec<bool>,
    /// True for the inputs that are angles.
    pub angle_inputs: Vec<bool>,
    /// A millimetre in the mechanism's unit.
    pub millimetre: f64,
    /// Half the range of the first angle input, radians; for a length, in units of 50 mm.
    pub range: f64,
}

/// Mechanisms of the corpus; their seeds count from 0.
pub const COUNT: u64 = 46;

/// Seeds below this one give mechanisms of the plane.
const PLANAR: u64 = 36;

/// From this seed on every second mechanism has a crank that a law or a spline turns, too.
const DRIVEN: u64 = 47;

/// The share of groups in space in the others.
const IN_SPACE: f64 = 0.75;

/// The mechanism that belongs to a seed, of up to six chained groups.
pub fn sample(seed: u64, name: &str) -> Sample {
    let mut builder = Builder::new(seed);
    builder.crank();
    if builder.random.chance(0.25) {
        builder.crank();
    }
    let in_space = seed >= PLANAR;
    if seed >= DRIVEN && seed % 2 == 1 {
        builder.course_crank();
    }
    let wanted = 1 + builder.random.below(if in_space { 4 } else { 6 });
    let mut found = 0;
    while found < wanted {
        let closed = match in_space && builder.random.chance(IN_SPACE) {
            true => builder.add_group_in_space(),
            false => builder.add_group(),
        };
        found += usize::from(closed);
    }
    // A group passes motions on at most about threefold, and may turn by half a radian.
    let range = 0.15 / 3f64.powi(wanted as i32) / builder.inputs.len() as f64;
    let (unit, millimetre) = *builder.random.pick(&UNITS);
    let (functions_text, functions) = functions(&mut builder);
    let mut text = format!("pub struct {name} {{\n    unit {unit};\n");
    let ranged = builder.random.chance(0.7);
    for input in &builder.inputs {
        let (value, half, write): (_, _, fn(f64) -> String) = match input.is_angle {
            true => (input.value, range, radians),
            false => (input.value, 50.0 * range, millimetres),
        };
        let (low, high) = (write(value - half), write(value + half));
        let interval = if ranged {
            format!(" in {low}..{high}")
        } else {
            String::new()
        };
        text += &format!("    input {} = {}{interval};\n", input.name, write(value));
    }
    for item in &builder.items {
        text += &format!("    {item}\n");
    }
    text += &format!("}}\n\nimpl {name} {{\n{functions_text}}}\n");
    Sample {
        text,
        functions,
        parameters: builder
            .parameters
            .iter()
            .map(|(name, _)| name.clone())
            .collect(),
        angles: builder
            .parameters
            .iter()
            .map(|(_, is_angle)| *is_angle)
            .collect(),
        angle_inputs: builder.inputs.iter().map(|input| input.is_angle).collect(),
        unknowns: builder.unknowns,
        millimetre,
        range,
    }
}
