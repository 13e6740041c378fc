//! A quantity over the interval of a dwell.

use std::vec;
use std::vec::Vec;

use super::dwell::Dwell;
use super::spread::SPARE;
use super::{Motion, Piece, PieceKey};
use linkage_analysis::summary::{Curve, Extreme, Kind};

/// Evenly spaced positions of an interval from which its limits are searched: an interval is a part
/// of a turn.
const POSITIONS: usize = 24;

impl<A, const N: usize> Dwell<'_, A, N> {
    /// The quantity over the range, and beyond it across the seam.
    pub(super) fn jet(
        &self,
        motion: &Motion<'_, A>,
        assembly: &A,
        input: f64,
        advance: f64,
    ) -> [f64; 3] {
        let (position, turns) = motion.in_range(input);
        let [value, v, a] = self.curve.jet(assembly, position);
        [value + turns * advance, v, a]
    }

    /// The advance of the quantity over a turn.
    pub(super) fn advance(&self, motion: &Motion<'_, A>, assembly: &A) -> f64 {
        let (low, high) = motion.range;
        let at = |input: f64| self.curve.jet(assembly, input)[0];
        if motion.in_range(high + 1.0).1 > 0.0 {
            at(high) - at(low)
        } else {
            0.0
        }
    }

    /// The value at a place, with slopes; `part` says which part of the interval it is at, if it is
    /// fixed there.
    fn piece(
        &self,
        motion: &Motion<'_, A>,
        assembly: &A,
        value: f64,
        input: f64,
        part: Option<(usize, f64)>,
    ) -> Piece<N> {
        let (position, _) = motion.in_range(input);
        let speed = self.curve.jet(assembly, position)[1];
        let (key, auxiliary) = match part {
            Some((nth, part)) => (PieceKey::Nth(nth), vec![speed, part * speed, 0.0, 0.0]),
            None => (PieceKey::At(input), vec![0.0; 4]),
        };
        Piece {
            key,
            value,
            parameters: self.curve.slopes(assembly, position),
            auxiliary,
        }
    }

    /// Limits and ends of the quantity in the interval: the high ones and the low ones.
    pub(super) fn limits(
        &self,
        motion: &Motion<'_, A>,
        assembly: &A,
        [from, length]: [f64; 2],
    ) -> Option<[Vec<Piece<N>>; 2]> {
        let advance = self.advance(motion, assembly);
        let jet = |input: f64| self.jet(motion, assembly, input, advance);
        let course = Curve::new((from, from + length), POSITIONS, jet).ok()?;
        if course.has_gaps() {
            return None;
        }
        let of = |kind: Kind| {
            let points = course
                .position()
                .points
                .iter()
                .filter(|point| point.kind == kind);
            let piece = |point: &Extreme| {
                let last = usize::from(point.at > from);
                let part = point
                    .end
                    .then_some((last * (Self::SAMPLES - 1), last as f64));
                self.piece(motion, assembly, point.value, point.at, part)
            };
            points.map(piece).collect()
        };
        Some([of(Kind::High), of(Kind::Low)])
    }

    pub(super) fn samples(
        &self,
        motion: &Motion<'_, A>,
        [from, length]: [f64; 2],
    ) -> Vec<Piece<N>> {
        let advance = self.advance(motion, motion.assembly);
        let sample = |nth: usize| {
            let part = nth as f64 / (Self::SAMPLES - 1) as f64;
            let input = from + part * length;
            let [value, ..] = self.jet(motion, motion.assembly, input, advance);
            self.piece(motion, motion.assembly, value, input, Some((nth, part)))
        };
        (0..Self::SAMPLES).map(sample).collect()
    }

    /// In the nominal mechanism the bounds of the band are variables: returns the amounts by which
    /// the quantity leaves them.
    pub(super) fn nominal(
        &self,
        motion: &Motion<'_, A>,
        auxiliary: [f64; 4],
    ) -> Option<[Vec<Piece<N>>; 2]> {
        let [from, length, low, band] = auxiliary;
        let [mut highs, mut lows] = self.limits(motion, motion.assembly, [from, length])?;
        let inside = |piece: &Piece<N>| matches!(piece.key, PieceKey::At(_));
        highs.retain(inside);
        lows.retain(inside);
        let samples = self.samples(motion, [from, length]);
        let above = |piece: &Piece<N>| {
            let mut above = piece.times(1.0, -low - (1.0 - SPARE) * band);
            above.auxiliary[2] = -1.0;
            above.auxiliary[3] = SPARE - 1.0;
            above
        };
        let below = |piece: &Piece<N>| {
            let mut below = piece.times(-1.0, low);
            below.auxiliary[2] = 1.0;
            below
        };
        Some([
            highs.iter().chain(&samples).map(above).collect(),
            lows.iter().chain(&samples).map(below).collect(),
        ])
    }

    /// The longest dwell within a band, and the spared part of the band: where it begins, its
    /// length, its lowest value, the band.
    pub(super) fn longest_of(&self, motion: &Motion<'_, A>, band: f64) -> Option<[f64; 4]> {
        let spared = (1.0 - 2.0 * SPARE) * band;
        let dwell = match self.between {
            None => self.curve.course(motion)?.longest_dwell(spared)?,
            Some([from, to]) => {
                let advance = self.advance(motion, motion.assembly);
                let jet = |input: f64| self.jet(motion, motion.assembly, input, advance);
                let course = Curve::new((from, to), motion.positions, jet).ok()?;
                course.longest_dwell(spared)?
            }
        };
        let interval = dwell.interval;
        Some([interval.from, interval.range, dwell.lowest, band])
    }
}
