//! Phases that can be set in steps only.

use super::PhaseError;
use super::phases::Phases;
use super::search::BestPhase;
use crate::components::Components;
use crate::cyclogram::Slot;
use alloc::vec::Vec;

/// The best of the phases that a gear can be set to.
#[derive(Clone, Debug, PartialEq)]
pub struct BestStep<const K: usize> {
    /// The number of steps, their phase, and its excess over the best phase.
    pub slot: Slot,
    /// The least distance over the cycle.
    pub distance: f64,
    /// The loss against the best phase.
    pub loss: f64,
    /// The best phase of all.
    pub best: BestPhase<K>,
}

/// An end of the range that a step misses by rounding, as a share of it, still has it.
const BESIDE: f64 = 1e-9;

impl<V, const K: usize, const A: usize, const B: usize, F, G> Phases<V, K, A, B, F, G>
where
    V: Components<K>,
    F: Fn(f64) -> [[V; 3]; A],
    G: Fn(f64) -> [[V; 3]; B],
{
    /// The best of the phases in `range` that are whole multiples of `step`, such as `TAU / 48.0`
    /// for a gear of 48 slots, and the loss against the [best](Self::best) phase of all.
    ///
    /// All steps are compared: those that cannot be better, by the same bounds, without being
    /// looked at.
    ///
    /// # Errors
    ///
    /// As [`best`](Self::best), and `Step` if there is no step in the range.
    pub fn best_step(&self, range: (f64, f64), step: f64) -> Result<BestStep<K>, PhaseError> {
        let (low, high) = range;
        let found = self.search(range)?;
        let steps = |phase: f64| phase / step;
        if !(step > 0.0 && step.is_finite() && steps(low).abs().max(steps(high).abs()) < 1e9) {
            return Err(PhaseError::Step { step, range });
        }
        let [first, last] = [steps(low), steps(high)].map(|steps| steps as i64);
        let is_in = |index: &i64| {
            let steps_in = *index as f64;
            steps_in >= steps(low) - BESIDE && steps_in <= steps(high) + BESIDE
        };
        let mut open: Vec<(f64, i64)> = (first - 1..=last + 1)
            .filter(is_in)
            .map(|index| {
                let phase = index as f64 * step;
                let next = found.probes.partition_point(|probe| probe.phase < phase);
                let beside = [next.wrapping_sub(1), next].map(|i| found.probes.get(i));
                let bounds = beside.map(|probe| {
                    probe.map_or(f64::INFINITY, |probe| {
                        probe.square_bound(phase, self.limits)
                    })
                });
                (bounds[0].min(bounds[1]), index)
            })
            .collect();
        open.sort_by(|a, b| b.0.total_cmp(&a.0));
        let mut best: Option<(f64, i64, f64)> = None;
        for (bound, index) in open {
            if best.is_some_and(|(q, ..)| bound <= q) {
                break;
            }
            let probe = self.probe(index as f64 * step)?;
            if best.is_none_or(|(q, ..)| probe.q() > q) {
                best = Some((probe.q(), index, probe.clearance.least().distance));
            }
        }
        let Some((_, index, distance)) = best else {
            return Err(PhaseError::Step { step, range });
        };
        let angle = index as f64 * step;
        Ok(BestStep {
            slot: Slot {
                step: index,
                angle,
                off: angle - found.best.phase,
            },
            distance,
            loss: found.best.distance - distance,
            best: found.best,
        })
    }
}
