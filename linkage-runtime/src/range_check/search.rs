//! The search through the range of one input.

use super::report::{RangeFinding, RangeFindingKind, Ranged};
use super::stretches::{Sample, Stretch, fails, lowest, stretches};

use alloc::vec::Vec;
use core::f64::consts::TAU;
use linkage_core::numeric::range::{first_failure, minimum};
use linkage_core::range_check::{AT_END, DEAD, END, ROUNDING, Slack, samples};

/// Positions of a stretch at which the search looks for the largest miss of a group.
const MISSES: usize = 180;

/// A function of all inputs: one number for each group, or the least margin and one for each group.
type OfInputs<'a> = &'a dyn Fn(&[f64]) -> Vec<f64>;

/// The range of one input.
pub(super) struct RangeSearch<'a> {
    ranged: &'a Ranged<'a>,
    input: usize,
    survey: OfInputs<'a>,
    gaps: OfInputs<'a>,
    pub(super) range: [f64; 2],
    declared: bool,
    angle: bool,
    inputs: Vec<f64>,
    /// The divisor of the slack of each group.
    scales: Vec<f64>,
    /// Inputs in order, the reference among them, and the slacks there.
    samples: Vec<(f64, Vec<f64>)>,
}

impl<'a> RangeSearch<'a> {
    pub(super) fn new(
        ranged: &'a Ranged<'a>,
        input: usize,
        (low, high): (f64, f64),
        survey: OfInputs<'a>,
        gaps: OfInputs<'a>,
    ) -> Self {
        let driven = &ranged.inputs[input];
        let mut search = Self {
            ranged,
            input,
            survey,
            gaps,
            range: [low, high],
            declared: driven.range.is_some(),
            angle: driven.unit == "rad",
            inputs: ranged.inputs.iter().map(|input| input.reference).collect(),
            scales: alloc::vec![1.0; ranged.groups.len()],
            samples: Vec::new(),
        };
        search.sample(low, driven.reference, high);
        search
    }

    fn sample(&mut self, low: f64, reference: f64, high: f64) {
        let count = samples(high - low, self.angle);
        let mut inputs = Vec::with_capacity(count + 2);
        for [from, to] in [[low, reference], [reference, high]] {
            // Casting rounds down, and converts NaN to 0.
            let steps = (count as f64 * ((to - from) / (high - low))) as usize;
            let steps = if to > from { steps.max(1) } else { 0 };
            inputs.extend((0..steps).map(|k| from + (to - from) * (k as f64 / steps as f64)));
        }
        inputs.push(high);
        self.samples = inputs.into_iter().map(|x| (x, self.raw(x))).collect();
        let at_reference = self.raw(reference);
        for (group, slack) in self.ranged.slacks.iter().enumerate() {
            let sizes = self.samples.iter().map(|(_, slacks)| slacks[group].abs());
            let largest = sizes.fold(0.0, f64::max);
            let scale = if largest > 0.0 { largest } else { 1.0 };
            self.scales[group] = match slack {
                Slack::Number | Slack::Prepared => 1.0,
                Slack::Relative => scale,
                Slack::Signed if at_reference[group] < 0.0 => -scale,
                Slack::Signed => scale,
            };
        }
        for (_, slacks) in &mut self.samples {
            for (slack, scale) in slacks.iter_mut().zip(&self.scales) {
                *slack /= scale;
            }
        }
    }

    /// The slacks of all groups as they are computed. That of a coupled group is NaN where nothing
    /// is prepared of it, else 1.
    fn raw(&mut self, x: f64) -> Vec<f64> {
        let [low, high] = self.range;
        self.inputs[self.input] = x;
        let mut slacks_there = (self.survey)(&self.inputs);
        if slacks_there.iter().any(|slack| slack.is_nan()) && !self.is_inside(x) {
            // An arc function may reach the end of its range at that of the input's, apart from
            // rounding.
            let step = END * (high - low);
            self.inputs[self.input] = x.clamp(low + step, high - step);
            slacks_there = (self.survey)(&self.inputs);
        }
        let margin = slacks_there.remove(0);
        slacks_there.truncate(self.ranged.groups.len());
        let slacks = || slacks_there.iter().zip(self.ranged.slacks);
        let closed = slacks().all(|(&slack, kind)| *kind == Slack::Prepared || slack >= -ROUNDING);
        if margin.is_nan() && (closed || slacks_there.iter().any(|slack| slack.is_nan())) {
            let first = slacks().position(|(slack, _)| slack.is_nan());
            let before = first.unwrap_or(slacks_there.len());
            let prepared = self.ranged.slacks[..before].iter();
            if let Some(group) = prepared.rev().position(|kind| *kind == Slack::Prepared) {
                slacks_there[before - 1 - group] = f64::NAN;
            }
        }
        slacks_there
    }

    fn slacks(&mut self, x: f64) -> Vec<f64> {
        let mut slacks_there = self.raw(x);
        for (slack, scale) in slacks_there.iter_mut().zip(&self.scales) {
            *slack /= scale;
        }
        slacks_there
    }

