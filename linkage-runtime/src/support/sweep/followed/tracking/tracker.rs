//! One mechanism on its way.

use super::groups::{Groups, StateSpan};
use super::history::ReachedPoints;
use super::slots::Lane;
use crate::support::CoupledGroup;
use crate::support::settle::{scaled, scales};
use linkage_core::Scalar;
use linkage_core::certificate::{ALLOWED_CONTRACTION, CORRECTIONS, FIRST_CORRECTION};

/// Distance, as a part of the path, of the point that shows the change of the states.
const BESIDE: f64 = 1.0 / 1024.0;

/// Shortest step: with shorter ones the path is blocked, or next to its end.
const SHORTEST: f64 = 1e-4;

/// The length of a step is chosen so that the first correction will be about this part of the
/// largest one.
const WANTED: f64 = 0.5 * FIRST_CORRECTION;

/// Limits of the change of the next step's length.
const SHORTER: f64 = 1.0 / 8.0;
const LONGER: f64 = 4.0;

/// A step goes no nearer to a dead point that seems to be ahead than by this part of the distance.
const TOWARDS_END: f64 = 0.9;

/// States are extrapolated by no more, in radians or scaled lengths: far less than the distance of
/// another assembly.
const AHEAD: f64 = 0.25;

/// Largest expected correction that is not made: the kernel corrects the rest.
const SETTLED: f64 = 1e-4;

#[derive(Clone, Copy, Debug, PartialEq)]
enum Stage {
    /// The group that is corrected, by its place among those that are followed.
    Group(usize),
    Arrived,
    Blocked,
}

/// The verdict on a correction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Verdict {
    /// Too large, or on another assembly.
    Unsound,
    /// No mechanism has these dimensions.
    Impossible,
    Closer,
    /// The next one would hardly change anything.
    Settled,
}

/// A mechanism on its way; the place that it tries is in its slot.
pub(super) struct Tracker<const R: usize> {
    number: usize,
    history: ReachedPoints<R>,
    /// The place that is tried, and the step to it.
    share: f64,
    length: f64,
    stage: Stage,
    /// True while it evaluates a point next to its only one.
    looks: bool,
    /// The number of the scale of lengths, and whether the step has changed one.
    scale: usize,
    rescaled: bool,
    /// The last correction, the largest one now, how many there were, and the largest first one of
    /// the step.
    last: f64,
    allowed: f64,
    corrections: usize,
    first: f64,
    /// Before the last correction.
    determinant: f64,
}

impl<const R: usize> Tracker<R> {
    /// A tracker without a row.
    pub(super) fn new() -> Self {
        Self {
            number: 0,
            history: ReachedPoints::new(),
            share: 0.0,
            length: 0.0,
            stage: Stage::Blocked,
            looks: false,
            scale: 0,
            rescaled: false,
            last: FIRST_CORRECTION,
            allowed: FIRST_CORRECTION,
            corrections: 0,
            first: 0.0,
            determinant: 0.0,
        }
    }

    /// Begins with the states that `row` has after the wanted dimensions; the slot has
    /// that row.
    pub(super) fn begin(
        &mut self,
        number: usize,
        row: &[f64; R],
        groups: &Groups,
        lane: &mut Lane<'_, R>,
    ) {
        self.number = number;
        self.stage = Stage::Blocked;
        self.history.begin(row);
        if groups.have(row) {
            self.probe(lane);
        }
    }

    /// Returns true if it waits for a correction of the group with this number among those that are
    /// followed.
    pub(super) fn wants(&self, at: usize) -> bool {
        self.stage == Stage::Group(at)
    }

    /// Returns true if it has come as far as it can; its row then has the result.
    pub(super) fn leave(&self, groups: &Groups, rows: &mut [[f64; R]]) -> bool {
        let arrived = match self.stage {
            Stage::Group(_) => return false,
            Stage::Arrived => true,
            Stage::Blocked => false,
        };
        let row = &mut rows[self.number];
        for &k in &groups.numbers {
            row[k] = if arrived { self.here()[k] } else { f64::NAN };
        }
        true
    }

    /// The states of the last place.
    fn here(&self) -> &[f64; R] {
        self.history.here()
    }

    /// Finds how states change where it is, by a correction a little further on.
    fn probe(&mut self, lane: &mut Lane<'_, R>) {
        self.looks = true;
        self.share = (self.history.share() + BESIDE).min(1.0);
        lane.go(self.share);
        self.try_group(0);
    }

    /// Begins a step of about this length, or gives up.
    fn set_out(&mut self, length: f64, groups: &Groups, lane: &mut Lane<'_, R>) {
        let here = self.history.share();
        let end = self.history.end(groups);
        let left = 1.0 - here;
        let mut length = length.min(left).min(TOWARDS_END * (end - here));
        loop {
            if length < SHORTEST.min(left) || length.is_nan() {
                self.stage = Stage::Blocked;
                return;
            }
            self.share = if length < left { here + length } else { 1.0 };
            let outlook = self.history.outlook(self.share, end);
            let mut moved = 0.0_f64;
            for &k in &groups.states {
                let ahead = self.history.ahead(&outlook, k);
                moved = moved.max((ahead - self.here()[k]).abs());
                lane.set(k, ahead);
            }
            if moved <= AHEAD {
                break;
            }
            length *= (AHEAD / moved).clamp(SHORTER, 1.0 - SHORTER);
        }
        self.length = length;
        (self.first, self.rescaled) = (0.0, false);
        lane.go(self.share);
        self.try_group(0);
    }

