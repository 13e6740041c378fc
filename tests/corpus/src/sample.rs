//! A whole mechanism as text.

use crate::builder::{Builder, Unknown, millimetres, radians};
use crate::functions::{Function, functions};

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
