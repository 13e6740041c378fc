//! A motion under forces, whose report has times as positions.

use std::string::String;
use std::vec::Vec;

/// A motion that forces make, so that its page can compute it for other dimensions, loads and
/// starts. The positions of its report are times in s. Its tables are named by their functions.
#[derive(Clone, Debug)]
pub struct DrivenMotion {
    /// The function with the acceleration of each input.
    pub function: String,
    /// The table of inputs and speeds, which no function returns.
    pub state: String,
    /// All inputs, in the order of the mechanism.
    pub inputs: Vec<MovingInput>,
    /// The check of the energy, if the mechanism has one.
    pub energy: Option<MotionEnergy>,
    /// The time that was asked for, s.
    pub until: f64,
    /// The tolerance of a step, relative and absolute.
    pub tolerance: f64,
    /// Values that end the motion.
    pub stops: Vec<MotionStop>,
    /// A sentence about the end, if that is not the time that was asked for.
    pub end: Option<String>,
}

/// An input of a motion under forces.
#[derive(Clone, Debug)]
pub struct MovingInput {
    /// Its name.
    pub name: String,
    /// The name of its speed.
    pub speed: String,
    /// The name of its acceleration, if the function takes that.
    pub acceleration: Option<String>,
    /// The column of the function with its acceleration.
    pub column: usize,
}

/// Functions for the check of the energy.
#[derive(Clone, Debug)]
pub struct MotionEnergy {
    /// The table with the columns `kinetic`, `potential`, `work` and `drift`.
    pub table: String,
    /// A function that returns the generalised forces of all inputs, the derivatives of the potential
    /// energy with respect to them, the kinetic and the potential energy.
    pub loads: String,
    /// A function that returns the drives of all inputs that hold the weights at rest.
    pub weights: String,
}

/// A number that ends a motion where it passes a value.
#[derive(Clone, Debug)]
pub struct MotionStop {
    /// The text of the option.
    pub text: String,
    /// The number.
    pub watched: Watched,
    /// The value.
    pub value: f64,
}

/// A number of a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Watched {
    /// An input, by index.
    Input(usize),
    /// The speed of an input, by index.
    Speed(usize),
    /// A column of the function.
    Column(usize),
}
