//! The verdict on a dwell: the band over its interval, from the course of the whole range.

use alloc::vec::Vec;

use super::corners::Corner;
use super::dwell::{Dwell, SPARE};
use super::interval::ranges;
use super::{Candidate, Check, Chosen, Motion, Verdict};
use crate::Dimensions;

/// A band that is narrower than this part of the stroke is compared with it: values are rounded.
const ROUNDED: f64 = 1e-9;

/// The goal of a dwell.
#[derive(Clone, Copy, Debug)]
pub(super) enum Claim {
    /// The length of the interval, which is to be greatest.
    Length,
    /// The band, which is to be least.
    Band,
}

impl<A, const N: usize> Dwell<'_, A, N> {
    /// The change of the quantity over an interval, and its stroke over the range; `None` where the mechanism does not assemble.
    ///
    /// The extremes are those of the course over the whole range, and the values at both ends of the interval.
    fn change(&self, motion: &Motion<'_, A>, [from, length]: [f64; 2]) -> Option<[f64; 2]> {
        let course = self.curve.course(motion)?;
        let (low, high) = motion.range;
        let advance = self.advance(motion, motion.assembly);
        let value = |input: f64| self.jet(motion, motion.assembly, input, advance)[0];
        let inside = |at: f64| {
            let turns = if motion.closed { -2..=2 } else { 0..=0 };
            let shifted = turns.map(move |turn| at + f64::from(turn) * (high - low));
            shifted.filter(move |at| (from..=from + length).contains(at))
        };
        let points = course.position().points.iter();
        let within = points.flat_map(|point| inside(point.at));
        let values: Vec<f64> = within.chain([from, from + length]).map(value).collect();
        let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let least = values.iter().copied().fold(f64::INFINITY, f64::min);
        let finite = values.iter().all(|value| value.is_finite());
        finite.then(|| [most - least, course.position().stroke()])
    }

    /// The verdict on an interval and a band, in the mechanism and at the corners of the tolerances.
    pub(super) fn verdict<M: Dimensions<N>>(
        &self,
        candidate: &Candidate<'_, M, A>,
        chosen: Chosen<'_>,
        goal: Option<Claim>,
    ) -> Option<Verdict> {
        let [from, length, _, band]: [f64; 4] = chosen.own.try_into().ok()?;
        let motion = &candidate.motion;
        let [change, stroke] = self.change(motion, [from, length])?;
        let size = band.max(ROUNDED * stroke);
        let within = |by: f64| Check {
            by,
            size: Some(size),
        };
        let mut conditions = Vec::from([within(change - (1.0 - SPARE) * band)]);
        if let Some([first, last]) = self.between {
            conditions.extend([first - from, from + length - last].map(|by| Check {
                by,
                size: Some(last - first),
            }));
        }
        for corner in chosen.added.iter().chain(&self.further(candidate, chosen)) {
            let assembly = Corner::of(corner)?.assemble(candidate);
            let limits = assembly.and_then(|other| self.limits(motion, &other, [from, length]));
            // A corner that does not assemble has no dwell at all.
            let most = limits.map_or(f64::INFINITY, |limits| {
                let values = ranges(&limits, band).into_iter().map(|piece| piece.value);
                values.fold(f64::NEG_INFINITY, f64::max)
            });
            conditions.push(within(most));
        }
        let goal = goal.map(|goal| match goal {
            Claim::Length => -length,
            Claim::Band => band.max(change),
        });
        Some(Verdict { goal, conditions })
    }
}
