//! The verification of results: goal and conditions are computed from the assembled mechanism,
//! whatever the search claims.
//!
//! A search sees a mechanism through the rows of its working set, each measured by the change in a
//! first step. Near a place where the mechanism ceases to exist, such as a flat triangle,
//! derivatives grow without limit, and a violation of any size becomes a small part of such a
//! change. So a verdict has sizes of its own: the band of a dwell, the limit of a figure.

use std::string::ToString;
use std::vec::Vec;

use super::super::DesignError;
use super::ended::TOLERANCE;
use super::problem::{Problem, SearchStart};
use super::{Candidate, Check, Motion, Piece, Verdict};
use linkage_runtime::Dimensions;

/// A violation that is smaller than this part of the size of its condition is none.
const VERIFIED: f64 = 1e-6;
/// A violation of the size that a search leaves is none, up to this part of the size of its
/// condition.
const LARGEST: f64 = 1e-3;
/// A claim that differs from the verdict by less than this part of both is confirmed, and returned
/// to the last digit.
const CONFIRMED: f64 = 1e-6;
/// A search leaves at most this part of the violation that a verdict allows.
const WITHIN: f64 = 0.5;
/// Values that differ by less than this part differ by rounding.
const ROUNDING: f64 = 1e-12;
/// The verdict looks for limits from this many times the intervals of the search.
const FINER: usize = 4;

/// The change of each condition of each objective in a first step.
pub(super) type Scales = Vec<Vec<f64>>;

impl<M: Dimensions<N>, A, const N: usize> Problem<'_, M, A, N> {
    /// The change of each condition in a first step from a place; `None` where the mechanism does
    /// not assemble.
    pub(super) fn scales(&self, start: &SearchStart) -> Option<Scales> {
        let x = &start.x;
        let change = |k: usize, piece: &Piece<N>| {
            let row = self.row(piece, &start.auxiliary[k], x.len());
            let parts = row.slopes.iter().zip(&start.reach);
            parts.map(|(slope, reach)| (slope * reach).abs()).sum()
        };
        let of = |candidate: &Candidate<'_, M, A>| {
            let scales = self.objectives.iter().enumerate().map(|(k, objective)| {
                let asked = objective.evaluate(candidate, start.chosen(k, x))?;
                let largest = |pieces: &Vec<Piece<N>>| {
                    let changes = pieces.iter().map(|piece| change(k, piece));
                    changes.fold(f64::MIN_POSITIVE, f64::max)
                };
                Some(asked.conditions.iter().map(largest).collect())
            });
            scales.collect()
        };
        self.tried(x, of)
    }

    /// The goal as the search makes it least, if all conditions hold.
    ///
    /// `claimed` is the goal of the search, and `scales` are those of the first mechanism and of
    /// the place where the search began.
    pub(super) fn verified(
        &self,
        start: &SearchStart,
        claimed: f64,
        scales: &[Option<&Scales>],
    ) -> Result<f64, DesignError> {
        let x = &start.x;
        let verdicts = self
            .tried(x, |candidate| self.verdicts(start, candidate))
            .ok_or_else(|| self.not_whole(x))?;
        let ends = self.scales(start);
        for (k, (objective, verdict)) in self.objectives.iter().zip(&verdicts).enumerate() {
            let change = |nth: usize| {
                let all = scales.iter().copied().chain([ends.as_ref()]).flatten();
                let changes = all.filter_map(|scales| scales[k].get(nth).copied());
                changes.reduce(f64::min).unwrap_or(0.0)
            };
            let exact = self.is_exact(start, k);
            let broken = |(nth, check): (usize, &Check)| {
                let tolerance = match check.size {
                    Some(size) if exact => VERIFIED * size,
                    Some(size) => {
                        (VERIFIED * size).max((TOLERANCE * change(nth)).min(LARGEST * size))
                    }
                    None => VERIFIED * change(nth),
                };
                let holds = check.by <= tolerance;
                (!holds).then_some(check.by)
            };
            let broken = verdict.conditions.iter().enumerate().filter_map(broken);
            if let Some(by) = broken.max_by(f64::total_cmp) {
                return Err(self.out_of_reach(start, objective.title(), by));
            }
        }
        if let Some(by) = start.limits.missed(x) {
            let objective = "relations between the parameters".to_string();
            return Err(self.out_of_reach(start, objective, by));
        }
        let goal = verdicts.iter().find_map(|verdict| verdict.goal);
        let goal = goal.filter(|goal| goal.is_finite());
        let goal = goal.ok_or_else(|| self.not_whole(x))?;
        // A claim is never better than the verdict, apart from rounding.
        let modest = claimed >= goal - ROUNDING * goal.abs();
        let near = (goal - claimed).abs() <= CONFIRMED * goal.abs().max(claimed.abs());
        let confirmed = modest && near;
        Ok(if confirmed { claimed } else { goal })
    }

    /// Returns whether the conditions of an objective must hold in full: a goal with variables of
    /// its own has others that suit the mechanism where those of a search break its conditions by
    /// as much as a search leaves. At corners of tolerances it has none.
    fn is_exact(&self, start: &SearchStart, k: usize) -> bool {
        self.objectives[k].is_goal() && !start.auxiliary[k].is_empty() && start.added[k].is_empty()
    }

    /// A violation, measured by the change in a first step, that the verdict on a goal with
    /// variables of its own allows. It matters for a band that is narrow beside the change in a
    /// first step: there a violation that is none for the search is one for the verdict.
    pub(super) fn exact_tolerance(
        &self,
        start: &SearchStart,
        scales: Option<&Scales>,
    ) -> Option<f64> {
        let verdicts = self.tried(&start.x, |candidate| self.verdicts(start, candidate))?;
        let least = |k: usize| {
            let sizes = verdicts[k].conditions.iter().filter_map(|check| check.size);
            let size = sizes.reduce(f64::min)?;
            let change = scales?[k].iter().copied().reduce(f64::max)?;
            Some(WITHIN * VERIFIED * size / change)
        };
        let objectives = (0..self.objectives.len()).filter(|&k| self.is_exact(start, k));
        objectives.filter_map(least).reduce(f64::min)
    }

    fn verdicts(
        &self,
        start: &SearchStart,
        candidate: &Candidate<'_, M, A>,
    ) -> Option<Vec<Verdict>> {
        let motion = Motion {
            positions: FINER * (candidate.motion.positions - 1) + 1,
            ..candidate.motion
        };
        let finer = Candidate::new(candidate.mechanism, motion, candidate.assemble);
        let objectives = self.objectives.iter().enumerate();
        objectives
            .map(|(k, objective)| objective.verify(&finer, start.chosen(k, &start.x)))
            .collect()
    }
}
