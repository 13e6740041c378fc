//! A mechanism with one input, for the questions of machine builders.

use crate::equations_of_motion::Reduced;
use crate::stepper::{Method, Settings};
use std::f64::consts::TAU;

/// A mechanism with one input, as its reduced equation over input and speed.
///
/// The function returns inertia and force of [`Reduced`] for an input (rad) and its speed (rad/s).
#[derive(Clone, Copy, Debug)]
pub struct Machine<F> {
    pub(crate) equation: F,
    pub(crate) start: f64,
    pub(crate) period: f64,
    pub(crate) tolerance: f64,
}

/// Tolerance without another one: ten digits.
const TOLERANCE: f64 = 1e-10;

impl<F: Fn(f64, f64) -> Reduced> Machine<F> {
    /// Creates a machine that starts at the input zero and has a period of one turn.
    pub const fn new(equation: F) -> Self {
        Self {
            equation,
            start: 0.0,
            period: TAU,
            tolerance: TOLERANCE,
        }
    }

    /// Sets the input at the start.
    #[must_use]
    pub const fn start(mut self, input: f64) -> Self {
        self.start = input;
        self
    }

    /// Sets the period, in the unit of the input: two turns for an engine with four strokes.
    #[must_use]
    pub const fn period(mut self, period: f64) -> Self {
        self.period = period;
        self
    }

    /// Sets the tolerance of a step, 1e-10 without it.
    #[must_use]
    pub const fn tolerance(mut self, tolerance: f64) -> Self {
        self.tolerance = tolerance;
        self
    }

    /// Returns the acceleration of the input; NaN without a positive inertia.
    pub(crate) fn acceleration(&self, input: f64, speed: f64) -> f64 {
        (self.equation)(input, speed).accelerations()[0]
    }

    pub(crate) const fn settings(&self) -> Settings {
        Settings {
            method: Method::Explicit,
            relative: self.tolerance,
            absolute: self.tolerance,
        }
    }
}
