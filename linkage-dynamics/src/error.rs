//! Motions that end before their time, with the motion up to there.

use crate::computed_motion::Motion;
use crate::equations_of_motion::Fault;
use crate::state::State;
use std::error::Error;
use std::fmt;

/// A motion that ended before its time, and the cause.
#[derive(Clone, Debug)]
pub struct Interrupted<const N: usize>(Box<(Motion<N>, Cause<N>)>);

impl<const N: usize> Interrupted<N> {
    pub(crate) fn new(motion: Motion<N>, cause: Cause<N>) -> Self {
        Self(Box::new((motion, cause)))
    }

    /// Returns the motion up to its end.
    #[must_use]
    pub const fn motion(&self) -> &Motion<N> {
        &self.0.0
    }

    /// Returns the cause of the end.
    #[must_use]
    pub const fn cause(&self) -> &Cause<N> {
        &self.0.1
    }

    /// Returns the motion up to its end.
    #[must_use]
    pub fn into_motion(self) -> Motion<N> {
        self.0.0
    }
}

impl<const N: usize> fmt::Display for Interrupted<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.cause().fmt(f)
    }
}

impl<const N: usize> Error for Interrupted<N> {}

/// The cause of the end of a motion.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Cause<const N: usize> {
    /// There are no accelerations after a state: no position, no load, or no inertia.
    Undefined {
        /// The last state before.
        state: State<N>,
        /// The reason at the next state.
        fault: Fault,
    },
    /// An input reaches its dead point: its speed is zero there, and the mechanism continues in
    /// another assembly mode.
    DeadPoint {
        /// The state at the dead point.
        state: State<N>,
        /// Index of the input.
        input: usize,
    },
    /// Steps become too short for the digits of the time, and are still too inaccurate.
    Tolerance {
        /// The last state.
        state: State<N>,
        /// Width of the step that was rejected, s.
        step: f64,
        /// The tolerance.
        tolerance: f64,
    },
    /// The greatest number of steps is exhausted.
    Steps {
        /// The last state.
        state: State<N>,
        /// The greatest number.
        most: usize,
    },
    /// A tolerance is not a positive number, or too small for the integrator.
    BadTolerance(f64),
    /// The start has a number that is not finite.
    BadStart(State<N>),
    /// The end is not after the start, or not finite.
    BadEnd {
        /// Time of the start, s.
        start: f64,
        /// Time of the end, s.
        end: f64,
    },
}

impl<const N: usize> fmt::Display for Cause<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Undefined { state, fault } => undefined(f, state, fault),
            Self::DeadPoint { state, input } => write!(
                f,
                "input {input} reaches a dead point at {} after {} s\nhelp: beyond it the mechanism is in another \
                 assembly mode; use an input that has no dead point there",
                Short(state.inputs[*input]),
                Short(state.time)
            ),
            Self::Tolerance {
                state,
                step,
                tolerance,
            } => write!(
                f,
                "the tolerance {tolerance} is not reached after {} s at {:?}, with a step of {} s\nhelp: use a \
                 larger tolerance, loads without jumps, or `Method::Implicit` for stiff springs",
                Short(state.time),
                state.inputs.map(Short),
                Short(*step)
            ),
            Self::Steps { state, most } => write!(
                f,
                "{most} steps end after {} s at {:?}\nhelp: raise `most_steps`, or use `Method::Implicit` for stiff \
                 springs",
                Short(state.time),
                state.inputs.map(Short)
            ),
            Self::BadTolerance(tolerance) => write!(
                f,
                "the tolerance {tolerance} cannot be used\nhelp: use a number from 1e-14 to 0.1"
            ),
            Self::BadStart(state) => write!(
                f,
                "the start {:?} with speeds {:?} after {} s is not finite",
                state.inputs, state.speeds, state.time
            ),
            Self::BadEnd { start, end } => {
                write!(f, "the end {end} s is not after the start {start} s")
            }
        }
    }
}

/// A number in ten digits, as messages have it.
struct Short(f64);

impl fmt::Display for Short {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rounded = format!("{:.9e}", self.0).parse().unwrap_or(self.0);
        if rounded == 0.0 || (1e-4..1e10).contains(&rounded.abs()) {
            write!(f, "{rounded}")
        } else {
            write!(f, "{rounded:e}")
        }
    }
}

impl fmt::Debug for Short {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// Writes the cause of missing accelerations.
fn undefined<const N: usize>(
    f: &mut fmt::Formatter<'_>,
    state: &State<N>,
    fault: &Fault,
) -> fmt::Result {
    let State {
        time,
        inputs,
        speeds,
    } = state;
    match fault {
        Fault::Accelerations => write!(f, "the accelerations are not finite")?,
        Fault::InertiaUndefined => write!(f, "the mechanism has no inertia")?,
        Fault::InertiaNotPositive(value) => write!(f, "the inertia {value} is not positive")?,
        Fault::ForceUndefined => write!(f, "the force is not finite")?,
    }
    write!(
        f,
        " after {} s beyond {:?} with speeds {:?}\nhelp: ",
        Short(*time),
        inputs.map(Short),
        speeds.map(Short)
    )?;
    f.write_str(match fault {
        Fault::Accelerations => {
            "look for a dead point or the end of the range there, and for a load that is NaN"
        }
        Fault::InertiaUndefined => "look for a dead point or the end of the range there",
        Fault::InertiaNotPositive(_) => "give the moving links masses or moments of inertia",
        Fault::ForceUndefined => "look for a load, a spring or a drive that is NaN",
    })
}
