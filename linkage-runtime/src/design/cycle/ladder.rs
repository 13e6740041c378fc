//! The ladder of bounds: searches within narrower bounds, of which the best result counts.
//!
//! A search within wide bounds may lose its way where one within narrower bounds does not: it leaves the valley that it began in, or comes near
//! to a place where the mechanism ceases to exist. So the bounds are halved until they are narrow, and on each rung, from the narrowest
//! one up, a search begins with the first mechanism, and one with the best result of the rungs below. If the second one does not
//! converge, or its result is worse, the bounds widen in shorter steps, each search from the result of the step before.
//!
//! The results of all rungs are kept. So the best one is never worse than the first mechanism, if that holds all conditions, nor than the result
//! within a half, a quarter and further halves of the bounds, which has the same rungs.

use alloc::vec::Vec;

use super::super::DesignError;
use super::super::limits::Limits;
use super::descent::Ended;
use super::descents::Descents;
use super::problem::Start;
use crate::Dimensions;

/// Bounds are narrow if they are no further apart than this part of each parameter.
const NARROW: f64 = 0.05;
/// The most rungs: bounds that are a million times as wide as narrow ones.
const RUNGS: usize = 20;
/// The shortest step between two rungs, as a part of the bounds of the upper one.
const SHORTEST: f64 = 0.01;
/// Results that differ by less than this part are equal.
const EQUAL: f64 = 1e-6;
/// The most searches between two rungs.
const SEARCHES: usize = 16;

/// The most of them where no search has any result.
const HOPELESS: usize = 2;

/// The results on a ladder.
struct Ladder {
    /// The parameters of the first mechanism.
    origin: Vec<f64>,
    results: Vec<Ended>,
    /// The number of the best one.
    best: Option<usize>,
}

impl Ladder {
    fn least(&self) -> f64 {
        self.best
            .map_or(f64::INFINITY, |best| self.results[best].least)
    }

    fn keep(&mut self, result: Ended) {
        if result.least < self.least() {
            self.best = Some(self.results.len());
        }
        self.results.push(result);
    }

    /// Whether a search has found something better than the first mechanism.
    fn has_climbed(&self) -> bool {
        self.best.is_some_and(|best| self.results[best].steps > 0)
    }

    /// The parameters of the best result, or of the first mechanism.
    fn near(&self) -> Vec<f64> {
        let best = self.best.map(|best| &self.results[best].at.x);
        best.map_or(&self.origin, |x| x)[..self.origin.len()].to_vec()
    }

    /// All results, the best first, each with the steps and evaluations of all.
    fn sorted(mut self) -> Vec<Ended> {
        let steps = self.results.iter().map(|result| result.steps).sum();
        let evaluations = self.results.iter().map(|result| result.evaluations).sum();
        let least = self.least();
        // An optimum within the full bounds comes before one that is better by less than the precision of a search.
        let rank = |result: &Ended| {
            let equal = result.converged && result.least <= least + EQUAL * least.abs();
            if equal { least } else { result.least }
        };
        let order = |a: &Ended, b: &Ended| {
            let optima = b.converged.cmp(&a.converged);
            rank(a).total_cmp(&rank(b)).then(optima)
        };
        self.results.sort_by(order);
        for result in &mut self.results {
            (result.steps, result.evaluations) = (steps, evaluations);
        }
        self.results
    }
}

