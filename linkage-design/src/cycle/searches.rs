//! Searches from all starts, in the modes of all assemblies of the first mechanism.

use core::ops::Range;
use std::boxed::Box;
use std::collections::BTreeMap;
use std::string::String;
use std::vec;
use std::vec::Vec;

use super::super::numbered::missing;
use super::super::refusals::{Fate, Tally};
use super::super::rounds::in_rounds;
use super::super::settings::{End, Report};
use super::super::varied::Varied;
use super::super::{DesignError, Refusals};
use super::CycleObjective;
use super::builder::CycleDesign;
use super::descents::{Descents, Optimum};
use super::found::BestCycle;
use super::part::{CyclePart, Descended, Refusal};
use super::problem::{Assemble, Problem};
use linkage_runtime::{Circuits, Dimensions};

/// The begin of searches.
pub(super) struct Beginning<'b, M> {
    /// The mechanism that is the first start.
    pub(super) first: &'b M,
    /// The number of starts.
    pub(super) starts: usize,
    /// True if searches from the first mechanism begin within narrower bounds.
    pub(super) widening: bool,
    /// The part of the starts, and the number of parts.
    pub(super) part: [usize; 2],
    /// Descents that are not made again.
    pub(super) known: &'b [CyclePart],
}

/// The end of a search.
type Found<M, A> = Result<Optimum<M, A>, DesignError>;

/// The end of a search, which may be known from a part: then a reason comes without its error.
type Outcome<M, A> = Result<Optimum<M, A>, (Refusal, Option<Box<DesignError>>)>;

