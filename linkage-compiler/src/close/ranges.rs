//! Running through the declared ranges on numbers.

use linkage_runtime::numeric::range::{Failure, first_failure, minimum};

use crate::algebra::Nominal;
use crate::formulate::Formulation;
use crate::model::Dimension;

use super::Reference;

/// Samples for each turn of an input angle (or for a whole range of lengths); what lies between is found by searching for
/// dips.
const SAMPLES: f64 = 180.0;

/// A slack this small inside a range is a dead point: beyond it the mechanism may run on in its mirror image, even where
/// the slack only touches zero (a parallelogram stretched out). The search takes -1e-12 for rounding.
const DEAD: f64 = 2e-12;

/// The share of a range at its ends where a dead point is allowed: a range may end at one.
const END: f64 = 1e-9;

/// A slack that is negative by less is 0 but for rounding.
const ROUNDING: f64 = 1e-12;

/// Positions of a grid over several inputs.
pub(super) const GRID: usize = 2000;

/// A position in a range that cannot be assembled.
pub(super) struct Broken {
    pub(super) inputs: Vec<f64>,
    /// The group that comes apart there.
    pub(super) group: usize,
    /// False if what is known of the group is no finite number there; else it is at a dead point.
    pub(super) finite: bool,
}

/// The mechanism over its ranges.
pub(super) struct Ranges<'a, 'm> {
    pub(super) formulation: &'a Formulation<'m>,
    pub(super) nominal: &'a Nominal,
    pub(super) reference: &'a mut Reference,
    pub(super) values: Vec<f64>,
}

impl Ranges<'_, '_> {
    /// The smallest slack of all groups at given inputs, and its group; positive where the mechanism works.
    pub(super) fn slack(&mut self, inputs: &[f64]) -> (f64, usize) {
        let machine = &self.reference.machine;
        machine.run(&mut self.values, inputs);
        let mut worst = (f64::INFINITY, 0);
        for (group, stage) in machine.closing.groups.iter().enumerate() {
            let slack = self.reference.scales[group] * machine.output(&self.values, stage.slack);
            if slack.is_nan() {
                // A group before this one has come apart; that one counts.
                return if worst.0 <= 0.0 {
                    worst
                } else {
                    (f64::NAN, group)
                };
            }
            if slack < worst.0 {
                worst = (slack, group);
            }
        }
        worst
    }

    /// Where the one input with a range meets a dead point, and the group that does.
    pub(super) fn first_failure(&mut self, input: usize, dimension: Dimension) -> Option<Broken> {
        let (low, high) = self.nominal.ranges[input]?;
        let turns = (high - low) / std::f64::consts::TAU;
        let samples = match dimension.half_lengths {
            0 => (SAMPLES * turns).clamp(64.0, 4000.0),
            _ => SAMPLES,
        };
        let mut inputs = self.nominal.inputs.clone();
        let start = inputs[input];
        let step = (high - low) * END;
        let failure = first_failure(low, high, start, samples as usize, |x| {
            inputs[input] = x;
            let inside = (x - low).min(high - x) > END * (high - low);
            let (slack, _) = self.slack(&inputs);
            if slack.is_nan() && !inside {
                // An arc function may reach the end of its range at that of the input's, but for rounding.
                inputs[input] = x.clamp(low + step, high - step);
                return self.slack(&inputs).0;
            }
            slack - if inside { DEAD } else { 0.0 }
        })?;
        inputs[input] = failure.at + if failure.above { step } else { -step };
        let (slack, group) = self.slack(&inputs);
        inputs[input] = self.dead_point(input, failure);
        Some(Broken {
            inputs,
            group: group.min(self.formulation.groups.len() - 1),
            finite: !slack.is_nan(),
        })
    }

    /// The dead point behind a failure: the end of the range where the slack rises slowly from there, the place where it
    /// touches zero and returns, else the failure itself.
    fn dead_point(&mut self, input: usize, failure: Failure) -> f64 {
        let (low, high) = self.nominal.ranges[input].unwrap_or((failure.at, failure.at));
        let near = |end: &f64| (failure.at - *end).abs() < 1e-6 * (high - low);
        if let Some(end) = [low, high].into_iter().find(near) {
            return end;
        }
        let reach = 1e-4 * (high - low);
        let (from, to) = match failure.above {
            true => (failure.at, (failure.at + reach).min(high)),
            false => ((failure.at - reach).max(low), failure.at),
        };
        let mut inputs = self.nominal.inputs.clone();
        let (lowest, slack) = minimum(from, to, 8, |x| {
            inputs[input] = x;
            self.slack(&inputs).0
        });
        if slack.abs() < DEAD {
            lowest
        } else {
            failure.at
        }
    }

    /// The first position of a grid over several inputs that cannot be assembled.
    pub(super) fn grid_failure(&mut self, declared: &[usize]) -> Option<Broken> {
        let grid = Grid::new(self.nominal, declared);
        (0..grid.count).find_map(|position| {
            let inputs = grid.inputs(self.nominal, position);
            let (slack, group) = self.slack(&inputs);
            let finite = !slack.is_nan();
            let broken = Broken {
                inputs,
                group,
                finite,
            };
            (!finite || slack < -ROUNDING).then_some(broken)
        })
    }
}

/// A grid over the ranges of several inputs, of bounded size.
pub(super) struct Grid {
    declared: Vec<usize>,
    side: usize,
    pub(super) count: usize,
}

impl Grid {
    pub(super) fn new(nominal: &Nominal, declared: &[usize]) -> Self {
        let declared: Vec<usize> = declared
            .iter()
            .copied()
            .filter(|&k| nominal.ranges[k].is_some())
            .collect();
        let side = (GRID as f64)
            .powf(1.0 / declared.len().max(1) as f64)
            .floor()
            .max(2.0) as usize;
        let all = side.checked_pow(declared.len() as u32).unwrap_or(GRID);
        Self {
            declared,
            side,
            count: all.min(GRID),
        }
    }

    /// The inputs at a position; the first input runs fastest.
    pub(super) fn inputs(&self, nominal: &Nominal, position: usize) -> Vec<f64> {
        let mut inputs = nominal.inputs.clone();
        let mut rest = position;
        for &input in &self.declared {
            if let Some((low, high)) = nominal.ranges[input] {
                let share = (rest % self.side) as f64 / (self.side - 1) as f64;
                inputs[input] = low + share * (high - low);
            }
            rest /= self.side;
        }
        inputs
    }

    /// A neighbour of a position with a smaller number; `None` for the first position.
    pub(super) fn before(&self, position: usize) -> Option<usize> {
        let mut stride = 1;
        for _ in &self.declared {
            if !(position / stride).is_multiple_of(self.side) {
                return Some(position - stride);
            }
            stride *= self.side;
        }
        None
    }
}
