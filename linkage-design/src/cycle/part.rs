//! Parts of a search of a whole cycle, for several processes.

mod serial;

use std::collections::BTreeMap;
use std::format;
use std::string::String;
use std::vec::Vec;

use super::super::DesignError;
use super::super::limits::Limits;
use super::super::numbered::{Identity, Numbered, missing};
use super::super::settings::Settings;
use super::descents::{Descents, Optimum};
use super::ended::Ended;
use super::problem::{Problem, SearchStart};
use linkage_runtime::Dimensions;

/// Starts in each assembly at which the values of two problems are compared.
const PROBES: usize = 3;

/// Ends of descents from some starts of a design problem of a whole cycle.
/// [`CycleDesign::descend`](crate::CycleDesign::descend) computes them, in any process;
/// [`CycleDesign::known`](crate::CycleDesign::known) takes them, so that these descents are not
/// made again.
///
/// Parts may come in any number and order: the optima are equal to those of one search, to the
/// last bit on equal processors. Each optimum is certified again where parts are taken.
#[derive(Clone, Debug, PartialEq)]
pub struct CyclePart {
    descents: Numbered<Descended>,
}

/// The end of a descent.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Descended {
    /// At an optimum.
    Optimum(SearchEnd),
    /// Without an optimum.
    Refused(Refusal),
}

/// Reasons for a descent without an optimum, as they are counted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Refusal {
    /// The objective with this number does not hold.
    OutOfReach(Option<usize>),
    /// Catalogues have no values near the optimum.
    NoValues,
    /// The mechanism does not run through its whole range.
    NotWhole,
    /// The search does not begin.
    NoStart,
}

/// An optimum with the state of its search, in numbers.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SearchEnd {
    x: Vec<f64>,
    bounds: [Vec<f64>; 2],
    reach: Vec<f64>,
    /// The number of variables of each objective.
    auxiliary: Vec<usize>,
    added: Vec<Vec<Vec<f64>>>,
    least: f64,
    steps: usize,
    evaluations: usize,
    converged: bool,
}

impl CyclePart {
    /// A part without descents, of the searches in the modes of all assemblies.
    pub(super) fn new<M: Dimensions<N>, A, const N: usize>(
        all: &[Descents<'_, M, A, N>],
        settings: &Settings<'_>,
    ) -> Self {
        let starts = settings.starts.max(1);
        let Problem {
            nominal,
            varied,
            limits,
            catalogues,
            range,
            closed,
            positions,
            objectives,
            assemble: _,
            circuits: _,
        } = &all[0].problem;
        let titles: Vec<_> = objectives.iter().map(|wanted| wanted.title()).collect();
        let numbers = (starts, settings.seed, settings.steps, positions, all.len());
        // Rust's notation of numbers is exact.
        let text = format!(
            "{numbers:?} {titles:?} {varied:?} {limits:?} {catalogues:?} {nominal:?} {range:?} {closed}"
        );
        let probe = |descents: &Descents<'_, M, A, N>, start: usize| {
            let value = probe(&descents.problem, descents.values(start));
            value.unwrap_or(f64::NAN)
        };
        let each = all
            .iter()
            .flat_map(|descents| (0..starts.min(PROBES)).map(move |k| probe(descents, k)));
        Self {
            descents: Numbered::new(Identity::new(starts * all.len(), &text, each.collect())),
        }
    }

    /// Adds the descents of another part of the same problem.
    ///
    /// # Errors
    ///
    /// `OtherProblem` if goal, conditions, variables, bounds, assemblies, starts, seed, steps or
    /// positions differ; `Repeated` if both have a descent. Nothing changes then.
    pub fn merge(&mut self, part: &Self) -> Result<(), DesignError> {
        self.descents.merge(&part.descents)
    }

    /// The number of starts that have been tried, each counted in all assemblies that are searched.
    #[must_use]
    pub fn done(&self) -> usize {
        self.descents.results.len()
    }

    /// The number of all starts of the problem, in all assemblies that are searched.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.descents.problem.starts
    }

    pub(super) fn missing(&self, part: [usize; 2]) -> Vec<usize> {
        missing(&self.descents.results, part, self.count())
    }

    pub(super) fn add(&mut self, number: usize, end: Descended) {
        self.descents.results.insert(number, end);
    }

    pub(super) fn into_ends(self) -> BTreeMap<usize, Descended> {
        self.descents.results
    }
}

/// The sizes of goal and conditions at some dimensions in one number.
fn probe<M: Dimensions<N>, A, const N: usize>(
    problem: &Problem<'_, M, A, N>,
    values: Vec<f64>,
) -> Option<f64> {
    let start = problem.start(&problem.limits, values).ok()?;
    let groups = problem.tried(&start.x, |candidate| {
        problem.asked(&start, &start.x, candidate)
    })?;
    let all = groups.conditions.iter().chain([&groups.objective]);
    let sizes = all.map(|rows| rows.iter().map(|row| row.value.abs()).fold(0.0, f64::max));
    Some(sizes.sum())
}

impl Descended {
    pub(super) fn new<M, A>(end: &Result<Optimum<M, A>, DesignError>, titles: &[String]) -> Self {
        match end {
            Ok(optimum) => Self::Optimum(SearchEnd::new(&optimum.ended)),
            Err(error) => Self::Refused(Refusal::new(error, titles)),
        }
    }
}

impl Refusal {
    /// The reason of an error, with the objective by its number.
    pub(super) fn new(error: &DesignError, titles: &[String]) -> Self {
        match error {
            DesignError::OutOfReach { objective, .. } => {
                Self::OutOfReach(titles.iter().position(|title| title == objective))
            }
            DesignError::NoValues { .. } => Self::NoValues,
            DesignError::NotWhole(_) => Self::NotWhole,
            _ => Self::NoStart,
        }
    }
}

impl SearchEnd {
    fn new(ended: &Ended) -> Self {
        let SearchStart {
            x,
            limits,
            reach,
            auxiliary,
            added,
        } = &ended.at;
        Self {
            x: x.clone(),
            bounds: [limits.lower.clone(), limits.upper.clone()],
            reach: reach.clone(),
            auxiliary: auxiliary.iter().map(ExactSizeIterator::len).collect(),
            added: added.clone(),
            least: ended.least,
            steps: ended.steps,
            evaluations: ended.evaluations,
            converged: ended.converged,
        }
    }

    /// The search as it ended; `None` if the numbers of variables are not those of a problem.
    pub(super) fn ended<M, A, const N: usize>(
        self,
        problem: &Problem<'_, M, A, N>,
    ) -> Option<Ended> {
        let [lower, upper] = self.bounds;
        let mut first = problem.varied.len();
        let ranges = self.auxiliary.iter().map(|count| {
            let range = first..first + count;
            first = range.end;
            range
        });
        let auxiliary: Vec<_> = ranges.collect();
        let lists = [&self.x, &lower, &upper, &self.reach];
        let objectives = problem.objectives.len();
        let fits = lists.iter().all(|list| list.len() == first)
            && [auxiliary.len(), self.added.len()] == [objectives; 2];
        fits.then(|| Ended {
            at: SearchStart {
                x: self.x,
                limits: Limits {
                    lower,
                    upper,
                    relations: problem.limits.relations.clone(),
                },
                reach: self.reach,
                auxiliary,
                added: self.added,
            },
            least: self.least,
            steps: self.steps,
            evaluations: self.evaluations,
            converged: self.converged,
        })
    }
}
