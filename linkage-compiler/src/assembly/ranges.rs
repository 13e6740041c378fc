//! Running through the declared ranges on numbers.

use std::f64::consts::PI;

use linkage_core::numeric::range::{Failure, first_failure, minimum};
use linkage_core::range_check::{AT_END, DEAD, END, FOUND, SAMPLES, samples};

use crate::algebra::Nominal;
use crate::model::Dimension;
use crate::solve::Formulation;

use crate::machine::{Reference, StagedProgram};

/// At this distance from a change point, in radians, the slack is positive on both sides.
const BESIDE: f64 = 1e-3;

/// Positions of a grid over several inputs.
pub(super) const GRID: usize = 2000;

/// Positions at which it is looked how far a group misses beyond a dead point.
const MISSES: usize = 720;

/// A position in a range that cannot be assembled.
pub(super) struct Broken {
    pub(super) inputs: Vec<f64>,
    /// The group that comes apart there.
    pub(super) group: usize,
    /// False if a quantity of the group is no finite number there; else the group is at a dead
    /// point.
    pub(super) finite: bool,
}

/// The dead point that the one input with a range meets.
pub(super) struct Break {
    pub(super) input: usize,
    /// The dead point.
    pub(super) dead_point: Broken,
    /// True if the mechanism fails above that value; otherwise it fails below.
    above: bool,
}

/// The mechanism over its ranges.
pub(super) struct Ranges<'a, 'm> {
    pub(super) formulation: &'a Formulation<'m>,
    pub(super) nominal: &'a Nominal,
    pub(super) reference: &'a mut Reference,
    /// The whole program of the machine.
    pub(super) program: StagedProgram,
}

impl Ranges<'_, '_> {
    /// Returns the smallest slack of all groups at given inputs, and its group; positive if the
    /// mechanism works.
    pub(super) fn slack(&mut self, inputs: &[f64]) -> (f64, usize) {
        let machine = &self.reference.machine;
        machine.run_staged(&mut self.program, inputs);
        let mut worst = (f64::INFINITY, 0);
        for (group, stage) in machine.closure.groups.iter().enumerate() {
            let slack = self.reference.scales[group] * self.program.output(stage.slack);
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

    /// Returns the first dead point that the one input with a range meets.
    pub(super) fn first_failure(&mut self, input: usize, dimension: Dimension) -> Option<Break> {
        let (low, high) = self.nominal.ranges[input]?;
        let mut inputs = self.nominal.inputs.clone();
        let start = inputs[input];
        let step = (high - low) * END;
        let samples = samples(high - low, dimension.half_lengths == 0);
        let failure = first_failure(low, high, start, samples, |x| {
            inputs[input] = x;
            let inside = (x - low).min(high - x) > END * (high - low);
            let (slack, _) = self.slack(&inputs);
            if slack.is_nan() && !inside {
                // Except for rounding, an arc function may reach the end of its range at that of
                // the input's.
                inputs[input] = x.clamp(low + step, high - step);
                return self.slack(&inputs).0;
            }
            slack - if inside { DEAD } else { 0.0 }
        })?;
        inputs[input] = failure.at + if failure.above { step } else { -step };
        let (slack, group) = self.slack(&inputs);
        inputs[input] = self.dead_point(input, failure);
        Some(Break {
            input,
            dead_point: Broken {
                inputs,
                group: group.min(self.formulation.groups.len() - 1),
                finite: !slack.is_nan(),
            },
            above: failure.above,
        })
    }

    /// Returns the limit of the motion from the reference towards `end`: the first dead point, or
    /// that end.
    pub(super) fn reach(&mut self, input: usize, dimension: Dimension, end: f64) -> f64 {
        let mut inputs = self.nominal.inputs.clone();
        let start = inputs[input];
        let sign = (end - start).signum();
        let length = (end - start).abs();
        let samples = samples(length, dimension.half_lengths == 0);
        let failure = first_failure(0.0, length, 0.0, samples, |along| {
            inputs[input] = start + sign * along;
            self.slack(&inputs).0 - DEAD
        });
        failure.map_or(end, |failure| start + sign * failure.at)
    }

    /// Returns the largest distance by which a group misses between its dead point and the next
    /// position at which it closes, or the end of the range; 0 if it only touches its dead point.
    pub(super) fn largest_miss(&mut self, at: &Break) -> f64 {
        let from = at.dead_point.inputs[at.input];
        let (low, high) = self.nominal.ranges[at.input].unwrap_or((from, from));
        let end = if at.above { high } else { low };
        let mut inputs = at.dead_point.inputs.clone();
        let mut miss = |ranges: &mut Self, share: f64| {
            inputs[at.input] = from + (end - from) * share;
            let machine = &ranges.reference.machine;
            machine.run_staged(&mut ranges.program, &inputs);
            let gap = machine.closure.groups[at.dead_point.group].gap;
            ranges.program.output(gap)
        };
        let step = 1.0 / MISSES as f64;
        let mut worst = (0.0, 0.0);
        for share in (1..=MISSES).map(|k| k as f64 * step) {
            let gap = miss(self, share);
            // It closes again, or a group before it has come apart.
            if gap.is_nan() || gap == 0.0 {
                break;
            }
            if gap > worst.1 {
                worst = (share, gap);
            }
        }
        if worst.1 == 0.0 {
            return 0.0;
        }
        let (low, high) = (worst.0 - step, (worst.0 + step).min(1.0));
        let (_, best) = minimum(low, high, 8, |share| -miss(self, share));
        worst.1.max(-best)
    }

    /// Returns the first dead point that the slack touches and leaves again while an input without
    /// a range turns once from its reference: a change point, from which the mechanism can go on in
    /// its mirror image.
    pub(super) fn first_change_point(&mut self, input: usize) -> Option<Broken> {
        let start = self.nominal.inputs[input];
        let (low, high) = (start - PI, start + PI);
        let mut inputs = self.nominal.inputs.clone();
        let mut slack = |ranges: &mut Self, x: f64| {
            inputs[input] = x;
            ranges.slack(&inputs)
        };
        let failure = first_failure(low, high, start, SAMPLES as usize, |x| {
            slack(self, x).0 - DEAD
        })?;
        let away = if failure.above { BESIDE } else { -BESIDE };
        let beside = |x: f64| (x - BESIDE, x + BESIDE);
        let (from, to) = beside(failure.at);
        let (at, least) = minimum(from, to, 8, |x| slack(self, x).0);
        let (_, group) = slack(self, at);
        let touches = least.abs() < DEAD && slack(self, at + away).0 > 0.0;
        inputs[input] = (at / FOUND).round() * FOUND;
        touches.then_some(Broken {
            inputs,
            group: group.min(self.formulation.groups.len() - 1),
            finite: true,
        })
    }

    /// Returns the dead point of a failure: the end of the range if the slack rises slowly from
    /// there, the value at which it touches zero and returns, else the failure itself.
    fn dead_point(&mut self, input: usize, failure: Failure) -> f64 {
        let (low, high) = self.nominal.ranges[input].unwrap_or((failure.at, failure.at));
        let near = |end: &f64| (failure.at - *end).abs() < AT_END * (high - low);
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