impl<M: Dimensions<N>, A, const N: usize> Descents<'_, M, A, N> {
    /// All results from the first mechanism, the best first.
    ///
    /// # Errors
    ///
    /// The error of the search within the full bounds, if no search has a result.
    pub(super) fn ladder(&self, first: Start) -> Result<Vec<Ended>, DesignError> {
        let mut ladder = Ladder {
            origin: first.x[..self.problem.varied.len()].to_vec(),
            results: self.standing(&first).into_iter().collect(),
            best: None,
        };
        ladder.best = ladder.results.first().map(|_| 0);
        let rungs = if self.widening {
            self.rungs(&ladder.origin)
        } else {
            1
        };
        for rung in (1..rungs).rev() {
            if !(self.stopped)() {
                let _ = self.climb(&mut ladder, 0.5_f64.powi(rung as i32));
            }
        }
        let error = self.climb(&mut ladder, 1.0).err();
        match error {
            Some(error) if ladder.results.is_empty() => Err(error),
            _ => Ok(ladder.sorted()),
        }
    }

    /// The number of rungs from the full bounds to narrow ones.
    fn rungs(&self, origin: &[f64]) -> usize {
        let limits = &self.problem.limits;
        let bounds = limits.lower.iter().zip(&limits.upper).zip(origin);
        let parts = bounds.map(|((low, high), x)| (high - low) / x.abs());
        // A parameter that is zero has no size to compare with.
        let widest = parts.filter(|part| part.is_finite()).fold(0.0, f64::max);
        let halvings = (widest / NARROW).log2().ceil();
        1 + (halvings.max(0.0) as usize).min(RUNGS)
    }

    /// Searches within this part of the bounds: from the first mechanism, and in shorter steps from the best result where that is not enough.
    fn climb(&self, ladder: &mut Ladder, part: f64) -> Result<(), DesignError> {
        // Only a search that converged is where the next one begins: others end anywhere.
        let (mut near, mut least) = (ladder.near(), ladder.least());
        let climbed = ladder.has_climbed();
        let direct = self.within(ladder, part, ladder.origin.clone());
        let error = match direct {
            Ok(result) => {
                // Where nothing was found on the rung below there is nowhere else to begin.
                let enough = result.converged && result.least <= least && !climbed;
                ladder.keep(of_part(result, part));
                if enough {
                    return Ok(());
                }
                None
            }
            Err(error) => Some(error),
        };
        let (mut reached, mut step) = (if climbed { 0.5 } else { 0.0 }, 0.5);
        for search in 0..SEARCHES {
            let hopeless = search >= HOPELESS && ladder.results.is_empty();
            if hopeless || reached >= 1.0 || step < SHORTEST || (self.stopped)() {
                break;
            }
            let next = f64::min(reached + step, 1.0);
            let result = self.within(ladder, next * part, near.clone());
            let better = |result: &Ended| result.converged && result.least <= least;
            if result.as_ref().is_ok_and(better) {
                reached = next;
                step *= 2.0;
            } else {
                step *= 0.5;
            }
            if let Ok(result) = result {
                if reached == next {
                    near = result.at.x[..near.len()].to_vec();
                    least = result.least;
                }
                ladder.keep(of_part(result, next * part));
            }
        }
        if reached < 1.0 && !(self.stopped)() {
            if let Ok(result) = self.within(ladder, part, ladder.near()) {
                ladder.keep(of_part(result, part));
            }
        }
        error.map_or(Ok(()), Err)
    }

    /// Searches within a part of the bounds from a place.
    fn within(&self, ladder: &Ladder, part: f64, place: Vec<f64>) -> Result<Ended, DesignError> {
        let limits = narrowed(&self.problem.limits, &ladder.origin, part);
        self.descend(self.problem.start(&limits, place)?)
    }

    /// The first mechanism itself, if it holds all conditions.
    fn standing(&self, first: &Start) -> Option<Ended> {
        let (at, least) = self.settled(first, f64::NAN, None).ok()?;
        Some(Ended {
            at,
            least,
            steps: 0,
            evaluations: 1,
            converged: false,
        })
    }
}

/// The result within a part of the bounds, which is an optimum within the full ones only if that part is all of them.
fn of_part(result: Ended, part: f64) -> Ended {
    Ended {
        converged: result.converged && part == 1.0,
        ..result
    }
}

/// The limits with a part of the way from a place to each bound.
fn narrowed(limits: &Limits, origin: &[f64], part: f64) -> Limits {
    let mut narrowed = limits.clone();
    if part < 1.0 {
        for bounds in [&mut narrowed.lower, &mut narrowed.upper] {
            for (bound, x) in bounds.iter_mut().zip(origin) {
                *bound = x + part * (*bound - x);
            }
        }
    }
    narrowed
}
