//! The signature of the programs of a mechanism: names, units, numbers as they were declared.

use std::f64::consts::TAU;

use linkage_core::Cycle;

use crate::model::Shape;

/// At how many positions of a turn, or of a range of lengths, assemblies are listed.
const SAMPLES: usize = 72;

/// A parameter as the user declared it.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// The name as declared; that of a part has the part's name in front: `crank`, `hook.crank`.
    pub name: String,
    /// Its doc comment, line by line as written.
    pub documentation: String,
    /// A number or a vector.
    pub shape: Shape,
    /// True if it is the length of a link, which is hardly meant to be negative.
    pub is_link_length: bool,
    /// Its scalars; programs count these through all parameters.
    pub scalars: Vec<Scalar>,
}

/// A scalar of a parameter.
#[derive(Clone, Debug)]
pub struct Scalar {
    /// `crank`, `pivot.x`
    pub name: String,
    /// The unit of the field: `mm`, `rad`, `kg`, empty for a number.
    pub unit: String,
    /// The default value, in that unit.
    pub nominal: f64,
    /// In that unit; 0 where none is declared.
    pub tolerance: f64,
}

/// A driving coordinate.
#[derive(Clone, Debug)]
pub struct Input {
    /// The name as declared.
    pub name: String,
    /// Its unit as programs count it.
    pub unit: String,
    /// True for an angle, of which a turn leads back.
    pub angle: bool,
    /// The value at which the loops are closed at compile time.
    pub reference: f64,
    /// The range as declared, lower end first.
    pub range: Option<(f64, f64)>,
    /// The range over which angles are followed, the reference twice if over none.
    pub followed: (f64, f64),
    /// Candidates for the turns that an unknown angle makes for each turn of this input.
    pub rates: Vec<f64>,
}

impl Input {
    /// Returns the range in which its assemblies are searched, and the number of positions at which
    /// they are listed.
    pub fn cycle(&self) -> Cycle {
        let (low, high) = self.range.unwrap_or(self.followed);
        let turns = (high - low) / TAU;
        let samples = match self.angle {
            true => (turns * SAMPLES as f64).ceil().clamp(24.0, 1000.0) as usize,
            false => SAMPLES,
        };
        Cycle {
            low,
            high,
            angle: self.angle,
            samples: samples + 1,
        }
    }
}

/// An argument that functions may take after the inputs.
#[derive(Clone, Debug)]
pub struct Argument {
    /// The name as declared.
    pub name: String,
    /// The unit of the value that a call is given.
    pub unit: String,
    /// The quantity that it gives.
    pub role: Role,
    /// The declared value of a load, in that unit: the default where no other value is given.
    pub reference: Option<f64>,
}

/// The quantity that an argument gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The speed of an input, by index.
    Speed(usize),
    /// The acceleration of an input, by index.
    Acceleration(usize),
    /// Something that the user declared.
    Load,
}

/// An unknown of the model.
#[derive(Clone, Debug)]
pub struct Unknown {
    /// The name as declared.
    pub name: String,
    /// `mm`, `rad`, nothing for a number.
    pub unit: String,
    /// True for an angle or a number, false for a length or a point.
    pub is_number: bool,
}

/// An unknown angle whose value (not only its direction) is used by some function.
#[derive(Clone, Debug)]
pub struct ContinuousAngle {
    /// Index among the unknowns.
    pub unknown: usize,
    /// The inputs it depends on.
    pub inputs: Vec<usize>,
    /// Start estimate at the reference inputs, radians.
    pub estimate: f64,
    /// The vectors whose sum the angle keeps within a quarter turn of, wherever its group can be
    /// assembled; empty if no closed form gives them.
    pub phases: Vec<Phase>,
}

/// A vector of fixed length that turns.
#[derive(Clone, Debug)]
pub struct Phase {
    /// The number of turns that it makes for a turn of each input; `None` if it turns with
    /// something else, too.
    pub turns: Option<Vec<f64>>,
}
