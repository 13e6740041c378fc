//! The mechanism on numbers: one program for all groups, run by the interpreter at compile time.

use linkage_symbolic::lookup::Map;

use linkage_core::{Enclosure, Scalar};
use linkage_symbolic::interpret::{run, run_by, run_steps};
use linkage_symbolic::program::{Program, Source, Value};
use linkage_symbolic::{Ex, SymbolId, evaluate, evaluate_given};

use crate::algebra::{Algebra, Bound, Nominal};
use crate::ir::{ClosurePrograms, ContinuousAngle, Coupled, Generated, PreparedTable};
use crate::solve::Formulation;

use super::staged::StagedProgram;

/// The programs with their data.
#[derive(Clone, Debug)]
pub(crate) struct Machine {
    pub(crate) closure: ClosurePrograms,
    parameters: Vec<f64>,
    pub(crate) modes: Vec<f64>,
    pub(crate) centres: Map<usize, f64>,
    pub(crate) windings: Map<(usize, usize), f64>,
    /// The prepared start of each coupled group: `None` until the group is closed.
    pub(crate) starts: Vec<Option<PreparedTable>>,
}

/// The state of a group near some inputs, then the least determinant that is certified.
fn state(start: &PreparedTable, group: &Coupled, inputs: &[f64]) -> Vec<f64> {
    let mut numbers = vec![0.0; group.size];
    let group_inputs: Vec<f64> = group.inputs.iter().map(|&input| inputs[input]).collect();
    let floor = match start {
        PreparedTable::Table(table) => table.state(group_inputs[0], &mut numbers),
        PreparedTable::Grid(grid) => grid.state(&group_inputs, &mut numbers),
    };
    numbers.push(floor);
    numbers
}

impl Machine {
    pub(crate) fn new(
        closure: ClosurePrograms,
        formulation: &Formulation,
        nominal: &Nominal,
    ) -> Self {
        Self {
            parameters: nominal.parameters.clone(),
            modes: vec![1.0; formulation.modes()],
            centres: Map::new(),
            windings: Map::new(),
            starts: vec![None; closure.coupled.len()],
            closure,
        }
    }

    /// Returns the cosines among the outputs of angles that functions use and no group uses.
    pub(crate) fn outputs_of(
        &self,
        algebra: &Algebra,
        asked: &[ContinuousAngle],
    ) -> Vec<(usize, usize)> {
        let outputs = self
            .closure
            .groups
            .iter()
            .flat_map(|group_outputs| &group_outputs.unknowns);
        outputs
            .filter(|(unknown, _)| asked.iter().any(|angle| angle.unknown == *unknown))
            .filter_map(|&(unknown, output)| match algebra.names.bound[unknown] {
                Bound::Angle(angle) => Some((angle, output)),
                Bound::Lengths(_) => None,
            })
            .filter(|(angle, _)| {
                self.closure
                    .valued
                    .iter()
                    .all(|(valued, _)| valued != angle)
            })
            .collect()
    }

    /// The values of the instructions `from..to` at given inputs; `values` holds those before.
    pub(crate) fn advance(&self, values: &mut Vec<f64>, from: usize, to: usize, inputs: &[f64]) {
        let states = self.states(inputs);
        run_steps(&self.closure.program, from, to, values, |source| {
            self.load(source, inputs, &states)
        });
    }

    /// Runs a program of coupled group `number` at given inputs; `state` is the state from which
    /// that group starts.
    pub(crate) fn run_coupled(
        &self,
        number: usize,
        program: &Program,
        inputs: &[f64],
        state: &[f64],
    ) -> Vec<f64> {
        let mut states = self.states(inputs);
        states[number] = state.to_vec();
        run(program, |source| self.load(source, inputs, &states))
    }

    /// Runs a step of coupled group `number` as [`run_coupled`](Self::run_coupled) does. The results
    /// are in `step`.
    pub(super) fn run_step(
        &self,
        number: usize,
        step: &mut StagedProgram,
        inputs: &[f64],
        state: &[f64],
    ) {
        let load = |source, others: &[Vec<f64>]| match source {
            Source::State(group, component) if group == number => {
                state.get(component).copied().unwrap_or(f64::NAN)
            }
            _ => self.load(source, inputs, others),
        };
        step.run(inputs, || self.states(inputs), load);
    }

