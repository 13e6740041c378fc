//! Dwells: a quantity within a band over an interval of the input.

use linkage_core::Cycle;
use std::format;
use std::string::String;
use std::vec;
use std::vec::Vec;

use super::super::DesignError;
use super::corners::{Corner, Corners};
use super::spread::ranges;
use super::{
    AuxiliaryVariable, Candidate, Chosen, Conditions, Curve, CycleObjective, Piece, PieceKey,
    Verdict,
};
use linkage_analysis::tolerance::Tolerances;
use linkage_core::format::rounded;
use linkage_runtime::{Dimensions, Parameter};

/// The goal of a dwell.
#[derive(Clone, Copy, Debug)]
pub(super) enum Claim {
    /// The length of the interval, which is to be greatest.
    Length,
    /// The band, which is to be least.
    Band,
}

/// A dwell: a quantity stays within a band over an interval of the input, of which the length is to
/// be greatest or the band least, or which is there beside another goal.
///
/// Its limits within the interval are exact roots of the derivative, and count with those places'
/// slopes; between them the quantity counts at [`SAMPLES`](Self::SAMPLES) evenly spaced places,
/// too, which show a value that might grow into a limit. The variables of its own are, in this
/// order: where the interval begins, its length, the lower bound of the band, the band.
pub struct Dwell<'a, A, const N: usize> {
    pub(super) curve: Curve<'a, A, N>,
    asked: Asked,
    /// The inputs between which it is to be, if not anywhere.
    pub(super) between: Option<[f64; 2]>,
    corners: Option<Corners<N>>,
}

/// The given sizes of a dwell; the other one is searched.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Asked {
    /// The longest one within this band.
    Longest(f64),
    /// The narrowest band over this length.
    Narrowest(f64),
    /// One of this length, within this band.
    AtLeast { length: f64, band: f64 },
}

impl Asked {
    fn length(self) -> Option<f64> {
        match self {
            Self::Longest(_) => None,
            Self::Narrowest(length) | Self::AtLeast { length, .. } => Some(length),
        }
    }

    fn band(self) -> Option<f64> {
        match self {
            Self::Narrowest(_) => None,
            Self::Longest(band) | Self::AtLeast { band, .. } => Some(band),
        }
    }
}

/// The part of the range by which an interval may move and grow in the first step, and the part of
/// the band for its bounds.
const REACH: f64 = 0.005;
const REACH_OF_BAND: f64 = 0.3;
/// An interval that is longer than its room by less than this part of it fills it: both are
/// rounded.
const ROUNDING: f64 = 1e-12;
/// An interval is at least this part of the range.
const LEAST: f64 = 1e-3;

impl<'a, A, const N: usize> Dwell<'a, A, N> {
    /// Evenly spaced places of an interval at which the quantity counts beside its limits.
    pub const SAMPLES: usize = 17;

    /// The longest interval in which the quantity changes by no more than `band`. The search begins
    /// with the longest one of the mechanism that the design begins with.
    pub fn longest(curve: Curve<'a, A, N>, band: f64) -> Self {
        Self::new(curve, Asked::Longest(band))
    }

    /// The narrowest band in which the quantity stays over an interval of this length. The search
    /// begins with the interval in which the mechanism that the design begins with changes least.
    pub fn narrowest(curve: Curve<'a, A, N>, length: f64) -> Self {
        Self::new(curve, Asked::Narrowest(length))
    }

    /// A condition: the quantity changes by no more than `band` over an interval of at least this
    /// length.
    pub fn at_least(curve: Curve<'a, A, N>, band: f64, length: f64) -> Self {
        Self::new(curve, Asked::AtLeast { length, band })
    }

    fn new(curve: Curve<'a, A, N>, asked: Asked) -> Self {
        Self {
            curve,
            asked,
            between: None,
            corners: None,
        }
    }

