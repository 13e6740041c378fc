//! The check over the ranges of several inputs.

use linkage_core::numeric::continuation::{Correction, dead_point};
use linkage_core::range_check::{DEAD, ROUNDING};

use super::ranges::{Broken, Grid, Ranges};
use super::refused_range::RangeSurvey;
use crate::algebra::Nominal;
use crate::ir::PreparedTable;
use crate::machine::Numbers;
use crate::model::Mechanism;

/// The least slacks at the nodes of a box: between nodes it may be less.
const LEAST: [f64; 3] = [DEAD, 0.05, 0.2];

impl Ranges<'_, '_> {
    /// Returns the first position of a grid over several inputs that cannot be assembled. If a
    /// coupled group is not prepared, the dead point on the path there counts.
    pub(super) fn grid_failure(&mut self, declared: &[usize]) -> Option<Broken> {
        let grid = Grid::new(self.nominal, declared);
        (0..grid.count).find_map(|position| {
            let inputs = grid.inputs(self.nominal, position);
            let (slack, group) = self.slack(&inputs);
            if slack >= -ROUNDING {
                return None;
            }
            let broken = |inputs, finite| Broken {
                inputs,
                group,
                finite,
            };
            match self.unprepared(group, &inputs).filter(|_| slack.is_nan()) {
                Some(None) => None,
                Some(Some(at)) => Some(broken(at, true)),
                None => Some(broken(inputs, !slack.is_nan())),
            }
        })
    }

    /// Returns the mechanism with the ranges of the largest box without such a position.
    pub(super) fn largest_box(
        &mut self,
        mechanism: &Mechanism,
        declared: &[usize],
    ) -> Option<Nominal> {
        let nominal = self.nominal;
        let survey = RangeSurvey::new(nominal, declared)?;
        let nodes = survey.nodes(nominal).into_iter();
        let slacks: Vec<f64> = nodes.map(|inputs| self.slack(&inputs).0).collect();
        LEAST.iter().find_map(|&least| {
            let works: Vec<bool> = slacks.iter().map(|&slack| slack > least).collect();
            let narrower = survey.narrowed(mechanism, nominal, &works)?;
            let mut within = Ranges {
                formulation: self.formulation,
                nominal: &narrower,
                program: self.reference.machine.whole(),
                reference: &mut *self.reference,
            };
            let fails = within.grid_failure(declared).is_some();
            (!fails).then_some(narrower)
        })
    }

    /// Returns the inputs at the dead point on the straight path from the reference to these
    /// inputs, if there is one, for a coupled group that is prepared over several inputs but may
    /// not be for these. Returns `None` for other groups, and where the equations are not finite.
    fn unprepared(&self, group: usize, inputs: &[f64]) -> Option<Option<Vec<f64>>> {
        let number = self.formulation.groups[group].prepared.as_ref()?.number;
        let machine = &self.reference.machine;
        let Some(PreparedTable::Grid(grid)) = &machine.starts[number] else {
            return None;
        };
        let reference = &self.nominal.inputs;
        let (mut numbers, from) = Numbers::new(machine, number, reference);
        let (_, to) = Numbers::new(machine, number, inputs);
        let mut state = vec![0.0; grid.width()];
        grid.state(&from, &mut state);
        if !numbers.correct(&to, &mut state.clone()).size.is_finite() {
            return None;
        }
        let share = dead_point(&mut numbers, &from, &state, &to);
        Some(share.map(|share| {
            let pairs = reference.iter().zip(inputs);
            pairs.map(|(a, b)| a + share * (b - a)).collect()
        }))
    }
}
