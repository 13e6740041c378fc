//! Searches from several starts, and the distinct optima they end at.

use std::vec::Vec;

use super::super::catalogue;
use super::super::limits::Limits;
use super::super::quasi_random::unit;
use super::super::{DesignError, Interruption};
use super::ended::Ended;
use super::found::BestCycle;
use super::problem::Problem;
use super::verify::Scales;
use linkage_runtime::Dimensions;

/// Optima whose dimensions differ by less than this part of the width of their bounds are one: in a
/// flat valley searches end some way from each other.
const DISTINCT: f64 = 0.02;

/// Searches of one problem, which depend on the number of their start alone.
pub(super) struct Descents<'d, M, A, const N: usize> {
    pub(super) problem: Problem<'d, M, A, N>,
    /// The change of each condition in a first step from the first mechanism.
    pub(super) reference: Option<Scales>,
    /// True if searches from the first mechanism begin within narrower bounds.
    pub(super) widening: bool,
    pub(super) seed: u64,
    pub(super) steps: usize,
    pub(super) stopped: &'d (dyn Fn() -> bool + Sync),
    /// In the modes of which assembly of the first mechanism.
    pub(super) assembly: usize,
}

/// A certified optimum.
pub(super) struct Optimum<M, A> {
    best: BestCycle<M, A>,
    /// The search that led here.
    pub(super) ended: Ended,
    /// The number of the assembly of the first mechanism that has the same modes.
    assembly: usize,
}

impl<M, A> Optimum<M, A> {
    /// Returns the value that the search makes least.
    pub(super) fn least(&self) -> f64 {
        self.ended.least
    }

    /// The parameters that vary come first.
    fn x(&self) -> &[f64] {
        &self.ended.at.x
    }
}

impl<M: Dimensions<N>, A, const N: usize> Descents<'_, M, A, N> {
    /// Searches from the dimensions of a start, of which the first are those of the first
    /// mechanism.
    pub(super) fn from(&self, index: usize) -> Result<Optimum<M, A>, DesignError> {
        let problem = &self.problem;
        let start = problem.start(&problem.limits, self.values(index))?;
        if index > 0 {
            let ended = self.descend(start)?;
            return self.certified(self.rounded(ended)?);
        }
        self.best_of(self.ladder(start)?)
    }

    /// The dimensions of a start.
    pub(super) fn values(&self, index: usize) -> Vec<f64> {
        if index == 0 {
            return self.problem.first();
        }
        let limits = &self.problem.limits;
        let unit = unit(self.seed, index, limits.lower.len());
        let bounds = limits.lower.iter().zip(&limits.upper);
        let parts = bounds
            .zip(unit)
            .map(|((low, high), part)| low + part * (high - low));
        parts.collect()
    }

    /// The best of some results that is certified.
    ///
    /// An optimum at a dead point is an error: there is none short of it.
    fn best_of(&self, results: Vec<Ended>) -> Result<Optimum<M, A>, DesignError> {
        let mut best: Option<Optimum<M, A>> = None;
        let mut first = None;
        for result in results {
            let settled = result.converged;
            let catalogues = !self.problem.catalogues.is_empty();
            match self.rounded(result).and_then(|ended| self.certified(ended)) {
                Ok(optimum)
                    if best
                        .as_ref()
                        .is_none_or(|best| optimum.least() < best.least()) =>
                {
                    best = Some(optimum);
                }
                Err(error @ DesignError::NotWhole(Interruption::DeadPoint(_)))
                    if settled && best.is_none() && first.is_none() =>
                {
                    return Err(error);
                }
                Err(error) => first = first.or(Some(error)),
                Ok(_) => {}
            }
            // The others come after the best one; values of catalogues may change that.
            if best.is_some() && !catalogues {
                break;
            }
        }
        best.ok_or_else(|| first.unwrap_or(DesignError::NotWhole(Interruption::Apart)))
    }

    /// Returns true if an assembly of the first mechanism is the one that these searches are in the
    /// modes of.
    pub(super) fn is_own(&self, assembly: &A) -> bool {
        let problem = &self.problem;
        let Ok(start) = problem.start(&problem.limits, problem.first()) else {
            return false;
        };
        let numbers = problem.tried(&start.x, |candidate| problem.known_by(&start, candidate));
        numbers.is_some_and(|numbers| problem.is_known(&start, &numbers, assembly))
    }

    /// With all parameters of catalogues at values of these.
    fn rounded(&self, ended: Ended) -> Result<Ended, DesignError> {
        let problem = &self.problem;
        if problem.catalogues.is_empty() {
            return Ok(ended);
        }
        let (mut steps, mut evaluations) = (ended.steps, ended.evaluations);
        let descend = |limits: &Limits, near: &Ended| {
            let values = near.at.x[..problem.varied.len()].to_vec();
            let mut start = problem.start(limits, values).ok()?;
            start.added.clone_from(&near.at.added);
            let ended = self.descend(start).ok()?;
            steps += ended.steps;
            evaluations += ended.evaluations;
            Some(ended)
        };
        let (lists, limits) = (&problem.catalogues, &problem.limits);
        let best = catalogue::rounded(lists, limits, ended, descend, self.stopped);
        let best = best.ok_or_else(|| DesignError::NoValues {
            parameters: problem.of_catalogues(),
        })?;
        Ok(Ended {
            steps,
            evaluations,
            ..best
        })
    }

    pub(super) fn certified(&self, ended: Ended) -> Result<Optimum<M, A>, DesignError> {
        let (problem, start, least) = (&self.problem, &ended.at, ended.least);
        let branch = problem.certify(start)?;
        let x = &start.x;
        let goal = problem
            .objectives
            .iter()
            .find(|objective| objective.is_goal());
        let best = BestCycle {
            mechanism: problem.mechanism(x),
            goal: goal.map_or(least, |objective| objective.reported_goal(least)),
            auxiliary: start
                .auxiliary
                .iter()
                .map(|indices| x[indices.clone()].to_vec())
                .collect(),
            margin: branch.margin,
            margin_at: branch.at,
            assembly: branch.assembly,
            at_bound: problem.at_bound(x),
            steps: ended.steps,
            evaluations: ended.evaluations,
            converged: ended.converged,
            hits: 1,
        };
        Ok(Optimum {
            best,
            ended,
            assembly: self.assembly,
        })
    }

    /// The distinct ones, the best first.
    pub(super) fn distinct(&self, mut optima: Vec<Optimum<M, A>>) -> Vec<BestCycle<M, A>> {
        optima.sort_by(|a, b| a.least().total_cmp(&b.least()));
        let mut kept: Vec<Optimum<M, A>> = Vec::new();
        let Limits { lower, upper, .. } = &self.problem.limits;
        // Neighbours in a catalogue are not the same, however near they are.
        let same = |a: &Optimum<M, A>, b: &Optimum<M, A>| {
            let mut values = self.problem.catalogues.iter().map(|(index, _)| *index);
            values.all(|index| a.x()[index] == b.x()[index])
        };
        let near = |a: &Optimum<M, A>, b: &Optimum<M, A>| {
            let places = a.x().iter().zip(b.x()).zip(lower.iter().zip(upper));
            let mut places = places.into_iter();
            same(a, b)
                && a.assembly == b.assembly
                && places.all(|((a, b), (low, high))| (a - b).abs() <= DISTINCT * (high - low))
        };
        for optimum in optima {
            match kept.iter_mut().find(|other| near(other, &optimum)) {
                Some(other) => other.best.hits += 1,
                None => kept.push(optimum),
            }
        }
        kept.into_iter().map(|optimum| optimum.best).collect()
    }
}
