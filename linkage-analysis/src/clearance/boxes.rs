//! Several phases at once: boxes of phases, bounded by the clearance of each pair at the difference
//! of its two phases.

use super::PhaseError;
use super::ascent::{self, Crest};
use super::probe::Probe;
use super::search::{CERTAIN, EQUAL, TOUCH};
use super::several::{BestPhases, BestSteps, PairContact, PhaseSet};
use crate::cyclogram::Slot;
use alloc::collections::{BTreeMap, BinaryHeap};
use alloc::rc::Rc;
use alloc::vec::Vec;
use core::cmp::Ordering;
use linkage_core::math::double::sqrt;

struct BoxSearch<'s, 'a, const K: usize, const N: usize> {
    set: &'s PhaseSet<'a, K, N>,
    ranges: [(f64, f64); N],
    /// The known clearances of each pair, by the difference of phases.
    seen: Vec<BTreeMap<u64, Rc<Probe<K>>>>,
}

/// Phases around a point.
#[derive(Clone, Copy, Debug)]
struct Cell<const N: usize> {
    centre: [f64; N],
    half: [f64; N],
    /// Half the square of a distance that the least one exceeds nowhere in the cell.
    bound: f64,
}

/// In how many parts each range is divided at first.
const PARTS: usize = 8;

/// More boxes are not looked at: where phases change nothing, each of their values has boxes of its
/// own.
const CELLS: usize = 100_000;

/// An end of the range that a step misses by rounding, as a share of a step, still has it.
const BESIDE: f64 = 1e-9;

impl<const K: usize, const N: usize> PhaseSet<'_, K, N> {
    /// The phases, each from the first to the second one of its range, a cycle at most, that make
    /// the least distance of all pairs over the cycle largest.
    ///
    /// It is the best of all local optima, as [`Phases::best`](super::Phases::best) finds it for
    /// one phase: boxes of phases that might hold more than [`bound`](BestPhases::bound) are
    /// divided until none is left. The optimum itself is located by derivatives: there no change of
    /// the phases makes all contacts larger.
    ///
    /// # Errors
    ///
    /// `Phases` for a range that is empty, infinite or more than a cycle, `NoPairs` without any,
    /// `Curve` as [`Phases::clearance`](super::Phases::clearance).
    pub fn best(&self, ranges: [(f64, f64); N]) -> Result<BestPhases<K, N>, PhaseError> {
        BoxSearch::new(self, ranges)?.best()
    }

    /// The best of the phases that are whole multiples of these steps, such as `TAU / 48.0` for a
    /// gear of 48 slots, and the loss against the [best](Self::best) phases of all. All
    /// combinations are compared.
    ///
    /// # Errors
    ///
    /// As [`best`](Self::best), and `Step` for a step that is not positive, or of which there is
    /// none in its range.
    pub fn best_step(
        &self,
        ranges: [(f64, f64); N],
        steps: [f64; N],
    ) -> Result<BestSteps<K, N>, PhaseError> {
        BoxSearch::new(self, ranges)?.best_step(steps)
    }
}

impl<'s, 'a, const K: usize, const N: usize> BoxSearch<'s, 'a, K, N> {
    fn new(set: &'s PhaseSet<'a, K, N>, ranges: [(f64, f64); N]) -> Result<Self, PhaseError> {
        let cycles = set.pairs.iter().map(|pair| pair.cycle);
        let cycle = cycles.fold(f64::INFINITY, f64::min);
        if set.pairs.is_empty() {
            return Err(PhaseError::NoPairs);
        }
        for (from, to) in ranges {
            let width = to - from;
            if !(width.is_finite() && width > 0.0 && width <= cycle * (1.0 + EQUAL)) {
                return Err(PhaseError::Phases { from, to });
            }
        }
        Ok(Self {
            set,
            ranges,
            seen: set.pairs.iter().map(|_| BTreeMap::new()).collect(),
        })
    }

