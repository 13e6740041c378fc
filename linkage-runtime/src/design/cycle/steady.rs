//! The verdict on a dwell: the band over its interval, from the turning points of the whole range.

use alloc::vec::Vec;

use super::corners::Corner;
use super::dwell::{Dwell, SPARE};
use super::interval::ranges;
use super::{Candidate, Check, Chosen, Verdict};
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
    /// The verdict on an interval and a band, in the mechanism and at the corners of the tolerances.
    pub(super) fn verdict<M: Dimensions<N>>(
        &self,
        candidate: &Candidate<'_, M, A>,
        chosen: Chosen<'_>,
        goal: Option<Claim>,
    ) -> Option<Verdict> {
        let [from, length, _, band]: [f64; 4] = chosen.own.try_into().ok()?;
        let motion = &candidate.motion;
        let turning = self.turning_points(motion)?;
        let [lowest, highest] = self.extent(motion, &turning, [from, length]);
        let change = Some(highest - lowest).filter(|change| change.is_finite())?;
        let size = band.max(ROUNDED * turning.stroke);
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
