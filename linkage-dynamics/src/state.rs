//! Inputs and speeds of a motion at a time.

use crate::phase::Phase;

/// Inputs and speeds at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State<const N: usize> {
    /// Time, s.
    pub time: f64,
    /// Inputs, rad or the length unit.
    pub inputs: [f64; N],
    /// Speeds of the inputs per second.
    pub speeds: [f64; N],
}

impl<const N: usize> State<N> {
    pub(crate) const fn new(time: f64, phase: Phase<N>) -> Self {
        Self {
            time,
            inputs: phase.inputs,
            speeds: phase.speeds,
        }
    }

    pub(crate) const fn phase(&self) -> Phase<N> {
        Phase {
            inputs: self.inputs,
            speeds: self.speeds,
        }
    }
}