/// All that is wanted.
pub(super) type Objectives<'w, M, A, const N: usize> = [&'w (dyn CycleObjective<M, A, N> + 'w)];

/// A checked problem.
pub(super) struct Checked<A> {
    pub(super) varied: Varied,
    pub(super) circuits: Circuits<A>,
}

/// The searches of a checked problem.
pub(super) struct Searches<'s, 'a, M, A, const N: usize> {
    pub(super) design: &'s CycleDesign<'a, M, A, N>,
    pub(super) checked: &'s Checked<A>,
    pub(super) objectives: &'s Objectives<'s, M, A, N>,
}

impl<M, A, const N: usize> Searches<'_, '_, M, A, N>
where
    M: Dimensions<N> + Copy + Send + Sync,
    A: Send + Sync,
{
    /// Searches for the objectives from some starts.
    pub(super) fn searched(
        &self,
        beginning: &Beginning<'_, M>,
        end: &End<'_>,
        report: &mut Option<Report<'_>>,
    ) -> Result<Vec<BestCycle<M, A>>, DesignError> {
        let stopped = || end.reached();
        self.with_descents(beginning, &stopped, |all| {
            let titles = titles(self.objectives);
            let known = self.known_ends(all, beginning.known)?;
            let missing = missing(&known, beginning.part, all.len() * beginning.starts);
            // The first start is always begun: the mechanism that is there may be all that is found
            // in time.
            let begun = |number: usize| number == 0 || !stopped();
            let from = |number: usize| begun(number).then(|| search(all, number));
            let ended = |done: usize| (done > 0 || !known.is_empty()) && stopped();
            let found = in_order(&missing, &ended, report, from);
            let known = known
                .into_iter()
                .map(|(number, end)| (number, restored(all, number, end, &titles)));
            let found = found.into_iter().map(|(number, found)| {
                let named = |error| (Refusal::new(&error, &titles), Some(Box::new(error)));
                (number, found.map_err(named))
            });
            best(all, known.chain(found).collect(), titles.clone())
        })
    }

    /// Makes the descents of a part that are missing.
    pub(super) fn descended(
        &self,
        beginning: &Beginning<'_, M>,
        end: &End<'_>,
        report: &mut Option<Report<'_>>,
    ) -> Result<CyclePart, DesignError> {
        let stopped = || end.reached();
        self.with_descents(beginning, &stopped, |all| {
            let titles = titles(self.objectives);
            let mut part = self.united(all, beginning.known)?;
            let missing = part.missing(beginning.part);
            // A search that is ended early has another end in a search without a limit.
            let from = |number: usize| {
                let found = (!stopped()).then(|| search(all, number));
                found.filter(|_| !stopped())
            };
            for (number, found) in in_order(&missing, &|_| stopped(), report, from) {
                part.add(number, Descended::new(&found, &titles));
            }
            Ok(part)
        })
    }

    fn known_ends(
        &self,
        all: &[Descents<'_, M, A, N>],
        parts: &[CyclePart],
    ) -> Result<BTreeMap<usize, Descended>, DesignError> {
        if parts.is_empty() {
            return Ok(BTreeMap::new());
        }
        Ok(self.united(all, parts)?.into_ends())
    }

    /// The descents of all parts.
    fn united(
        &self,
        all: &[Descents<'_, M, A, N>],
        parts: &[CyclePart],
    ) -> Result<CyclePart, DesignError> {
        let mut united = CyclePart::new(all, &self.design.settings);
        parts.iter().try_for_each(|part| united.merge(part))?;
        Ok(united)
    }

    /// Passes the searches in the modes of each assembly to `then`: the first ones are in the modes
    /// of the first mechanism.
    fn with_descents<R>(
        &self,
        beginning: &Beginning<'_, M>,
        stopped: &(dyn Fn() -> bool + Sync),
        then: impl FnOnce(&[Descents<'_, M, A, N>]) -> R,
    ) -> R {
        let (assembled, first_assembly) = (&*self.design.assemble, &self.design.assembly);
        let assemble = |near: &A, mechanism: &M| assembled(mechanism, near);
        let same_modes = |mechanism: &M| assemble(first_assembly, mechanism);
        let descents = |assembly: usize, assemble| {
            let problem = self.problem(beginning.first, assemble);
            let start = problem.start(&problem.limits, problem.first());
            Descents {
                reference: start.ok().and_then(|start| problem.scales(&start)),
                widening: beginning.widening,
                seed: self.design.settings.seed,
                steps: self.design.settings.steps,
                stopped,
                assembly,
                problem,
            }
        };
        let mut all = vec![descents(0, &same_modes as &Assemble<'_, M, A>)];
        // The assembly that is there is among the branches, if it runs through the whole range.
        let branches = self
            .checked
            .circuits
            .whole()
            .filter(|_| self.design.all_assemblies);
        let others = branches
            .map(|branch| &branch.assembly)
            .filter(|assembly| !all[0].is_own(assembly));
        let others: Vec<_> = others
            .map(|near| move |mechanism: &M| assemble(near, mechanism))
            .collect();
        for (k, other) in others.iter().enumerate() {
            all.push(descents(k + 1, other));
        }
        then(&all)
    }

    fn problem<'p>(&'p self, first: &M, assemble: &'p Assemble<'p, M, A>) -> Problem<'p, M, A, N> {
        let cycle = &self.checked.circuits.cycle;
        Problem {
            nominal: first.values(),
            varied: self.checked.varied.indices.clone(),
            limits: self.checked.varied.limits.clone(),
            catalogues: self.checked.varied.catalogues.clone(),
            range: (cycle.low, cycle.high),
            closed: cycle.turn().is_some(),
            positions: self.design.positions,
            objectives: self.objectives,
            assemble,
            circuits: &*self.design.circuits,
        }
    }
}

fn titles<M, A, const N: usize>(objectives: &Objectives<'_, M, A, N>) -> Vec<String> {
    objectives.iter().map(|wanted| wanted.title()).collect()
}

/// Makes a search: all assemblies take turns with the same start.
fn search<M: Dimensions<N>, A, const N: usize>(
    all: &[Descents<'_, M, A, N>],
    number: usize,
) -> Found<M, A> {
    all[number % all.len()].from(number / all.len())
}

/// Returns the results of searches with their numbers, without those that `from` has none of.
fn in_order<M: Send, A: Send>(
    numbers: &[usize],
    ended: &dyn Fn(usize) -> bool,
    report: &mut Option<Report<'_>>,
    from: impl Fn(usize) -> Option<Found<M, A>> + Send + Sync,
) -> Vec<(usize, Found<M, A>)> {
    let each: Vec<_> = numbers.iter().map(|&number| number..number + 1).collect();
    let least = |found: &Option<Found<M, A>>| match found {
        Some(Ok(optimum)) => optimum.least(),
        _ => f64::INFINITY,
    };
    let from = |number: Range<usize>| from(number.start);
    let (found, _) = in_rounds(&each, ended, report, from, least);
    let found = numbers.iter().zip(found);
    found
        .filter_map(|(&number, found)| Some((number, found?)))
        .collect()
}

/// Certifies a known optimum again.
fn restored<M: Dimensions<N>, A, const N: usize>(
    all: &[Descents<'_, M, A, N>],
    number: usize,
    end: Descended,
    titles: &[String],
) -> Outcome<M, A> {
    let optimum = match end {
        Descended::Optimum(optimum) => optimum,
        Descended::Refused(refusal) => return Err((refusal, None)),
    };
    let descents = &all[number % all.len()];
    let ended = optimum.ended(&descents.problem);
    let certified = ended.map_or(Err(DesignError::OtherProblem), |ended| {
        descents.certified(ended)
    });
    certified.map_err(|error| (Refusal::new(&error, titles), Some(Box::new(error))))
}

/// Lists the distinct optima of all searches, or the reasons why there is none.
fn best<M: Dimensions<N>, A, const N: usize>(
    all: &[Descents<'_, M, A, N>],
    outcomes: BTreeMap<usize, Outcome<M, A>>,
    titles: Vec<String>,
) -> Result<Vec<BestCycle<M, A>>, DesignError> {
    let (mut optima, mut refused) = (Vec::new(), Vec::new());
    for (number, outcome) in outcomes {
        match outcome {
            Ok(optimum) => optima.push(optimum),
            Err((refusal, error)) => refused.push((number, refusal, error)),
        }
    }
    if !optima.is_empty() {
        return Ok(all[0].distinct(optima));
    }
    // Parts have no numbers of refused searches: those of the first one are found again.
    let first = refused.first_mut().and_then(|(number, _, error)| {
        let known = error.take();
        known.or_else(|| search(all, *number).err().map(Box::new))
    });
    let reasons = refused.iter().map(|(_, refusal, _)| *refusal).collect();
    Err(refusals(reasons, first, titles))
}

/// The error of searches of which none leads to an optimum.
fn refusals(
    reasons: Vec<Refusal>,
    first: Option<Box<DesignError>>,
    titles: Vec<String>,
) -> DesignError {
    let first = match (reasons.len(), first) {
        (1, Some(first)) => return *first,
        (_, first) => first,
    };
    let mut tally = Tally::default();
    let (mut no_values, mut not_whole) = (0, 0);
    for reason in &reasons {
        match reason {
            Refusal::OutOfReach(objective) => {
                tally.begun(&Fate::Broken(objective.iter().copied().collect()));
            }
            Refusal::NoValues => no_values += 1,
            Refusal::NotWhole => not_whole += 1,
            Refusal::NoStart => tally.begun(&Fate::Open),
        }
    }
    let refusals = tally.refusals(reasons.len(), Vec::new(), titles);
    DesignError::NotFound(Box::new(Refusals {
        no_values,
        not_whole,
        first,
        ..refusals
    }))
}
