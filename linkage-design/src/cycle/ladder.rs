//! The ladder of bounds: searches within narrower bounds, of which the best result counts.
//!
//! A search within wide bounds may lose its way where one within narrower bounds does not: it
//! leaves the valley that it began in, or comes near to a place where the mechanism ceases to
//! exist. So there are rungs from narrow bounds to the full ones, each twice as wide as the rung
//! below, and on each rung a search begins with the first mechanism, and another one with the best
//! result of the rungs below. If both do not converge, the bounds widen in eight even steps, with
//! the same two searches on each, a third one from the best result so far and, where that does not
//! converge, a fourth one with a short first step.
//!
//! The results of all rungs are kept. So the best one is never worse than the first mechanism, if
//! that holds all conditions. Widths of rungs and steps do not depend on the full bounds, and
//! searches on a step do not depend on the width of its rung. Bounds of steps are rounded, and full
//! bounds whose searches do not converge are rounded as a step of wider ones would be. So bounds
//! that are as wide as a step have no search that wider ones of the same shape leave out, unless
//! the search within the wider ones converges without steps.

use std::vec::Vec;

use super::super::DesignError;
use super::super::limits::Limits;
use super::descents::Descents;
use super::ended::Ended;
use super::problem::SearchStart;
use linkage_runtime::Dimensions;

/// The width of the narrowest rung: of the parameter whose bounds are widest, as a part of its
/// value.
const NARROW: f64 = 0.04;
/// Steps between two rungs, evenly spaced.
const STEPS: i32 = 8;
/// Rungs below the narrowest one, with every second step only.
const BELOW: i32 = 2;
/// A search from an optimum within bounds that are a step narrower has little way to go: the first
/// step is this part of the usual one.
const SHORT: f64 = 0.1;
/// The most rungs: bounds that are a million times as wide as narrow ones.
const RUNGS: i32 = 20;
/// The most steps of a rung where no search has any result.
const HOPELESS: usize = 2;
/// Bounds that differ by less than this part are the same.
const SAME: f64 = 1e-6;
/// Bounds of searches that need not converge are multiples of this part of the value, 2^-36: far
/// more than rounding, and nothing to a mechanism.
pub(super) const ROUNDED: f64 = 1.0 / (1_u64 << 36) as f64;
/// Results that differ by less than this part are equal.
const EQUAL: f64 = 1e-6;