    /// Between these inputs, not anywhere in the range; the second one may be beyond the seam of a
    /// turn. A dwell of a length that is as long as this interval is exactly there.
    #[must_use]
    pub fn between(self, from: f64, to: f64) -> Self {
        Self {
            between: Some([from, to]),
            ..self
        }
    }

    /// For every mechanism within these tolerances, at the same interval of the input; each may
    /// have its band elsewhere, as one that is adjusted when it is built.
    ///
    /// The worst mechanisms have all dimensions at limits of their tolerances. Those that matter
    /// are found as the search goes on, and each is assembled and counts as exactly as the first
    /// one. A dimension may not be worse in the middle of its tolerance, then: so it is where
    /// effects are nearly linear over a tolerance. The mechanism with nominal dimensions counts,
    /// too, even where zones do not contain them.
    #[must_use]
    pub fn in_worst_case(self, tolerances: &Tolerances<N>) -> Self {
        Self {
            corners: Some(Corners::new(tolerances)),
            ..self
        }
    }
}

impl<M: Dimensions<N>, A, const N: usize> CycleObjective<M, A, N> for Dwell<'_, A, N> {
    fn title(&self) -> String {
        let what = match self.asked {
            Asked::Longest(band) => format!("longest dwell within {}", rounded(band)),
            Asked::Narrowest(length) => format!("narrowest band over {}", rounded(length)),
            Asked::AtLeast { length, band } => {
                format!("dwell over {} within {}", rounded(length), rounded(band))
            }
        };
        let between = self.between.map_or(String::new(), |[from, to]| {
            format!(" between {} and {}", rounded(from), rounded(to))
        });
        let tolerances = if self.corners.is_some() {
            " in the worst case"
        } else {
            ""
        };
        what + &between + tolerances
    }

    fn is_goal(&self) -> bool {
        !matches!(self.asked, Asked::AtLeast { .. })
    }

    fn reported_goal(&self, least: f64) -> f64 {
        match self.asked {
            Asked::Longest(_) => -least,
            _ => least,
        }
    }

    fn check(&self, cycle: &Cycle, _: &[Parameter], _: &[usize]) -> Vec<DesignError> {
        let objective = || CycleObjective::<M, A, N>::title(self);
        let [from, to] = self.between.unwrap_or([cycle.low, cycle.high]);
        let mut errors = Vec::new();
        let turns = cycle.turn().is_some();
        let outside = |input: &f64| !(turns || (cycle.low..=cycle.high).contains(input));
        if let Some(input) = [from, to].into_iter().find(outside) {
            errors.push(DesignError::OutOfRange {
                objective: objective(),
                input,
                low: cycle.low,
                high: cycle.high,
            });
        }
        let length = self.asked.length().unwrap_or(0.0);
        if !(length <= (to - from) * (1.0 + ROUNDING) && to - from > 0.0) {
            errors.push(DesignError::NoRoom {
                objective: objective(),
                length,
                from,
                to,
            });
        }
        errors
    }

    fn auxiliary_variables(
        &self,
        candidate: &Candidate<'_, M, A>,
    ) -> Option<Vec<AuxiliaryVariable>> {
        let motion = &candidate.motion;
        let (low, high) = motion.range;
        let width = high - low;
        let [from, length, lowest, band] = match self.asked {
            Asked::Longest(band) => self.longest_of(motion, band)?,
            Asked::Narrowest(length) | Asked::AtLeast { length, .. } => {
                self.steadiest(motion, length)?
            }
        };
        // The start may leave any part of a fixed band.
        let band = self.asked.band().unwrap_or(band);
        let variable = |start: f64, bounds: (f64, f64), reach: f64| AuxiliaryVariable {
            start,
            bounds,
            reach,
        };
        let (step, rise) = (REACH * width, REACH_OF_BAND * band);
        let [first, last] = self.between.unwrap_or([low - width, high + width]);
        let (beginnings, lengths) = match (self.asked.length(), self.between) {
            (Some(length), Some(_)) => ((first, (last - length).max(first)), (length, length)),
            (Some(length), None) => ((first, last), (length, length)),
            (None, _) => ((first, last), (LEAST * width, width)),
        };
        let bands = self
            .asked
            .band()
            .map_or((0.0, f64::INFINITY), |band| (band, band));
        Some(vec![
            variable(from, beginnings, step),
            variable(length, lengths, step),
            variable(lowest, (f64::NEG_INFINITY, f64::INFINITY), rise),
            variable(band, bands, rise),
        ])
    }

    fn evaluate(
        &self,
        candidate: &Candidate<'_, M, A>,
        chosen: Chosen<'_>,
    ) -> Option<Conditions<N>> {
        let auxiliary: [f64; 4] = chosen.auxiliary.try_into().ok()?;
        let [from, length, _, band] = auxiliary;
        let piece = |value: f64, slopes: [f64; 4]| Piece {
            key: PieceKey::Nth(0),
            value,
            parameters: [0.0; N],
            auxiliary: slopes.to_vec(),
        };
        let goal = match self.asked {
            Asked::Longest(_) => vec![piece(-length, [0.0, -1.0, 0.0, 0.0])],
            Asked::Narrowest(_) => vec![piece(band, [0.0, 0.0, 0.0, 1.0])],
            Asked::AtLeast { .. } => Vec::new(),
        };
        let mut conditions = self.nominal(&candidate.motion, auxiliary)?.to_vec();
        if let (Asked::Longest(_), Some([_, to])) = (self.asked, self.between) {
            conditions.push(vec![piece(from + length - to, [1.0, 1.0, 0.0, 0.0])]);
        }
        for corner in chosen.added {
            let assembly = Corner::from_changes(corner)?.assemble(candidate)?;
            let limits = self.limits(&candidate.motion, &assembly, [from, length])?;
            conditions.push(ranges(&limits, band));
        }
        Some(Conditions {
            goal,
            conditions,
            ..Conditions::default()
        })
    }

    /// Its speeds: the quantity itself may count whole turns.
    fn known_by(&self, candidate: &Candidate<'_, M, A>, chosen: Chosen<'_>) -> Option<Vec<f64>> {
        let (low, high) = candidate.motion.range;
        let speed = |nth: usize| {
            let input = chosen.auxiliary[0] + (high - low) * nth as f64 / Self::SAMPLES as f64;
            self.curve.jet(
                candidate.motion.assembly,
                candidate.motion.in_range(input).0,
            )[1]
        };
        Some((0..Self::SAMPLES).map(speed).collect())
    }

    /// Corners of the tolerances in which the quantity leaves the band.
    fn refine(&self, candidate: &Candidate<'_, M, A>, chosen: Chosen<'_>) -> Vec<Vec<f64>> {
        self.further(candidate, chosen)
    }

    fn verify(&self, candidate: &Candidate<'_, M, A>, chosen: Chosen<'_>) -> Option<Verdict> {
        let goal = match self.asked {
            Asked::Longest(_) => Some(Claim::Length),
            Asked::Narrowest(_) => Some(Claim::Band),
            Asked::AtLeast { .. } => None,
        };
        self.verdict(candidate, chosen, goal)
    }
}

impl<A, const N: usize> Dwell<'_, A, N> {
    /// Corners of the tolerances that leave the band, without those that were added.
    pub(super) fn further<M: Dimensions<N>>(
        &self,
        candidate: &Candidate<'_, M, A>,
        chosen: Chosen<'_>,
    ) -> Vec<Vec<f64>> {
        let (Some(corners), &[from, length, _, band]) = (&self.corners, chosen.auxiliary) else {
            return Vec::new();
        };
        let places = self.samples(&candidate.motion, [from, length]);
        let range = |assembly: &A| self.limits(&candidate.motion, assembly, [from, length]);
        corners.beyond(candidate, &places, band, chosen.added, range)
    }
}
