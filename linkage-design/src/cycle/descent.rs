//! One search, and the best of its steps that holds.

use std::vec::Vec;

use super::super::DesignError;
use super::super::minimax::{Groups, SearchSettings, minimise};
use super::descents::Descents;
use super::ended::{Ended, TOLERANCE};
use super::problem::{SearchStart, Sizes};
use super::verify::Scales;
use linkage_runtime::Dimensions;

/// The search checks for an optimum where steps promise less than this part of the change of the
/// goal in a first step.
const PRECISION: f64 = 1e-6;
/// It is at one where, to first order, no step as long as the first one gains more than this part
/// of it.
const SLOPE: f64 = 1e-5;
/// Rounding leaves this part of it.
const ROUNDING: f64 = 1e-12;
/// One that is broken by more than this part of it at the end is out of reach; the violations
/// between are those of a search that is ended early.
const HOLDS: f64 = 1e-7;
/// Number of times that objectives may add conditions.
const REFINEMENTS: usize = 40;

impl<M: Dimensions<N>, A, const N: usize> Descents<'_, M, A, N> {
    /// Searches from a start, and returns the verified result: where the search ended, or the best
    /// of its steps, if the end does not hold.
    pub(super) fn descend(&self, mut start: SearchStart) -> Result<Ended, DesignError> {
        let problem = &self.problem;
        let mut sizes = problem
            .sizes(&start)
            .ok_or_else(|| problem.refused(&start))?;
        let scales = problem.scales(&start);
        let exact = problem.exact_tolerance(&start, scales.as_ref());
        let exact = exact.unwrap_or(TOLERANCE).clamp(ROUNDING, TOLERANCE);
        let search = SearchSettings {
            reach: start.reach.clone(),
            precision: PRECISION,
            slope: SLOPE,
            tolerance: exact,
            rounds: self.steps,
        };
        let (mut steps, mut evaluations, mut converged) = (0, 0, false);
        let begun = start.x.clone();
        let mut held = [None, None];
        for _ in 0..REFINEMENTS {
            // Further conditions annul all results before them.
            let reference = self.reference.as_ref();
            // One that holds only for the search may have a better value than all that hold for the
            // verdict.
            let mut bests = [HOLDS, exact].map(|holds| Best::new(&sizes, reference, holds));
            let groups = |x: &[f64]| {
                let groups = problem.groups(&start, x, &sizes)?;
                bests.iter_mut().for_each(|best| best.see(x, &groups));
                Some(groups)
            };
            let found = minimise(&start.x, &start.limits, &search, groups, self.stopped)
                .ok_or_else(|| problem.not_whole(&start.x))?;
            steps += found.rounds;
            evaluations += found.evaluations;
            start.x = found.x;
            held = bests.map(|best| best.x);
            let refined = !(self.stopped)() && problem.refine(&mut start);
            converged = found.converged && !refined;
            sizes = problem
                .sizes(&start)
                .ok_or_else(|| problem.not_whole(&start.x))?;
            if !refined {
                break;
            }
        }
        let claimed = |at: &SearchStart| {
            let groups = problem.groups(at, &at.x, &sizes);
            groups.map_or(f64::NAN, |groups| sizes.goal * groups.value())
        };
        let ended = |at: SearchStart, least: f64, converged: bool| Ended {
            at,
            least,
            steps,
            evaluations,
            converged,
        };
        let last = problem
            .held(&start, &sizes, HOLDS)
            .and_then(|()| self.settled(&start, claimed(&start), scales.as_ref()));
        let mut missed = None;
        let mut best = match last {
            // With another interval than that of the search it is no longer where the search ended.
            Ok((at, least)) => Some((converged && at.x == start.x, at, least)),
            Err(error) => {
                missed = Some(error.unsettled(!converged));
                None
            }
        };
        for x in held.into_iter().flatten().chain([begun]) {
            let at = SearchStart { x, ..start.clone() };
            let value = claimed(&at);
            let gains = |least: f64| value < least - PRECISION * least.abs();
            if best.as_ref().is_none_or(|(_, _, least)| gains(*least)) {
                let other = self.settled(&at, value, scales.as_ref()).ok();
                let better = other.filter(|(_, other)| {
                    best.as_ref()
                        .is_none_or(|(_, _, least)| *other < least - PRECISION * least.abs())
                });
                best = better.map(|(at, least)| (false, at, least)).or(best);
            }
        }
        match (best, missed) {
            (Some((converged, at, least)), _) => Ok(ended(at, least, converged)),
            (None, Some(missed)) => Err(missed),
            (None, None) => Err(problem.not_whole(&start.x)),
        }
    }

    /// The verified place with its goal: with the variables that objectives have for themselves,
    /// or, where their claim does not hold, with those that suit the mechanism there.
    pub(super) fn settled(
        &self,
        start: &SearchStart,
        claimed: f64,
        scales: Option<&Scales>,
    ) -> Result<(SearchStart, f64), DesignError> {
        let problem = &self.problem;
        let both = [self.reference.as_ref(), scales];
        let missed = match problem.verified(start, claimed, &both) {
            Ok(least) => return Ok((start.clone(), least)),
            Err(missed) => missed,
        };
        let values = start.x[..problem.varied.len()].to_vec();
        let Ok(mut suited) = problem.start(&problem.limits, values) else {
            return Err(missed);
        };
        suited.added.clone_from(&start.added);
        match problem.verified(&suited, f64::NAN, &both) {
            Ok(least) => Ok((suited, least)),
            Err(_) => Err(missed),
        }
    }
}

/// The best place of a search that holds all conditions.
struct Best {
    x: Option<Vec<f64>>,
    value: f64,
    /// The violation of each condition that is none, in its size: as small in that of the first
    /// mechanism.
    tolerances: Vec<f64>,
}

impl Best {
    fn new(sizes: &Sizes, reference: Option<&Scales>, holds: f64) -> Self {
        let sizes = &sizes.conditions;
        let first: Vec<f64> = reference.into_iter().flatten().flatten().copied().collect();
        let tolerance = |(k, size): (usize, &f64)| {
            // Conditions that a search added have none there.
            let first = first.get(k).filter(|_| first.len() == sizes.len());
            holds * first.map_or(1.0, |first| (first / size).min(1.0))
        };
        Self {
            x: None,
            value: f64::INFINITY,
            tolerances: sizes.iter().enumerate().map(tolerance).collect(),
        }
    }

    fn see(&mut self, x: &[f64], groups: &Groups) {
        let mut excesses = groups.excesses().zip(&self.tolerances);
        if groups.value() < self.value && excesses.all(|(excess, most)| excess <= *most) {
            self.x = Some(x.to_vec());
            self.value = groups.value();
        }
    }
}
