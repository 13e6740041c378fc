//! The search of a design problem of a whole cycle.

use core::ops::Range;
use linkage_core::Cycle;
use std::boxed::Box;
use std::string::ToString;
use std::vec;
use std::vec::Vec;

use super::super::DesignError;
use super::super::rounds::in_rounds;
use super::super::settings::{End, Report};
use super::super::varied::Varied;
use super::CycleObjective;
use super::builder::CycleDesign;
use super::descents::{Descents, Optimum};
use super::found::BestCycle;
use super::problem::{Assemble, Problem};
use linkage_runtime::{Circuits, Dimensions};

/// All that is wanted.
pub(super) type Objectives<'w, M, A, const N: usize> = [&'w (dyn CycleObjective<M, A, N> + 'w)];

/// A checked problem.
pub(super) struct Checked<A> {
    varied: Varied,
    pub(super) circuits: Circuits<A>,
}

impl<'a, M, A, const N: usize> CycleDesign<'a, M, A, N>
where
    M: Dimensions<N> + Copy + Send + Sync,
    A: Send + Sync,
{
    /// Searches for the best mechanism.
    ///
    /// The result is verified by the assembled mechanism, and not worse than the first mechanism,
    /// if that holds all conditions.
    ///
    /// # Errors
    ///
    /// All mistakes of the problem at once; `StartNotWhole` or `NoStart` if the search has nowhere
    /// to begin; `OutOfReach` with the condition that cannot be held, by how much it is missed, and
    /// the bounds that are in the way; `NotWhole` if the optimum does not run through the whole
    /// range on one circuit.
    pub fn run(self) -> Result<BestCycle<M, A>, DesignError> {
        Ok(self.run_all()?.swap_remove(0))
    }

    /// Searches from all starts, with feature `rayon` on all threads, and lists the distinct optima
    /// that hold the conditions, the best first.
    ///
    /// Equal seeds give equal optima on any number of threads, unless time limit or cancellation
    /// end the search.
    ///
    /// # Errors
    ///
    /// As [`run`](Self::run); `NotFound`, with the number of starts for each reason of refusal, if
    /// several were begun and none leads to an optimum.
    pub fn run_all(mut self) -> Result<Vec<BestCycle<M, A>>, DesignError> {
        let end = self.settings.end();
        let mut report = self.settings.progress.take();
        let objectives: Vec<_> = self.objectives.iter().map(Box::as_ref).collect();
        let checked = self.checked(&objectives)?;
        let starts = self.settings.starts.max(1);
        self.searched(
            &checked,
            &objectives,
            (&self.nominal, starts, true),
            &end,
            &mut report,
        )
    }

    /// Searches for the objectives from a mechanism, which is the first of so many starts;
    /// `widening` begins within narrower bounds there.
    pub(super) fn searched(
        &self,
        checked: &Checked<A>,
        objectives: &Objectives<'_, M, A, N>,
        (first, starts, widening): (&M, usize, bool),
        end: &End<'_>,
        report: &mut Option<Report<'a>>,
    ) -> Result<Vec<BestCycle<M, A>>, DesignError> {
        let stopped = || end.reached();
        let (assembled, first_assembly) = (&*self.assemble, &self.assembly);
        let assemble = |near: &A, mechanism: &M| assembled(mechanism, near);
        let same_modes = |mechanism: &M| assemble(first_assembly, mechanism);
        let descents = |assembly: usize, assemble| {
            let problem = self.problem(checked, objectives, first, assemble);
            let start = problem.start(&problem.limits, problem.first());
            Descents {
                reference: start.ok().and_then(|start| problem.scales(&start)),
                widening,
                seed: self.settings.seed,
                steps: self.settings.steps,
                stopped: &stopped,
                assembly,
                problem,
            }
        };
        let mut all = vec![descents(0, &same_modes as &Assemble<'_, M, A>)];
        // The assembly that is there is among the branches, if it runs through the whole range.
        let branches = checked.circuits.whole().filter(|_| self.all_assemblies);
        let others = branches
            .map(|branch| &branch.assembly)
            .filter(|assembly| !all[0].is_own(assembly));
        let others: Vec<_> = others
            .map(|near| move |mechanism: &M| assemble(near, mechanism))
            .collect();
        for (k, other) in others.iter().enumerate() {
            all.push(descents(k + 1, other));
        }
        // The first start is always begun: the mechanism that is there may be all that is found in
        // time.
        let from = |starts: Range<usize>| {
            let (start, assembly) = (starts.start / all.len(), starts.start % all.len());
            (starts.start == 0 || !stopped()).then(|| all[assembly].from(start))
        };
        let least = |found: &Option<Result<Optimum<M, A>, _>>| match found {
            Some(Ok(optimum)) => optimum.least(),
            _ => f64::INFINITY,
        };
        let ended = |done: usize| done > 0 && stopped();
        let each: Vec<_> = (0..all.len() * starts).map(|k| k..k + 1).collect();
        let (found, _) = in_rounds(&each, &ended, report, from, least);
        let (mut optima, mut refused) = (Vec::new(), Vec::new());
        for found in found.into_iter().flatten() {
            match found {
                Ok(optimum) => optima.push(optimum),
                Err(error) => refused.push(error),
            }
        }
        match optima.is_empty() {
            true => Err(all[0].refusals(refused)),
            false => Ok(all[0].distinct(optima)),
        }
    }

    fn problem<'p>(
        &'p self,
        checked: &Checked<A>,
        objectives: &'p Objectives<'p, M, A, N>,
        first: &M,
        assemble: &'p Assemble<'p, M, A>,
    ) -> Problem<'p, M, A, N> {
        let cycle = &checked.circuits.cycle;
        Problem {
            nominal: first.values(),
            varied: checked.varied.indices.clone(),
            limits: checked.varied.limits.clone(),
            catalogues: checked.varied.catalogues.clone(),
            range: (cycle.low, cycle.high),
            closed: cycle.turn().is_some(),
            positions: self.positions,
            objectives,
            assemble,
            circuits: &*self.circuits,
        }
    }

    /// Returns the variables with their limits, and all assemblies of the first mechanism; or all
    /// mistakes.
    pub(super) fn checked(
        &self,
        objectives: &Objectives<'_, M, A, N>,
    ) -> Result<Checked<A>, DesignError> {
        let circuits = (self.circuits)(&self.nominal).map_err(DesignError::Start)?;
        let cycle: &Cycle = &circuits.cycle;
        let mut varied = self.freedom.varied(M::PARAMETERS, &self.nominal.values());
        let mut errors = core::mem::take(&mut varied.errors);
        let goals = objectives.iter().filter(|objective| objective.is_goal());
        let goals: Vec<_> = goals.map(|objective| objective.title()).collect();
        if goals.len() != 1 {
            errors.push(DesignError::Goals { goals });
        }
        if self.positions < 2 {
            let what = "less than two positions";
            errors.push(DesignError::Nothing {
                what,
                objective: "a design problem".to_string(),
            });
        }
        for objective in objectives {
            errors.extend(objective.check(cycle, M::PARAMETERS, &varied.indices));
        }
        DesignError::all(errors)?;
        let names = varied.indices.iter().map(|&k| M::PARAMETERS[k].name);
        let names: Vec<_> = names.collect();
        self.freedom.consistent(&varied.limits, &names)?;
        Ok(Checked { varied, circuits })
    }
}
