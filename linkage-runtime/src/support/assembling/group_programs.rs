//! The programs of a coupled group on plain numbers, as it is prepared by them.

use alloc::vec::Vec;
use linkage_core::Enclosure;
use linkage_core::numeric::continuation::{Correction, Residuals, Step};

use super::compiled::CoreOf;
use super::grouped::{GroupProgram, PlainGroups, prepared_core};
use super::winding::wind;
use crate::error::AssemblyError;
use crate::support::coupled::{CoupledGroup, CoupledPrograms, pairs, placed, stepped};

/// A coupled group, given what is prepared of those before it.
pub struct GroupPrograms<C: PlainGroups> {
    number: usize,
    core: CoreOf<C>,
    states: C::States,
    at: C::Inputs,
}

impl<C: PlainGroups> GroupPrograms<C> {
    /// Group `number`, with the initial states of those before it; `at` are all inputs of the
    /// mechanism.
    ///
    /// # Errors
    ///
    /// If an angle that it depends on cannot be followed.
    pub(crate) fn new(
        mechanism: &C,
        modes: &C::Modes,
        at: &C::Inputs,
        number: usize,
        starts: &C::Lane,
    ) -> Result<Self, AssemblyError> {
        let states = mechanism.states(core::slice::from_ref(starts));
        let count = mechanism.group_data().coupled[number].turning;
        let revolutions = wind(mechanism, modes, &states, count, at);
        let revolutions = revolutions.map_err(|unknown| AssemblyError::NoWinding {
            mechanism: mechanism.description().name,
            unknown,
        })?;
        Ok(Self {
            number,
            core: prepared_core(mechanism, modes, revolutions),
            states,
            at: at.clone(),
        })
    }

    fn group(&self) -> &'static CoupledGroup {
        &self.core.dimensions.group_data().coupled[self.number]
    }

    /// The arguments where the inputs of the group are `inputs`.
    fn arguments(&mut self, inputs: &[f64]) -> C::Arguments {
        for (input, x) in self.group().inputs.iter().zip(inputs) {
            self.at.as_mut()[input.index] = *x;
        }
        self.core.dimensions.arguments(&self.states, &self.at)
    }

    fn arguments_in(&mut self, inputs: &[f64], state: &[f64]) -> C::Arguments {
        let mut x = self.arguments(inputs);
        C::state_mut(&mut x, self.number)[..state.len()].copy_from_slice(state);
        x
    }

    fn run<R>(&self, program: GroupProgram, x: C::Arguments, read: impl FnOnce(&[f64]) -> R) -> R {
        C::run(&self.core, self.number, program, x, read)
    }
}

impl<C: PlainGroups> Correction for GroupPrograms<C> {
    fn correct(&mut self, inputs: &[f64], state: &mut [f64]) -> Step {
        let x = self.arguments_in(inputs, state);
        self.run(GroupProgram::Correct, x, |outputs| stepped(state, outputs))
    }
}

impl<C: PlainGroups> Residuals for GroupPrograms<C> {
    fn residuals(&mut self, inputs: &[f64], state: &[Enclosure]) -> Vec<Enclosure> {
        let x = self.arguments(inputs);
        C::residuals(&self.core, self.number, x, state)
    }
}

impl<C: PlainGroups> CoupledPrograms for GroupPrograms<C> {
    fn system(&mut self, inputs: &[f64]) -> Vec<[f64; 2]> {
        let x = self.arguments(inputs);
        self.run(GroupProgram::System, x, pairs)
    }

    fn placed(&mut self, inputs: &[f64], state: &[f64]) -> Vec<[f64; 2]> {
        let x = self.arguments_in(inputs, state);
        let group = self.group();
        self.run(GroupProgram::Placed, x, |outputs| placed(group, outputs))
    }

    fn estimate(&mut self, inputs: &[f64]) -> Vec<f64> {
        let x = self.arguments(inputs);
        self.run(GroupProgram::Estimate, x, <[f64]>::to_vec)
    }

    fn missed(&mut self, inputs: &[f64], state: &[f64]) -> Vec<f64> {
        let x = self.arguments_in(inputs, state);
        self.run(GroupProgram::Missed, x, <[f64]>::to_vec)
    }
}
