//! The phase at which the least distance is largest.
//!
//! At each phase the least distance is the smallest of some minima over the cycle, each of them
//! smooth. It is largest where the slope of one of them is zero, where two of them are equal and
//! have slopes of different signs, or at an end of the phases. Parabolas at the known phases bound
//! it between them. Intervals that might contain a larger one are divided until none is left.

use super::PhaseError;
use super::nearest::Nearest;
use super::phases::Phases;
use super::probe::Probe;
use crate::components::Components;
use alloc::vec::Vec;
use linkage_core::math::double::sqrt;

/// The phase at which the least distance of two members is largest.
#[derive(Clone, Debug, PartialEq)]
pub struct BestPhase<const K: usize> {
    /// The lead of the second member.
    pub phase: f64,
    /// The least distance over the cycle.
    pub distance: f64,
    /// The reason for the optimum.
    pub optimum: Optimum,
    /// The places with this distance: one, or several equal ones.
    pub contacts: Vec<Contact<K>>,
    /// No phase of the range has a larger least distance than this: at most a thousandth more than
    /// `distance`, or, if that is more, a two-hundredth of the way of the second member over a
    /// radian at its fastest.
    pub bound: f64,
    /// The number of phases that were evaluated.
    pub probes: usize,
}

/// The reasons for a local optimum of the least distance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Optimum {
    /// The distance is stationary there.
    Smooth,
    /// Two places are equally near, and a gain at one is a loss at the other.
    Equal,
    /// It is at an end of the phases that were requested.
    End,
}

/// A place of the cycle where the members are nearest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact<const K: usize> {
    /// The place.
    pub nearest: Nearest<K>,
    /// The derivative of its distance by the phase.
    pub slope: f64,
}

/// The phases that have been evaluated.
pub(super) struct PhaseSearch<const K: usize> {
    /// In order of their phases.
    pub(super) probes: Vec<Probe<K>>,
    pub(super) best: BestPhase<K>,
}

/// The number of intervals at the beginning.
const INTERVALS: usize = 16;

/// The largest possible excess of the least distance over the reported one, as a share.
pub(super) const CERTAIN: f64 = 1e-3;

/// Next to a touch the distance grows by the motion of the member, so that phases would have to be
/// very close. A distance below this share of the way over a radian at its fastest is not resolved.
pub(super) const TOUCH: f64 = 5e-3;

/// The largest number of phases. The bound then contains the unresolved part.
const PROBES: usize = 1000;

/// Equal up to rounding: distances of contacts, as a share of them.
pub(super) const EQUAL: f64 = 1e-9;

/// Rounding error of the square of a distance, as a share of it.
const NOISE: f64 = 1e-13;

/// More than enough steps to a root, with bisection in every third one.
const STEPS: usize = 180;

