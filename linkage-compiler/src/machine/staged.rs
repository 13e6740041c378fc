//! Programs that run many times at the same inputs: values are kept as long as the numbers from
//! which they are computed stay the same.

use linkage_symbolic::interpret::run_steps;
use linkage_symbolic::program::{Instruction, Program, Source, Value};

/// A program whose instructions are in the order of their stages.
#[derive(Clone, Debug)]
pub(crate) struct StagedProgram {
    program: Program,
    /// The number of instructions that depend on parameters only.
    fixed: usize,
    /// The number of instructions that do not depend on the state of the group.
    at_inputs: usize,
    /// The values so far; empty before the first run.
    values: Vec<f64>,
    /// The inputs of these values.
    inputs: Vec<f64>,
    /// The states of other groups at these inputs.
    others: Vec<Vec<f64>>,
}

impl StagedProgram {
    /// Divides a step of the coupled group `number`, or a program of no such group.
    pub(super) fn new(program: &Program, number: Option<usize>) -> Self {
        let mut stages: Vec<usize> = Vec::with_capacity(program.instructions.len());
        for instruction in &program.instructions {
            let loaded = match instruction {
                Instruction::Load(Source::State(group, _)) if Some(*group) == number => 2,
                Instruction::Load(Source::State(..) | Source::Input(_)) => 1,
                _ => 0,
            };
            let operands = instruction.operands().map(|value| stages[value.0]);
            stages.push(operands.fold(loaded, usize::max));
        }
        let mut order: Vec<usize> = (0..stages.len()).collect();
        order.sort_by_key(|&index| stages[index]);
        let mut moved = vec![0; order.len()];
        for (to, &from) in order.iter().enumerate() {
            moved[from] = to;
        }
        let value = |value: Value| Value(moved[value.0]);
        let instructions = order.iter();
        let instructions =
            instructions.map(|&from| program.instructions[from].with_operands(value));
        let before = |stage: usize| stages.iter().filter(|&&other| other < stage).count();
        Self {
            program: Program {
                instructions: instructions.collect(),
                outputs: program
                    .outputs
                    .iter()
                    .map(|&output| value(output))
                    .collect(),
            },
            fixed: before(1),
            at_inputs: before(2),
            values: Vec::new(),
            inputs: Vec::new(),
            others: Vec::new(),
        }
    }

    /// Runs it. `states` returns the states of other groups at the inputs; `load` has their states.
    pub(super) fn run(
        &mut self,
        inputs: &[f64],
        states: impl FnOnce() -> Vec<Vec<f64>>,
        load: impl Fn(Source, &[Vec<f64>]) -> f64,
    ) {
        let same = self.inputs == inputs && !self.values.is_empty();
        if !same {
            self.others = states();
            self.inputs = inputs.to_vec();
        }
        let from = match (self.values.is_empty(), same) {
            (true, _) => 0,
            (false, false) => self.fixed,
            (false, true) => self.at_inputs,
        };
        let others = &self.others;
        let end = self.program.instructions.len();
        run_steps(&self.program, from, end, &mut self.values, |source| {
            load(source, others)
        });
    }

    /// Returns one result of the last run.
    pub(crate) fn output(&self, output: usize) -> f64 {
        self.values[self.program.outputs[output].0]
    }

    /// Returns the results of the last run.
    pub(super) fn outputs(&self) -> impl Iterator<Item = f64> + '_ {
        let outputs = self.program.outputs.iter();
        outputs.map(|output| self.values[output.0])
    }
}

#[cfg(test)]
mod tests {
    use linkage_symbolic::interpret::run;
    use linkage_symbolic::program::Binary;

    use super::*;

    /// Results are those of the program as it is, whatever changes between two runs.
    #[test]
    fn values_are_kept_no_longer_than_they_hold() {
        let load = |source| Instruction::Load(source);
        let both = |op, a, b| Instruction::Binary(op, Value(a), Value(b));
        let program = Program {
            instructions: vec![
                load(Source::State(1, 0)),
                load(Source::Input(0)),
                load(Source::Parameter(0)),
                both(Binary::Mul, 0, 1),
                both(Binary::Add, 2, 2),
                Instruction::SinCos(Value(1)),
                Instruction::Second(Value(5)),
                both(Binary::Add, 3, 4),
                load(Source::State(0, 0)),
                both(Binary::Mul, 6, 8),
                both(Binary::Sub, 7, 9),
            ],
            outputs: vec![Value(10), Value(4), Value(9)],
        };
        let number = |source: Source, x: f64, state: f64| match source {
            Source::State(1, _) => state,
            Source::State(..) => 3.0 * x,
            Source::Input(_) => x,
            _ => 0.7,
        };
        let mut staged = StagedProgram::new(&program, Some(1));
        assert_eq!([staged.fixed, staged.at_inputs], [2, 7]);
        for (x, state) in [(0.3, 1.0), (0.3, 2.0), (0.4, 2.0), (0.3, 2.0), (0.3, 1.0)] {
            staged.run(
                &[x],
                || vec![vec![3.0 * x]],
                |source, others| match source {
                    Source::State(0, _) => others[0][0],
                    _ => number(source, x, state),
                },
            );
            let expected = run(&program, |source| number(source, x, state));
            assert_eq!(staged.outputs().collect::<Vec<f64>>(), expected);
        }
    }
}
