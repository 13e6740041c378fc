//! Dwells: a quantity within a band over an interval of the input.

use alloc::format;
use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;

use super::corners::{Corner, Corners};
use super::interval::ranges;
use super::{Candidate, Chosen, Conditions, Curve, CycleWish, Own, Piece, Place};
use crate::Dimensions;
use crate::tolerance::Tolerances;
use crate::words::rounded;

/// A dwell: a quantity stays within a band over an interval of the input, of which the length is to be greatest or the band
/// least.
///
/// Its limits within the interval are exact roots of the derivative, and count with those places' slopes; between them the quantity
/// counts at [`SAMPLES`](Self::SAMPLES) evenly spaced places, too, which see what might grow into a limit. The variables of its own are, in this
/// order: where the interval begins, its length, the lower bound of the band, the band.
pub struct Dwell<'a, A, const N: usize> {
    pub(super) curve: Curve<'a, A, N>,
    length: Option<f64>,
    band: Option<f64>,
    corners: Option<Corners<N>>,
}

/// Of a band so much is left to rounding and to the precision of the search: no limit may lie outside of it in the end. A start leaves twice as
/// much, so that it is a dwell even if nothing is searched.
pub(super) const SPARE: f64 = 1e-6;
/// Of the range, how far an interval may move and grow in the first step, and of the band its bounds.
const REACH: f64 = 0.005;
const REACH_OF_BAND: f64 = 0.3;
/// An interval is at least this part of the range.
const LEAST: f64 = 1e-3;

impl<'a, A, const N: usize> Dwell<'a, A, N> {
    /// Evenly spaced places of an interval at which the quantity counts beside its limits.
    pub const SAMPLES: usize = 17;

    /// The longest interval in which the quantity changes by no more than `band`. The search begins with the longest one of the mechanism
    /// that the design begins with.
    pub fn longest(curve: Curve<'a, A, N>, band: f64) -> Self {
        Self {
            curve,
            length: None,
            band: Some(band),
            corners: None,
        }
    }

    /// The narrowest band in which the quantity stays over an interval of this length. The search begins with the interval in which the
    /// mechanism that the design begins with changes least.
    pub fn narrowest(curve: Curve<'a, A, N>, length: f64) -> Self {
        Self {
            curve,
            length: Some(length),
            band: None,
            corners: None,
        }
    }

    /// For every mechanism within these tolerances, at the same interval of the input; each may have its band elsewhere, as one that is adjusted
    /// when it is built.
    ///
    /// The worst mechanisms have all dimensions at limits of their tolerances. Those that matter are found as the search goes on, and
    /// each is assembled and counts as exactly as the first one. A dimension may not be worse in the middle of its tolerance, then:
    /// so it is where effects are nearly linear over a tolerance.
    #[must_use]
    pub fn in_worst_case(self, tolerances: &Tolerances<N>) -> Self {
        Self {
            corners: Some(Corners::new(tolerances.values())),
            ..self
        }
    }
}

impl<M: Dimensions<N>, A, const N: usize> CycleWish<M, A, N> for Dwell<'_, A, N> {
    fn title(&self) -> String {
        let what = match (self.length, self.band) {
            (Some(length), _) => format!("narrowest band over {}", rounded(length)),
            (_, band) => format!("longest dwell within {}", rounded(band.unwrap_or(0.0))),
        };
        let tolerances = if self.corners.is_some() {
            " in the worst case"
        } else {
            ""
        };
        what + tolerances
    }

    fn is_goal(&self) -> bool {
        true
    }

    fn told(&self, least: f64) -> f64 {
        if self.length.is_some() { least } else { -least }
    }

    fn own(&self, candidate: &Candidate<'_, M, A>) -> Option<Vec<Own>> {
        let (low, high) = candidate.motion.range;
        let width = high - low;
        let course = self.curve.course(&candidate.motion)?;
        let [from, length, lowest, band] = match (self.length, self.band) {
            (None, Some(band)) => {
                let dwell = course.longest_dwell((1.0 - 2.0 * SPARE) * band)?;
                [
                    dwell.interval.from,
                    dwell.interval.range,
                    dwell.lowest,
                    band,
                ]
            }
            (length, _) => {
                let length = length?;
                self.steadiest(&candidate.motion, length)?
            }
        };
        let fixed = |value: f64, reach: f64| Own {
            start: value,
            bounds: (value, value),
            reach,
        };
        let free = |start: f64, bounds: (f64, f64), reach: f64| Own {
            start,
            bounds,
            reach,
        };
        let (step, rise) = (REACH * width, REACH_OF_BAND * band);
        Some(vec![
            free(from, (low - width, high + width), step),
            self.length
                .map_or(free(length, (LEAST * width, width), step), |length| {
                    fixed(length, step)
                }),
            free(lowest, (f64::NEG_INFINITY, f64::INFINITY), rise),
            self.band
                .map_or(free(band, (0.0, f64::INFINITY), rise), |band| {
                    fixed(band, rise)
                }),
        ])
    }

    fn evaluate(
        &self,
        candidate: &Candidate<'_, M, A>,
        chosen: Chosen<'_>,
    ) -> Option<Conditions<N>> {
        let own: [f64; 4] = chosen.own.try_into().ok()?;
        let [from, length, _, band] = own;
        let (value, slope) = if self.length.is_some() {
            (band, [0.0, 0.0, 0.0, 1.0])
        } else {
            (-length, [0.0, -1.0, 0.0, 0.0])
        };
        let goal = vec![Piece {
            place: Place::Nth(0),
            value,
            parameters: [0.0; N],
            own: slope.to_vec(),
        }];
        let mut conditions = self.nominal(&candidate.motion, own)?.to_vec();
        for corner in chosen.added {
            let assembly = Corner::of(corner)?.assemble(candidate)?;
            let limits = self.limits(&candidate.motion, &assembly, [from, length])?;
            conditions.push(ranges(&limits, band));
        }
        Some(Conditions { goal, conditions })
    }

    /// Its speeds: the quantity itself may count whole turns.
    fn known_by(&self, candidate: &Candidate<'_, M, A>, chosen: Chosen<'_>) -> Option<Vec<f64>> {
        let (low, high) = candidate.motion.range;
        let speed = |nth: usize| {
            let input = chosen.own[0] + (high - low) * nth as f64 / Self::SAMPLES as f64;
            self.curve.jet(
                candidate.motion.assembly,
                candidate.motion.in_range(input).0,
            )[1]
        };
        Some((0..Self::SAMPLES).map(speed).collect())
    }

    /// Corners of the tolerances in which the quantity leaves the band.
    fn refine(&self, candidate: &Candidate<'_, M, A>, chosen: Chosen<'_>) -> Vec<Vec<f64>> {
        let (Some(corners), &[from, length, _, band]) = (&self.corners, chosen.own) else {
            return Vec::new();
        };
        let places = self.samples(&candidate.motion, [from, length]);
        let range = |assembly: &A| self.limits(&candidate.motion, assembly, [from, length]);
        corners.beyond(candidate, &places, band, chosen.added, range)
    }
}