/// A rung: parts of the full bounds.
struct Rung {
    /// The steps between the rung below and this one.
    steps: Vec<f64>,
    part: f64,
}

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

    /// Keeps a result within a part of the bounds. It is an optimum within the full ones only if
    /// that part is all of them.
    fn keep(&mut self, result: Result<Ended, DesignError>, part: f64) -> Result<(), DesignError> {
        let mut result = result?;
        result.converged &= part == 1.0;
        if result.least < self.least() {
            self.best = Some(self.results.len());
        }
        self.results.push(result);
        Ok(())
    }

    /// Returns true if a search has found something better than the first mechanism.
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
        // An optimum within the full bounds comes before one that is better by less than the
        // precision of a search.
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
    pub(super) fn ladder(&self, first: SearchStart) -> Result<Vec<Ended>, DesignError> {
        let mut ladder = Ladder {
            origin: first.x[..self.problem.varied.len()].to_vec(),
            results: self.standing(&first).into_iter().collect(),
            best: None,
        };
        ladder.best = ladder.results.first().map(|_| 0);
        let mut error = None;
        for rung in self.rungs(&ladder.origin) {
            // The search within the full bounds is always begun.
            if rung.part == 1.0 || !(self.stopped)() {
                error = self.climb(&mut ladder, &rung).err();
            }
        }
        match error {
            Some(error) if ladder.results.is_empty() => Err(error),
            _ => Ok(ladder.sorted()),
        }
    }

    /// The rungs, the full bounds last.
    fn rungs(&self, origin: &[f64]) -> Vec<Rung> {
        let limits = &self.problem.limits;
        let bounds = limits.lower.iter().zip(&limits.upper).zip(origin);
        let parts = bounds.map(|((low, high), x)| (high - low) / x.abs());
        // A parameter that is zero has no size to compare with.
        let widest = parts.filter(|part| part.is_finite()).fold(0.0, f64::max);
        let part = |step: i32| {
            let octaves = 2_f64.powi(step.div_euclid(STEPS));
            let eighths = f64::from(step.rem_euclid(STEPS)) / f64::from(STEPS);
            NARROW * octaves * (1.0 + eighths) / widest
        };
        let narrower = (-BELOW * STEPS..RUNGS * STEPS).take_while(|step| part(*step) < 1.0 - SAME);
        let (mut rungs, mut steps) = (Vec::new(), Vec::new());
        for step in narrower.filter(|_| self.widening && widest > 0.0) {
            if step >= 0 && step % STEPS == 0 {
                let steps = core::mem::take(&mut steps);
                rungs.push(Rung {
                    steps,
                    part: part(step),
                });
            } else if step > 0 || step % 2 == 0 {
                steps.push(part(step));
            }
        }
        rungs.push(Rung { steps, part: 1.0 });
        rungs
    }

    /// Searches within the bounds of a rung, and in steps to it where that is not enough.
    ///
    /// The results of these two searches are kept after the steps, so that no step depends on how
    /// wide its rung is: a rung that ends at a step has the same searches as that step.
    fn climb(&self, ladder: &mut Ladder, rung: &Rung) -> Result<(), DesignError> {
        let (near, least) = (ladder.near(), ladder.least());
        let climbed = ladder.has_climbed().then_some(near.as_slice());
        let mut tried = self.try_both(ladder, &self.bounds(ladder, rung.part), climbed);
        let converged = |k: usize| {
            let found: Option<&Ended> = tried.get(k)?.as_ref().ok();
            found.filter(|result| result.converged)
        };
        let enough =
            converged(0).is_some_and(|direct| direct.least <= least) || converged(1).is_some();
        let hopeless = tried.iter().all(Result::is_err);
        let mut kept = Ok(());
        if !enough {
            if rung.part == 1.0 && !self.keeps_full_bounds() {
                // As a step of wider bounds: searches that do not converge end elsewhere if their
                // bounds differ by rounding.
                tried = self.try_both(ladder, &self.step_bounds(ladder, 1.0), climbed);
            }
            for (k, &part) in rung.steps.iter().enumerate() {
                let hopeless = k >= HOPELESS && hopeless && ladder.results.is_empty();
                if hopeless || (self.stopped)() {
                    break;
                }
                for result in self.try_both(ladder, &self.step_bounds(ladder, part), climbed) {
                    let _ = ladder.keep(result, part);
                }
                self.follow(ladder, part, &near);
            }
        }
        for (k, result) in tried.into_iter().enumerate() {
            let result = ladder.keep(result, rung.part);
            if k == 0 {
                kept = result;
            }
        }
        if !enough && !(self.stopped)() {
            self.follow(ladder, rung.part, &near);
        }
        kept
    }

    /// The bounds of a rung: the full ones to the last digit.
    fn bounds(&self, ladder: &Ladder, part: f64) -> Limits {
        if part < 1.0 {
            self.step_bounds(ladder, part)
        } else {
            self.problem.limits.clone()
        }
    }

    /// Full bounds may be values of a catalogue: then they are not rounded.
    fn keeps_full_bounds(&self) -> bool {
        !self.problem.catalogues.is_empty()
    }

    /// A part of the bounds, rounded inwards.
    fn step_bounds(&self, ladder: &Ladder, part: f64) -> Limits {
        match part == 1.0 && self.keeps_full_bounds() {
            true => self.problem.limits.clone(),
            false => narrowed(&self.problem.limits, &ladder.origin, part),
        }
    }

    /// Searches within some bounds from the first mechanism, and from the best result of the rungs
    /// below.
    fn try_both(
        &self,
        ladder: &Ladder,
        limits: &Limits,
        near: Option<&[f64]>,
    ) -> Vec<Result<Ended, DesignError>> {
        let near = near.map(<[f64]>::to_vec);
        let places = core::iter::once(ladder.origin.clone()).chain(near);
        places
            .map(|values| self.descend(self.problem.start(limits, values)?))
            .collect()
    }

    /// Searches within a part of the bounds from the best result of all, and with a shorter first
    /// step where that search does not converge.
    ///
    /// `near` is the best result of the rungs below, from which a search within this part was begun
    /// already.
    fn follow(&self, ladder: &mut Ladder, part: f64, near: &[f64]) {
        let best = ladder.near();
        let limits = self.step_bounds(ladder, part);
        let mut converged = false;
        if best != near {
            let start = self.problem.start(&limits, best.clone());
            let result = start.and_then(|start| self.descend(start));
            converged = result.as_ref().is_ok_and(|result| result.converged);
            let _ = ladder.keep(result, part);
        }
        if !converged && ladder.has_climbed() {
            let start = self.problem.start(&limits, best);
            let result = start.and_then(|mut start| {
                let parameters = start.reach.iter_mut().take(ladder.origin.len());
                parameters.for_each(|reach| *reach *= SHORT);
                self.descend(start)
            });
            let _ = ladder.keep(result, part);
        }
    }

    /// The first mechanism itself, if it holds all conditions.
    fn standing(&self, first: &SearchStart) -> Option<Ended> {
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

/// The limits with a part of the way from a place to each bound, rounded towards the place: equal
/// for all bounds of the same shape.
fn narrowed(limits: &Limits, origin: &[f64], part: f64) -> Limits {
    let mut narrowed = limits.clone();
    for bounds in [&mut narrowed.lower, &mut narrowed.upper] {
        for (bound, x) in bounds.iter_mut().zip(origin) {
            let way = part * (*bound - x);
            let unit = x.abs() * ROUNDED;
            if unit > 0.0 && way.is_finite() {
                *bound = x + (way / unit).trunc() * unit;
            } else if part < 1.0 {
                *bound = x + way;
            }
        }
    }
    narrowed
}