    /// The same over a box of states.
    pub(crate) fn run_over(
        &self,
        number: usize,
        program: &Program,
        inputs: &[f64],
        state: &[Enclosure],
    ) -> Vec<Enclosure> {
        let states = self.states(inputs);
        let load = |source| match source {
            Source::State(group, component) if group == number => state
                .get(component)
                .copied()
                .unwrap_or(Enclosure::from_f64(f64::NAN)),
            _ => Enclosure::from_f64(self.load(source, inputs, &states)),
        };
        run_by::<Generated<Enclosure, false>>(program, load)
    }

    /// Returns the prepared states of all coupled groups near some inputs.
    pub(crate) fn states(&self, inputs: &[f64]) -> Vec<Vec<f64>> {
        let starts = self.starts.iter().zip(&self.closure.coupled);
        starts
            .map(|(start, group)| {
                start
                    .as_ref()
                    .map_or_else(Vec::new, |start| state(start, group, inputs))
            })
            .collect()
    }

    fn load(&self, source: Source, inputs: &[f64], states: &[Vec<f64>]) -> f64 {
        match source {
            Source::Parameter(index) => self.parameters[index],
            Source::Input(index) => inputs.get(index).copied().unwrap_or(f64::NAN),
            Source::Mode(index) => self.modes[index],
            Source::Centre(angle) => self.centres.get(&angle).copied().unwrap_or(f64::NAN),
            Source::Winding(angle, input) => {
                self.windings.get(&(angle, input)).copied().unwrap_or(0.0)
            }
            Source::State(group, component) => {
                states[group].get(component).copied().unwrap_or(f64::NAN)
            }
            Source::Limit => <f64 as Scalar>::CORRECTION_LIMIT,
            Source::Prepared(_) | Source::Carried(_) => f64::NAN,
        }
    }

    /// Expressions at given inputs.
    pub(crate) fn evaluate(&self, all: &[Ex], inputs: &[f64]) -> Vec<f64> {
        let states = self.states(inputs);
        evaluate(all, |source| self.load(source, inputs, &states))
    }

    /// Expressions at given inputs with given unknowns, whether or not these close the loops.
    pub(crate) fn evaluate_open(
        &self,
        all: &[Ex],
        inputs: &[f64],
        unknowns: &Map<SymbolId, f64>,
    ) -> Vec<f64> {
        let states = self.states(inputs);
        let load = |source| self.load(source, inputs, &states);
        evaluate_given(all, load, |symbol| unknowns.get(&symbol).copied())
    }

    /// The same mechanism, in the same assembly, with other dimensions.
    pub(crate) fn with_dimensions(&self, parameters: Vec<f64>) -> Self {
        Self {
            parameters,
            ..self.clone()
        }
    }

    /// Returns the whole program, to be run at many positions of this assembly.
    pub(crate) fn whole(&self) -> StagedProgram {
        self.staged(&self.closure.program)
    }

    /// Returns a part of the program, to be run at many positions of this assembly.
    pub(crate) fn staged(&self, part: &Program) -> StagedProgram {
        StagedProgram::new(part, None)
    }

    /// Runs a program at given inputs. Dimensions and assembly are those of its runs before.
    pub(crate) fn run_staged(&self, program: &mut StagedProgram, inputs: &[f64]) {
        let states = || self.states(inputs);
        program.run(inputs, states, |source, states| {
            self.load(source, inputs, states)
        });
    }

    /// Returns the part of the program that computes some of its outputs.
    pub(crate) fn part(&self, outputs: impl IntoIterator<Item = usize>) -> Program {
        self.closure.program.part(outputs)
    }

    /// Returns the outputs of a part of the program at given inputs.
    pub(crate) fn run_part(&self, part: &Program, inputs: &[f64]) -> Vec<f64> {
        let states = self.states(inputs);
        run(part, |source| self.load(source, inputs, &states))
    }

    /// An output's value.
    pub(crate) fn output(&self, values: &[f64], output: usize) -> f64 {
        let Value(index) = self.closure.program.outputs[output];
        values[index]
    }
}
