//! Coupled groups evaluated on numbers, in the form used to follow them.

use linkage_core::Enclosure;
use linkage_core::numeric::continuation::{Correction, Residuals, Step};
use linkage_symbolic::program::Program;

use crate::ir::Coupled;

use super::interpreter::Machine;
use super::staged::StagedProgram;

/// A coupled group on numbers.
pub(crate) struct Numbers<'a> {
    machine: &'a Machine,
    number: usize,
    inputs: Vec<f64>,
    /// The step of the group, once it has run.
    step: Option<StagedProgram>,
}

impl<'a> Numbers<'a> {
    /// A coupled group at these inputs of the mechanism, and those of them that are its own.
    pub(crate) fn new(machine: &'a Machine, number: usize, inputs: &[f64]) -> (Self, Vec<f64>) {
        let group_inputs = &machine.closure.coupled[number].inputs;
        let group_inputs = group_inputs.iter().map(|&input| inputs[input]).collect();
        let inputs = inputs.to_vec();
        let numbers = Self {
            machine,
            number,
            inputs,
            step: None,
        };
        (numbers, group_inputs)
    }

    fn group(&self) -> &Coupled {
        &self.machine.closure.coupled[self.number]
    }

    /// All inputs of the mechanism; the group's own are `x`.
    fn set_inputs(&mut self, x: &[f64]) {
        let machine = self.machine;
        let group_inputs = &machine.closure.coupled[self.number].inputs;
        for (&input, &value) in group_inputs.iter().zip(x) {
            self.inputs[input] = value;
        }
    }

    pub(crate) fn run(&self, program: &Program, state: &[f64]) -> Vec<f64> {
        self.machine
            .run_coupled(self.number, program, &self.inputs, state)
    }
}

impl Correction for Numbers<'_> {
    fn correct(&mut self, x: &[f64], state: &mut [f64]) -> Step {
        self.set_inputs(x);
        let program = &self.machine.closure.coupled[self.number].correct;
        let number = self.number;
        let step = self
            .step
            .get_or_insert_with(|| StagedProgram::new(program, Some(number)));
        self.machine.run_step(number, step, &self.inputs, state);
        let mut outputs = step.outputs();
        for (number, next) in state.iter_mut().zip(&mut outputs) {
            *number = next;
        }
        let mut rest = || outputs.next().unwrap_or(f64::NAN);
        Step {
            size: rest().sqrt(),
            determinant: rest(),
        }
    }
}

impl Residuals for Numbers<'_> {
    fn residuals(&mut self, x: &[f64], state: &[Enclosure]) -> Vec<Enclosure> {
        self.set_inputs(x);
        let program = &self.group().residuals;
        self.machine
            .run_over(self.number, program, &self.inputs, state)
    }
}