    fn try_group(&mut self, group: usize) {
        self.stage = Stage::Group(group);
        self.scale = 0;
        (self.last, self.allowed, self.corrections) = (FIRST_CORRECTION, FIRST_CORRECTION, 0);
    }

    /// Judges a correction of this size, which begins with that determinant.
    pub(super) fn judge(&mut self, span: StateSpan, size: f64, determinant: f64) -> Verdict {
        if self.corrections == 0 {
            self.first = self.first.max(size);
        }
        let sound = size <= self.allowed
            && determinant * self.here()[span.floor()] > 0.0
            && self.corrections < CORRECTIONS;
        self.determinant = determinant;
        if !sound {
            // States are finite, and have no root in the equations of their group.
            return if determinant.is_nan() {
                Verdict::Impossible
            } else {
                Verdict::Unsound
            };
        }
        let next = size * (size / self.last);
        self.corrections += 1;
        (self.last, self.allowed) = (size, ALLOWED_CONTRACTION * size);
        if next <= SETTLED || self.looks {
            Verdict::Settled
        } else {
            Verdict::Closer
        }
    }

    /// Goes on after a correction of the group with this place among those that are followed.
    pub(super) fn go_on(
        &mut self,
        verdict: Verdict,
        groups: &Groups,
        at: usize,
        group: &CoupledGroup,
        lane: &mut Lane<'_, R>,
    ) {
        match verdict {
            Verdict::Closer => {}
            // Before the first group nothing depends on a state that another place would mend.
            Verdict::Impossible if at == 0 => self.stage = Stage::Blocked,
            Verdict::Impossible | Verdict::Unsound => self.refuse(groups, at, group, lane),
            Verdict::Settled => {
                self.rescaled |= self.scale > 0;
                lane.set(groups.spans[at].floor(), 0.5 * self.determinant);
                if at + 1 < groups.spans.len() {
                    self.try_group(at + 1)
                } else {
                    self.arrive(groups, lane)
                }
            }
        }
    }

    /// Goes on from where a step has led.
    fn arrive(&mut self, groups: &Groups, lane: &mut Lane<'_, R>) {
        if self.looks {
            self.history.add_beside(self.share, groups, lane);
            self.looks = false;
            return self.set_out(1.0, groups, lane);
        }
        self.history.add(self.share, groups, lane);
        if self.share >= 1.0 {
            self.stage = Stage::Arrived;
            return;
        }
        if self.rescaled {
            return self.probe(lane);
        }
        let longer = Scalar::sqrt(WANTED / self.first).clamp(SHORTER, LONGER);
        self.set_out(longer * self.length, groups, lane);
    }

    /// Tries another scale of lengths, or a shorter step.
    fn refuse(&mut self, groups: &Groups, at: usize, group: &CoupledGroup, lane: &mut Lane<'_, R>) {
        if self.looks {
            self.looks = false;
            return self.set_out(1.0, groups, lane);
        }
        let scale = self.scale + 1;
        if let Some(&factor) = scales(group.variables).get(scale) {
            self.try_group(at);
            self.scale = scale;
            let state = groups.spans[at].state();
            let other = scaled(group.variables, &self.here()[state.clone()], factor);
            for (k, value) in state.zip(other) {
                lane.set(k, value);
            }
            return;
        }
        let shorter = Scalar::sqrt(WANTED / self.first);
        let shorter = if shorter > SHORTER {
            shorter.min(0.5)
        } else {
            SHORTER
        };
        self.set_out(shorter * self.length, groups, lane);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLACE: StateSpan = StateSpan {
        number: 0,
        first: 0,
        size: 1,
    };

    /// At a place with a positive determinant, where a step has been predicted.
    fn predicted() -> Tracker<2> {
        let mut tracker = Tracker::new();
        tracker.history.begin(&[0.3, 0.5]);
        tracker.try_group(0);
        tracker
    }

    #[test]
    fn a_first_correction_that_may_lead_to_another_assembly_is_refused() {
        assert_eq!(predicted().judge(PLACE, 0.04, 0.5), Verdict::Closer);
        assert_eq!(predicted().judge(PLACE, 0.06, 0.5), Verdict::Unsound);
    }

    #[test]
    fn corrections_that_do_not_shrink_fast_are_refused() {
        for (second, verdict) in [(0.008, Verdict::Closer), (0.012, Verdict::Unsound)] {
            let mut tracker = predicted();
            assert_eq!(tracker.judge(PLACE, 0.04, 0.5), Verdict::Closer);
            assert_eq!(tracker.judge(PLACE, second, 0.5), verdict);
        }
    }

    #[test]
    fn the_assembly_on_the_other_side_of_a_dead_point_is_refused() {
        for determinant in [-0.5, -1e-9, 0.0] {
            assert_eq!(
                predicted().judge(PLACE, 1e-6, determinant),
                Verdict::Unsound
            );
        }
        assert_eq!(predicted().judge(PLACE, 1e-6, 1e-9), Verdict::Settled);
    }
}
