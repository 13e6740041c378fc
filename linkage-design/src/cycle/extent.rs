//! The extent of a quantity over intervals, from its turning points over the whole range, and the
//! verdict on the band of a dwell.

use std::vec;
use std::vec::Vec;

use super::corners::Corner;
use super::dwell::{Claim, Dwell};
use super::spread::SPARE;
use super::spread::ranges;
use super::{Candidate, Check, Chosen, Motion, Verdict};
use linkage_analysis::summary::minimise;
use linkage_runtime::Dimensions;

/// A cell between two turning points is searched from at least this many beginnings.
const BEGINNINGS: usize = 5;

/// A band that is narrower than this part of the stroke is compared with it: values are rounded.
const ROUNDED: f64 = 1e-9;

/// The turning points of a quantity, by which its extent over any interval is known.
pub(super) struct TurningPoints {
    /// Input and value in order of the input, over the range and, if that is a turn, over two turns
    /// on either side.
    points: Vec<[f64; 2]>,
    advance: f64,
    /// The change over the whole range.
    pub(super) stroke: f64,
}

impl<A, const N: usize> Dwell<'_, A, N> {
    /// The turning points over the range; `None` where the mechanism does not assemble.
    pub(super) fn turning_points(&self, motion: &Motion<'_, A>) -> Option<TurningPoints> {
        let course = self.curve.course(motion)?;
        let (low, high) = motion.range;
        let advance = self.advance(motion, motion.assembly);
        let turns = if motion.closed { -2..=2 } else { 0..=0 };
        let shifted = turns.flat_map(|turn| {
            let turn = f64::from(turn);
            let points = course.position().points.iter();
            points.map(move |point| [point.at + turn * (high - low), point.value + turn * advance])
        });
        Some(TurningPoints {
            points: shifted.collect(),
            advance,
            stroke: course.position().stroke(),
        })
    }

    /// The lowest and the highest value over an interval.
    pub(super) fn extent(
        &self,
        motion: &Motion<'_, A>,
        turning: &TurningPoints,
        [from, length]: [f64; 2],
    ) -> [f64; 2] {
        let end = |input: f64| self.jet(motion, motion.assembly, input, turning.advance)[0];
        let ends = [end(from), end(from + length)];
        if ends.iter().any(|value| value.is_nan()) {
            return [f64::NAN; 2];
        }
        let points = turning.points.iter();
        let inside = points.filter(|[at, _]| (from..=from + length).contains(at));
        let values = inside.map(|[_, value]| *value).chain(ends);
        values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
            [low.min(value), high.max(value)]
        })
    }

    /// The interval of a length in which the quantity changes least: where it begins, its length,
    /// its lowest value, and a band that spares as much as a start.
    ///
    /// Between two beginnings at which one of its ends passes a turning point the values at both
    /// ends are monotone, and the extent has few hollows. So each of these cells is searched by
    /// itself: a grid over all beginnings misses a hollow between two of its positions, and with it
    /// a start that is better than all results.
    pub(super) fn steadiest(&self, motion: &Motion<'_, A>, length: f64) -> Option<[f64; 4]> {
        let turning = self.turning_points(motion)?;
        let (low, high) = motion.range;
        let [first, last] = match self.between {
            Some([from, to]) => [from, to - length],
            None if motion.closed => [low, high],
            None => [low, high - length],
        };
        let change = |from: f64| {
            let [lowest, highest] = self.extent(motion, &turning, [from, length]);
            highest - lowest
        };
        let points = turning.points.iter();
        let passed = points.flat_map(|[at, _]| [*at, at - length]);
        let inside = passed.filter(|from| first < *from && *from < last);
        // An interval as long as its room has one beginning.
        let mut borders: Vec<f64> = vec![first, last.max(first)];
        borders.extend(inside);
        borders.sort_by(f64::total_cmp);
        let cells = borders.windows(2).filter_map(|ends| {
            let part = (ends[1] - ends[0]) / (high - low);
            let beginnings = (part * motion.positions as f64) as usize + BEGINNINGS;
            let found = minimise((ends[0], ends[1]), beginnings, change).ok()?;
            Some([found.at, found.value])
        });
        let alone = [first, change(first)];
        let all = core::iter::once(alone).chain(cells);
        let steady = all.filter(|[_, change]| change.is_finite());
        let [from, change] = steady.min_by(|a, b| a[1].total_cmp(&b[1]))?;
        let [lowest, _] = self.extent(motion, &turning, [from, length]);
        Some([from, length, lowest, change / (1.0 - 2.0 * SPARE)])
    }

    /// The verdict on an interval and a band, in the mechanism and at the corners of the
    /// tolerances.
    pub(super) fn verdict<M: Dimensions<N>>(
        &self,
        candidate: &Candidate<'_, M, A>,
        chosen: Chosen<'_>,
        goal: Option<Claim>,
    ) -> Option<Verdict> {
        let [from, length, _, band]: [f64; 4] = chosen.auxiliary.try_into().ok()?;
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
            let assembly = Corner::from_changes(corner)?.assemble(candidate);
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