    /// Returns true if a position is so far from the ends of the range that a dead point there
    /// counts.
    fn is_inside(&self, x: f64) -> bool {
        let [low, high] = self.range;
        (x - low).min(high - x) > END * (high - low)
    }

    /// The distance of a group from its dead point: at an end of the range it may be there. `None`
    /// if a group before it does not close.
    fn level(&self, group: usize, x: f64, slacks: &[f64]) -> Option<f64> {
        let open = slacks[..group].iter().any(|&slack| fails(slack));
        let reserve = if self.is_inside(x) { DEAD } else { 0.0 };
        (!open).then(|| slacks[group] - reserve)
    }

    /// All findings, in the order of the inputs.
    pub(super) fn findings(&mut self) -> Vec<RangeFinding> {
        let mut findings: Vec<RangeFinding> = Vec::new();
        for group in 0..self.ranged.groups.len() {
            let sample = |(x, slacks): &(f64, Vec<f64>)| (*x, self.level(group, *x, slacks));
            let samples: Vec<Sample> = self.samples.iter().map(sample).collect();
            let found = stretches(samples, &mut |x| {
                let slacks = self.slacks(x);
                self.level(group, x, &slacks)
            });
            findings.extend(found.iter().map(|stretch| self.finding(group, stretch)));
        }
        if !self.declared {
            self.keep_change_points(&mut findings);
        }
        findings.sort_by(|a, b| a.from.total_cmp(&b.from));
        findings
    }

    /// Without a range, to end at a dead point is no mistake. The ends of a turn are one position.
    fn keep_change_points(&self, findings: &mut Vec<RangeFinding>) {
        let [low, high] = self.range;
        let near = |x: f64, end: f64| (x - end).abs() < AT_END * (high - low);
        let at_low: Vec<usize> = findings
            .iter()
            .filter(|finding| near(finding.from, low))
            .map(|finding| finding.group)
            .collect();
        findings.retain(|finding| {
            let again = near(finding.from, high) && at_low.contains(&finding.group);
            finding.kind == RangeFindingKind::ChangePoint && !again
        });
    }

    fn finding(&mut self, group: usize, stretch: &Stretch) -> RangeFinding {
        let range = self.range;
        let (at, least) = lowest(stretch, range, &mut |x| self.slacks(x)[group]);
        // A slack that is negative by no more than rounding touches zero.
        let miss = if least.abs() < DEAD {
            0.0
        } else {
            self.largest_miss(group, stretch)
        };
        let single = self.ranged.slacks[group] == Slack::Signed;
        let (kind, from, to) = match (stretch.finite, miss > 0.0, stretch.works) {
            (false, ..) => (RangeFindingKind::Undefined, stretch.from, stretch.to),
            (true, true, [true, true]) => (RangeFindingKind::Gap, stretch.from, stretch.to),
            (true, true, _) => (RangeFindingKind::DeadPoint, stretch.from, stretch.to),
            (true, false, _) if single => (RangeFindingKind::DeadPoint, stretch.from, stretch.from),
            (true, false, _) => (RangeFindingKind::ChangePoint, at, at),
        };
        let [from, to] = [from, to].map(|x| self.snapped(x));
        RangeFinding {
            kind,
            group,
            from,
            to,
            miss,
        }
    }

    /// Moves an input to the end of the range if the search cannot distinguish the two.
    fn snapped(&self, x: f64) -> f64 {
        let [low, high] = self.range;
        let near = |end: &f64| (x - *end).abs() < AT_END * (high - low);
        [low, high].into_iter().find(near).unwrap_or(x)
    }

    /// The largest gap of a group in a stretch; 0 if it closes there.
    fn largest_miss(&mut self, group: usize, stretch: &Stretch) -> f64 {
        let mut miss = |x: f64| {
            self.inputs[self.input] = x;
            let gap = (self.gaps)(&self.inputs)[group];
            if gap > 0.0 { -gap } else { 0.0 }
        };
        let (_, least) = minimum(stretch.from, stretch.to, MISSES, &mut miss);
        -least + 0.0
    }

    /// The stretch around the reference that works: as far as a turn to both sides, if whole turns
    /// are alike.
    pub(super) fn works(&mut self) -> [f64; 2] {
        let reference = self.ranged.inputs[self.input].reference;
        let [low, high] = if self.angle && self.ranged.repeats {
            [reference - TAU, reference + TAU]
        } else {
            self.range
        };
        [low, high].map(|end| {
            let sign = if end < reference { -1.0 } else { 1.0 };
            let length = (end - reference).abs();
            let failure = first_failure(0.0, length, 0.0, samples(length, self.angle), |along| {
                let slacks = self.slacks(reference + sign * along);
                let worst = slacks.iter().find(|&&slack| fails(slack));
                let least = |least: f64, slack: &f64| least.min(*slack);
                *worst.unwrap_or(&slacks.iter().fold(f64::INFINITY, least)) - DEAD
            });
            failure.map_or(end, |failure| reference + sign * failure.at)
        })
    }
}
