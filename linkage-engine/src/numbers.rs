//! Numbers that programs load.

use linkage_runtime::support::{Dispatch, InitialState, Revolutions};
use linkage_runtime::{AssemblyMode, Scalar};
use linkage_symbolic::program::Source;

use crate::mechanism::Mechanism;

/// The revolutions of all angles.
pub(crate) type AllRevolutions = Revolutions<Vec<f64>, Vec<Vec<f64>>>;

/// A mechanism's numbers at some inputs.
#[derive(Clone, Copy)]
pub(crate) struct Numbers<'a> {
    pub(crate) dimensions: &'a [f64],
    pub(crate) modes: &'a [AssemblyMode],
    pub(crate) revolutions: &'a AllRevolutions,
    pub(crate) prepared: &'a [f64],
    /// Inputs, then the arguments behind them.
    pub(crate) inputs: &'a [f64],
    /// The state of each coupled group, with its floor.
    pub(crate) states: &'a [Vec<f64>],
}

impl Numbers<'_> {
    /// Returns the number of a source.
    pub(crate) fn load(&self, source: Source) -> f64 {
        match source {
            Source::Parameter(index) => self.dimensions[index],
            Source::Input(index) => self.inputs[index],
            Source::Mode(mode) => self.modes[mode].sign(),
            Source::Centre(angle) => self.revolutions.centres[angle],
            Source::Winding(angle, input) => self.revolutions.windings[angle][input],
            Source::Prepared(slot) => self.prepared[slot],
            Source::State(group, component) => self.states[group][component],
            Source::Limit => f64::CORRECTION_LIMIT,
            Source::Carried(_) => unreachable!("only stages carry, and programs run as a whole"),
        }
    }
}

/// The tables of all coupled groups of a mechanism.
#[derive(Clone, Copy)]
pub(crate) struct States<'a> {
    pub(crate) mechanism: &'a Mechanism,
    pub(crate) starts: &'a [InitialState],
    pub(crate) inputs: &'a [f64],
}

impl States<'_> {
    /// The states at the inputs, each with its floor, by the instructions of the build.
    pub(crate) fn by_build(self) -> Vec<Vec<f64>> {
        self.mechanism.multiply_adds.by_build(&self)
    }

    /// The same with fused multiply-add if the machine has it.
    pub(crate) fn by_machine(self) -> Vec<Vec<f64>> {
        self.mechanism.multiply_adds.by_machine(&self)
    }
}

impl Dispatch<f64, Vec<Vec<f64>>, 0> for States<'_> {
    #[inline(always)]
    fn at<const FUSED: bool>(&self, []: [f64; 0]) -> Vec<Vec<f64>> {
        let mut states = Vec::with_capacity(self.starts.len());
        for (group, start) in self.mechanism.compiled.coupled.iter().zip(self.starts) {
            let inputs: Vec<f64> = group
                .inputs
                .iter()
                .map(|&input| self.inputs[input])
                .collect();
            let mut state = vec![f64::NAN; group.size];
            let floor = start.look_up::<FUSED>(&inputs, &mut state);
            state.push(floor);
            states.push(state);
        }
        states
    }
}