    fn best(&mut self) -> Result<BestPhases<K, N>, PhaseError> {
        let mut open = self.coarse()?;
        let mut best = self.crest(open.peek().map(|cell| cell.centre))?;
        let speeds = self.set.pairs.iter().map(|pair| pair.limits.speed);
        let touch = TOUCH * speeds.fold(0.0, f64::max);
        let mut count = open.len();
        let limit = loop {
            let Some(cell) = open.peek().copied() else {
                break best.q;
            };
            let enough = (best.q * (1.0 + CERTAIN) * (1.0 + CERTAIN)).max(0.5 * touch * touch);
            if cell.bound <= enough || count >= CELLS {
                break cell.bound;
            }
            open.pop();
            for half in cell.halves() {
                let (q, cell) = self.looked_at(half)?;
                if q > best.q {
                    best = self.crest(Some(cell.centre))?;
                }
                open.push(cell);
                count += 1;
            }
        };
        self.report(&best, sqrt(2.0 * limit))
    }

    /// Evenly divided ranges.
    fn coarse(&mut self) -> Result<BinaryHeap<Cell<N>>, PhaseError> {
        let half = self
            .ranges
            .map(|(low, high)| 0.5 * (high - low) / PARTS as f64);
        let mut cells = BinaryHeap::new();
        for number in 0..PARTS.pow(N as u32) {
            let mut rest = number;
            let centre = core::array::from_fn(|k| {
                let part = rest % PARTS;
                rest /= PARTS;
                self.ranges[k].0 + (2 * part + 1) as f64 * half[k]
            });
            let cell = Cell {
                centre,
                half,
                bound: f64::INFINITY,
            };
            cells.push(self.looked_at(cell)?.1);
        }
        Ok(cells)
    }

    /// Half the square of the least distance in the middle, and the box with its bound.
    fn looked_at(&mut self, mut cell: Cell<N>) -> Result<(f64, Cell<N>), PhaseError> {
        let (mut least, mut bound) = (f64::INFINITY, f64::INFINITY);
        for pair in 0..self.set.pairs.len() {
            let probe = self.probe(pair, &cell.centre)?;
            let turned = &self.set.pairs[pair];
            let ends = [turned.first, turned.second].into_iter().flatten();
            let reach: f64 = ends.map(|phase| cell.half[phase]).sum();
            least = least.min(probe.q());
            bound = bound.min(probe.within(reach.min(0.5 * turned.cycle), turned.limits));
        }
        cell.bound = bound;
        Ok((least, cell))
    }

    /// The clearance of a pair at these phases.
    fn probe(&mut self, pair: usize, phases: &[f64; N]) -> Result<Rc<Probe<K>>, PhaseError> {
        let turned = &self.set.pairs[pair];
        let phase = |number: Option<usize>| number.map_or(0.0, |phase| phases[phase]);
        // No negative zero.
        let difference = phase(turned.second) - phase(turned.first) + 0.0;
        if let Some(known) = self.seen[pair].get(&difference.to_bits()) {
            return Ok(known.clone());
        }
        let probe = Rc::new((turned.at)(difference)?);
        self.seen[pair].insert(difference.to_bits(), probe.clone());
        Ok(probe)
    }

    /// All minima of all pairs, as parabolas of the phases.
    fn crest_at(&mut self, phases: [f64; N]) -> Result<Crest<N>, PhaseError> {
        let mut crest = Crest::new(phases);
        for pair in 0..self.set.pairs.len() {
            let probe = self.probe(pair, &phases)?;
            let turned = &self.set.pairs[pair];
            crest.add(&probe.lines, [turned.first, turned.second]);
        }
        Ok(crest)
    }

    /// The optimum next to these phases.
    fn crest(&mut self, start: Option<[f64; N]>) -> Result<Crest<N>, PhaseError> {
        let start = start.unwrap_or_else(|| self.ranges.map(|(low, high)| 0.5 * (low + high)));
        let ranges = self.ranges;
        let step = ranges.map(|(low, high)| 0.5 * (high - low) / PARTS as f64);
        let step = step.into_iter().fold(f64::INFINITY, f64::min);
        ascent::climbed(start, step, &ranges, |phases| self.crest_at(phases))
    }

