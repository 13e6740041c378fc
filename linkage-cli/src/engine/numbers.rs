//! Where programs find what they load.

use linkage_runtime::generated::Start;
use linkage_runtime::{AssemblyMode, Scalar};
use linkage_symbolic::program::Source;

use super::turns::Turns;
use crate::mechanism::Mechanism;

/// A mechanism's numbers at some inputs.
#[derive(Clone, Copy)]
pub(super) struct Numbers<'a> {
    pub(super) dimensions: &'a [f64],
    pub(super) modes: &'a [AssemblyMode],
    pub(super) turns: &'a Turns,
    pub(super) prepared: &'a [f64],
    /// Inputs, then the arguments behind them.
    pub(super) inputs: &'a [f64],
    /// Of each coupled group, the state and its floor.
    pub(super) states: &'a [Vec<f64>],
}

impl Numbers<'_> {
    /// What a program loads.
    pub(super) fn load(&self, source: Source) -> f64 {
        match source {
            Source::Parameter(index) => self.dimensions[index],
            Source::Input(index) => self.inputs[index],
            Source::Mode(mode) => self.modes[mode].sign(),
            Source::Centre(angle) => self.turns.centres[angle],
            Source::Winding(angle, input) => self.turns.windings[angle][input],
            Source::Prepared(slot) => self.prepared[slot],
            Source::State(group, component) => self.states[group][component],
            Source::Limit => f64::CORRECTION_LIMIT,
            Source::Carried(_) => unreachable!("only stages carry, and programs run as a whole"),
        }
    }
}

/// The states of all coupled groups at these inputs, each with its floor.
pub(super) fn states(mechanism: &Mechanism, starts: &[Start], inputs: &[f64]) -> Vec<Vec<f64>> {
    let groups = mechanism.unit.coupled.iter().zip(starts);
    groups
        .map(|(group, start)| {
            let own: Vec<f64> = group.inputs.iter().map(|&input| inputs[input]).collect();
            let mut state = vec![f64::NAN; group.size];
            let floor = start.look_up(&own, &mut state);
            state.push(floor);
            state
        })
        .collect()
}
