//! The mechanisms at the limits of tolerances that are worst.

use core::array;
use std::vec::Vec;

use super::spread::ranges;
use super::{Candidate, Piece};
use linkage_analysis::tolerance::Tolerances;
use linkage_runtime::Dimensions;

/// The mechanisms of some tolerances.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Corners<const N: usize> {
    /// The middle of each zone, from the nominal value.
    middles: [f64; N],
    /// Half of its width.
    halves: [f64; N],
}

/// A mechanism with all dimensions at limits of their tolerances.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Corner<const N: usize> {
    /// The differences of its dimensions.
    changes: [f64; N],
}

/// New corners in a round: the worst ones; others often hold once these do.
const NEW: usize = 4;
/// Pairs of places that are followed to their worst corner.
const PAIRS: usize = 12;
/// Number of times that the signs of a corner are set by its own slopes: they settle in two or
/// three.
const TURNS: usize = 6;
/// A corner that leaves the band by less than this part of it holds: less than the part that a
/// dwell spares.
const HOLDS: f64 = 5e-7;

impl<const N: usize> Corner<N> {
    /// Builds a corner from the differences of its dimensions.
    pub(super) fn from_changes(changes: &[f64]) -> Option<Self> {
        let changes = changes.try_into().ok()?;
        Some(Self { changes })
    }

    pub(super) fn assemble<M: Dimensions<N>, A>(
        &self,
        candidate: &Candidate<'_, M, A>,
    ) -> Option<A> {
        let values = candidate.mechanism.values();
        candidate.assemble(&M::from_values(&array::from_fn(|k| {
            values[k] + self.changes[k]
        })))
    }
}

impl<const N: usize> Corners<N> {
    pub(super) fn new(tolerances: &Tolerances<N>) -> Self {
        Self {
            middles: *tolerances.middles(),
            halves: tolerances.values(),
        }
    }

    /// The corner in which a difference of two values grows most, to first order.
    fn towards(&self, slopes: &[f64; N]) -> Corner<N> {
        // A dimension without effect stays in the middle of its zone.
        let change = |k: usize| {
            let from_middle = match slopes[k] == 0.0 {
                true => 0.0,
                false => self.halves[k].copysign(slopes[k]),
            };
            self.middles[k] + from_middle
        };
        Corner {
            changes: array::from_fn(change),
        }
    }

    /// The worst corners in which the quantity leaves the band, from those that the slopes at some
    /// places point to, as differences of their dimensions; without those that count already.
    pub(super) fn beyond<M: Dimensions<N>, A>(
        &self,
        candidate: &Candidate<'_, M, A>,
        places: &[Piece<N>],
        band: f64,
        known: &[Vec<f64>],
        limits: impl Fn(&A) -> Option<[Vec<Piece<N>>; 2]>,
    ) -> Vec<Vec<f64>> {
        let mut found: Vec<(f64, Corner<N>)> = Vec::new();
        for start in self.likely(places) {
            let mut corner = start;
            for _ in 0..TURNS {
                let excess = corner.assemble(candidate).and_then(|assembly| {
                    let all = ranges(&limits(&assembly)?, band);
                    all.into_iter().max_by(|a, b| a.value.total_cmp(&b.value))
                });
                // One that does not assemble is worse than all that do.
                let value = excess.as_ref().map_or(f64::INFINITY, |piece| piece.value);
                if value > HOLDS * band
                    && !known.iter().any(|other| *other == corner.changes)
                    && !found.iter().any(|(_, other)| *other == corner)
                {
                    found.push((value, corner));
                }
                let next = excess.map_or(corner, |piece| self.towards(&piece.parameters));
                if next == corner {
                    break;
                }
                corner = next;
            }
        }
        found.sort_by(|a, b| b.0.total_cmp(&a.0));
        let worst = found.into_iter().take(NEW);
        worst.map(|(_, corner)| corner.changes.to_vec()).collect()
    }

    /// The corners in which two of some places differ most, each once.
    fn likely(&self, places: &[Piece<N>]) -> Vec<Corner<N>> {
        let mut pairs: Vec<(f64, Corner<N>)> = Vec::new();
        for high in places {
            for low in places {
                let slopes: [f64; N] = array::from_fn(|k| high.parameters[k] - low.parameters[k]);
                let corner = self.towards(&slopes);
                let parts = slopes.iter().zip(&corner.changes);
                let more: f64 = parts.map(|(slope, change)| slope * change).sum();
                pairs.push((high.value - low.value + more, corner));
            }
        }
        pairs.sort_by(|a, b| b.0.total_cmp(&a.0));
        let mut likely: Vec<Corner<N>> = Vec::new();
        for (_, corner) in pairs {
            if likely.len() < PAIRS && !likely.contains(&corner) {
                likely.push(corner);
            }
        }
        likely
    }
}