    fn report(&mut self, best: &Crest<N>, bound: f64) -> Result<BestPhases<K, N>, PhaseError> {
        let mut found = BestPhases {
            phases: best.phases,
            distance: f64::INFINITY,
            contacts: Vec::new(),
            bound,
            probes: 0,
        };
        for pair in 0..self.set.pairs.len() {
            let probe = self.probe(pair, &best.phases)?;
            found.distance = found.distance.min(probe.clearance.least().distance);
            let turned = &self.set.pairs[pair];
            for (nearest, line) in probe.clearance.minima().iter().zip(&probe.lines) {
                let mut slopes = [0.0; N];
                let slope = line.slope / nearest.distance;
                for (phase, sign) in [(turned.first, -1.0), (turned.second, 1.0)] {
                    if let Some(phase) = phase {
                        slopes[phase] += sign * slope;
                    }
                }
                found.contacts.push(PairContact {
                    pair,
                    nearest: *nearest,
                    slopes,
                });
            }
        }
        let most = found.distance * (1.0 + EQUAL);
        found
            .contacts
            .retain(|contact| contact.nearest.distance <= most);
        found.bound = bound.max(found.distance);
        found.probes = self.seen.iter().map(BTreeMap::len).sum();
        Ok(found)
    }

    fn best_step(&mut self, steps: [f64; N]) -> Result<BestSteps<K, N>, PhaseError> {
        let mut numbers: [(i64, i64); N] = [(0, 0); N];
        for ((whole, step), range) in numbers.iter_mut().zip(steps).zip(self.ranges) {
            let ends = [range.0 / step - BESIDE, range.1 / step + BESIDE];
            let none = PhaseError::Step { step, range };
            if !(step > 0.0 && step.is_finite() && ends.iter().all(|end| end.abs() < 1e9)) {
                return Err(none);
            }
            // Whole numbers from the first one that is not less to the last one that is not more.
            let [low, high] = ends.map(|end| end as i64);
            *whole = (
                low + i64::from((low as f64) < ends[0]),
                high - i64::from(high as f64 > ends[1]),
            );
            if whole.0 > whole.1 {
                return Err(none);
            }
        }
        let best = self.best()?;
        let mut found: Option<(f64, [i64; N])> = None;
        let mut number = numbers.map(|(low, _)| low);
        loop {
            let phases = core::array::from_fn(|k| number[k] as f64 * steps[k]);
            let most = found.map_or(f64::NEG_INFINITY, |(distance, _)| distance);
            let mut least = f64::INFINITY;
            for pair in 0..self.set.pairs.len() {
                least = least.min(self.probe(pair, &phases)?.clearance.least().distance);
                if least <= most {
                    break;
                }
            }
            if least > most {
                found = Some((least, number));
            }
            let Some(next) = (0..N).find(|&k| number[k] < numbers[k].1) else {
                break;
            };
            number[next] += 1;
            (0..next).for_each(|k| number[k] = numbers[k].0);
        }
        let (distance, number) = found.ok_or(PhaseError::NoPairs)?;
        Ok(BestSteps {
            slots: core::array::from_fn(|k| {
                let angle = number[k] as f64 * steps[k];
                Slot {
                    step: number[k],
                    angle,
                    off: angle - best.phases[k],
                }
            }),
            distance,
            loss: best.distance - distance,
            best,
        })
    }
}

impl<const N: usize> Cell<N> {
    /// Divided across its longest side.
    fn halves(self) -> [Self; 2] {
        let longer = |a: usize, b: usize| if self.half[b] > self.half[a] { b } else { a };
        let side = (0..N).fold(0, longer);
        [-1.0, 1.0].map(|sign| {
            let mut half = self;
            half.half[side] *= 0.5;
            half.centre[side] += sign * half.half[side];
            half
        })
    }
}

/// The one that may hold most is the greatest.
impl<const N: usize> Ord for Cell<N> {
    fn cmp(&self, other: &Self) -> Ordering {
        self.bound.total_cmp(&other.bound)
    }
}

impl<const N: usize> PartialOrd for Cell<N> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<const N: usize> PartialEq for Cell<N> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl<const N: usize> Eq for Cell<N> {}