impl<V, const K: usize, const A: usize, const B: usize, F, G> Phases<V, K, A, B, F, G>
where
    V: Components<K>,
    F: Fn(f64) -> [[V; 3]; A],
    G: Fn(f64) -> [[V; 3]; B],
{
    /// The phase from the first to the second one of `range`, a cycle at most, that makes the least
    /// distance over the cycle largest.
    ///
    /// It is the best of all local optima: every interval of phases that might hold more than
    /// [`bound`](BestPhase::bound) is divided until none is left, by bounds that hold if the second
    /// member is nowhere between the positions more than a quarter faster, or more than a quarter
    /// harder accelerated, than at the fastest of them. The optimum itself is located to the last
    /// digits, by derivatives.
    ///
    /// # Errors
    ///
    /// `Phases` for an empty or infinite range or one of more than a cycle, `Curve` as
    /// [`clearance`](Self::clearance).
    pub fn best(&self, range: (f64, f64)) -> Result<BestPhase<K>, PhaseError> {
        Ok(self.search(range)?.best)
    }

    pub(super) fn search(&self, (low, high): (f64, f64)) -> Result<PhaseSearch<K>, PhaseError> {
        let width = high - low;
        if !(width.is_finite() && width > 0.0 && width <= self.width() * (1.0 + EQUAL)) {
            return Err(PhaseError::Phases {
                from: low,
                to: high,
            });
        }
        let mut probes = self.coarse(low, high)?;
        let mut best = self.refined(&mut probes, low, high)?;
        let least = 0.5 * (TOUCH * self.limits.speed) * (TOUCH * self.limits.speed);
        let mut bounds: Vec<f64> = probes
            .windows(2)
            .map(|pair| pair[0].bound(&pair[1], self.limits))
            .collect();
        let limit = loop {
            let open = (0..bounds.len()).max_by(|&a, &b| bounds[a].total_cmp(&bounds[b]));
            let Some(open) = open else { break best.q() };
            let enough = (best.q() * (1.0 + CERTAIN) * (1.0 + CERTAIN)).max(least);
            if bounds[open] <= enough || probes.len() >= PROBES {
                break bounds[open];
            }
            let [a, b] = [probes[open].phase, probes[open + 1].phase];
            let probe = self.probe(a + 0.5 * (b - a))?;
            let is_better = probe.q() > best.q();
            probes.insert(open + 1, probe);
            if is_better {
                best = self.refined(&mut probes, low, high)?;
                bounds.clear();
                bounds.extend(
                    probes
                        .windows(2)
                        .map(|pair| pair[0].bound(&pair[1], self.limits)),
                );
            } else {
                let pair = |i: usize| probes[i].bound(&probes[i + 1], self.limits);
                bounds[open] = pair(open);
                bounds.insert(open + 1, pair(open + 1));
            }
        };
        let bound = sqrt(2.0 * limit).max(best.clearance.least().distance);
        let best = report(&best, [low, high], bound, probes.len());
        Ok(PhaseSearch { probes, best })
    }

    /// Evenly spaced phases: where the spacing is not that of the positions, only both ends need
    /// calls of the second member at other places.
    fn coarse(&self, low: f64, high: f64) -> Result<Vec<Probe<K>>, PhaseError> {
        let spacing = self.width() / (self.positions() - 1) as f64;
        let stride = ((high - low) / spacing / INTERVALS as f64).max(1.0) as i64;
        let step = spacing * stride as f64;
        let mut phases = Vec::from([low]);
        let first = (low / step) as i64 - 1;
        let inner = (first..).map(|i| i as f64 * step);
        let inner = inner.skip_while(|&phase| phase <= low + 0.25 * step);
        phases.extend(inner.take_while(|&phase| phase < high - 0.25 * step));
        phases.push(high);
        let probes = phases.into_iter().map(|phase| self.probe(phase));
        Ok(probes.collect::<Result<_, _>>()?)
    }

    /// The optimum next to the best probe, which is added to the probes.
    fn refined(
        &self,
        probes: &mut Vec<Probe<K>>,
        low: f64,
        high: f64,
    ) -> Result<Probe<K>, PhaseError> {
        let better = |a: usize, b: usize| if probes[b].q() > probes[a].q() { b } else { a };
        let top = (0..probes.len()).fold(0, better);
        let rises = probes[top].line().slope > 0.0;
        let [a, b] = if rises {
            [top, top + 1]
        } else {
            [top.wrapping_sub(1), top]
        };
        let ends = [a, b].map(|i| probes.get(i));
        let [Some(left), Some(right)] = ends else {
            // It only grows beyond the range.
            return Ok(probes[top].clone());
        };
        let found = self.climbed(left.clone(), right.clone(), [low, high])?;
        if found.phase > left.phase && found.phase < right.phase {
            probes.insert(b, found.clone());
        }
        Ok(found)
    }

    /// The optimum, to the last digit, between a phase where the least distance rises and one where
    /// it decreases, or is less.
    fn climbed(
        &self,
        mut a: Probe<K>,
        mut b: Probe<K>,
        range: [f64; 2],
    ) -> Result<Probe<K>, PhaseError> {
        let digit = f64::EPSILON * range[0].abs().max(range[1].abs());
        for step in 0..STEPS {
            let width = b.phase - a.phase;
            let trial = if step % 3 == 2 {
                a.phase + 0.5 * width
            } else {
                a.trial(&b)
            };
            let ended = trial - a.phase <= digit || b.phase - trial <= digit;
            if width <= 2.0 * digit || (ended && step % 3 != 2) {
                break;
            }
            let probe = self.probe(trial)?;
            let slope = probe.line().slope;
            // A rising phase is left of the optimum, unless a higher one that rises is left of it;
            // the same the other way round.
            let lower = |than: &Probe<K>| probe.q() < than.q() * (1.0 - NOISE);
            let beyond_left = a.line().slope > 0.0 && lower(&a);
            let beyond_right = b.line().slope < 0.0 && lower(&b);
            if slope == 0.0 {
                return Ok(probe);
            }
            let is_left = if slope > 0.0 {
                !beyond_left
            } else {
                beyond_right
            };
            if is_left {
                a = probe;
            } else {
                b = probe;
            }
        }
        Ok(if a.q() > b.q() { a } else { b })
    }
}

fn report<const K: usize>(
    best: &Probe<K>,
    ends: [f64; 2],
    bound: f64,
    probes: usize,
) -> BestPhase<K> {
    let distance = best.clearance.least().distance;
    let minima = best.clearance.minima().iter().zip(&best.lines);
    let near = minima.filter(|(nearest, _)| nearest.distance <= distance * (1.0 + EQUAL));
    let contacts: Vec<Contact<K>> = near
        .map(|(nearest, line)| Contact {
            nearest: *nearest,
            slope: line.slope / nearest.distance,
        })
        .collect();
    let signs = [1.0, -1.0].map(|sign| contacts.iter().any(|contact| contact.slope * sign > 0.0));
    BestPhase {
        phase: best.phase,
        distance,
        optimum: if contacts.len() > 1 && signs == [true, true] {
            Optimum::Equal
        } else if ends.contains(&best.phase) {
            Optimum::End
        } else {
            Optimum::Smooth
        },
        contacts,
        bound,
        probes,
    }
}
