//! The programs of a coupled group, as the runtime prepares it.

use linkage_runtime::support::{
    Correction, CoupledPrograms, InitialState, Residuals, Step, pairs, placed, stepped,
};
use linkage_runtime::{AssemblyError, AssemblyMode, Enclosure, Scalar};
use linkage_symbolic::program::{Program, Source};

use crate::mechanism::Mechanism;
use crate::numbers::{Numbers, States};
use crate::operations::{by_build, over_states};
use crate::revolutions::Revolutions;
use crate::winding::Winding;

/// A group, and the prepared numbers of the groups before it.
pub(crate) struct Programs<'m> {
    mechanism: &'m Mechanism,
    number: usize,
    dimensions: Vec<f64>,
    modes: Vec<AssemblyMode>,
    revolutions: Revolutions,
    prepared: Vec<f64>,
    starts: Vec<InitialState>,
    at: Vec<f64>,
}

impl<'m> Programs<'m> {
    /// Group `number`; `at` are all inputs of the mechanism.
    ///
    /// # Errors
    ///
    /// If an angle that it depends on cannot be followed.
    pub(crate) fn new(
        mechanism: &'m Mechanism,
        dimensions: &[f64],
        modes: &[AssemblyMode],
        at: &[f64],
        number: usize,
        starts: &[InitialState],
    ) -> Result<Self, AssemblyError> {
        let turning = Winding {
            mechanism,
            dimensions,
            modes,
            starts,
        };
        let revolutions = turning.wind(mechanism.compiled.coupled[number].turning, at);
        let revolutions = revolutions.map_err(|unknown| AssemblyError::NoWinding {
            mechanism: mechanism.name,
            unknown,
        })?;
        Ok(Self {
            mechanism,
            number,
            dimensions: dimensions.to_vec(),
            modes: modes.to_vec(),
            prepared: turning.prepare(&revolutions),
            revolutions,
            starts: starts.to_vec(),
            at: at.to_vec(),
        })
    }

    /// The states of all groups where this one's inputs are `own`.
    fn states_at(&mut self, inputs: &[f64]) -> Vec<Vec<f64>> {
        let group = &self.mechanism.groups[self.number];
        for (input, x) in group.inputs.iter().zip(inputs) {
            self.at[input.index] = *x;
        }
        let states = States {
            mechanism: self.mechanism,
            starts: &self.starts,
            inputs: &self.at,
        };
        states.by_build()
    }

    fn states_with(&mut self, inputs: &[f64], state: &[f64]) -> Vec<Vec<f64>> {
        let mut states = self.states_at(inputs);
        states[self.number][..state.len()].copy_from_slice(state);
        states
    }

    fn numbers<'a>(&'a self, states: &'a [Vec<f64>]) -> Numbers<'a> {
        Numbers {
            dimensions: &self.dimensions,
            modes: &self.modes,
            revolutions: &self.revolutions,
            prepared: &self.prepared,
            inputs: &self.at,
            states,
        }
    }

    fn run(&self, program: &Program, numbers: Numbers<'_>) -> Vec<f64> {
        by_build(self.mechanism.multiply_adds, program, |source| {
            numbers.load(source)
        })
    }
}

impl Correction for Programs<'_> {
    fn correct(&mut self, inputs: &[f64], state: &mut [f64]) -> Step {
        let states = self.states_with(inputs, state);
        let numbers = self.numbers(&states);
        let program = &self.mechanism.compiled.coupled[self.number].correct;
        stepped(state, &self.run(program, numbers))
    }
}

impl Residuals for Programs<'_> {
    fn residuals(&mut self, inputs: &[f64], state: &[Enclosure]) -> Vec<Enclosure> {
        let states = self.states_at(inputs);
        let numbers = self.numbers(&states);
        let program = &self.mechanism.compiled.coupled[self.number].residuals;
        over_states(program, |source| match source {
            Source::State(group, component) if group == self.number => state[component],
            _ => Enclosure::from_f64(numbers.load(source)),
        })
    }
}

impl CoupledPrograms for Programs<'_> {
    fn system(&mut self, inputs: &[f64]) -> Vec<[f64; 2]> {
        let states = self.states_at(inputs);
        let numbers = self.numbers(&states);
        let program = &self.mechanism.compiled.coupled[self.number].system;
        pairs(&self.run(program, numbers))
    }

    fn estimate(&mut self, inputs: &[f64]) -> Vec<f64> {
        let states = self.states_at(inputs);
        let numbers = self.numbers(&states);
        let program = &self.mechanism.compiled.coupled[self.number].estimate;
        self.run(program, numbers)
    }

    fn missed(&mut self, inputs: &[f64], state: &[f64]) -> Vec<f64> {
        let states = self.states_with(inputs, state);
        let numbers = self.numbers(&states);
        let program = &self.mechanism.compiled.coupled[self.number].missed;
        self.run(program, numbers)
    }

    fn placed(&mut self, inputs: &[f64], state: &[f64]) -> Vec<[f64; 2]> {
        let states = self.states_with(inputs, state);
        let numbers = self.numbers(&states);
        let group = &self.mechanism.compiled.coupled[self.number];
        let angles = group.unknowns.iter().map(|unknown| unknown.angle);
        let angles: Vec<bool> = angles.collect();
        let outputs = self.run(&group.placed, numbers);
        placed(&angles, group.reach, &outputs)
    }
}
