//! Designs from local optima: rounded to values of catalogues, then certified over the whole range,
//! on all threads.

use std::string::{String, ToString};
use std::vec::Vec;

use super::FoundDesign;
use super::builder::CircuitsOf;
use super::catalogue::rounded;
use super::certificate::{Interrupted, Interruption};
use super::limits::Limits;
use super::normal::Normal;
use super::optimum::Optimum;
use super::parallel::in_parallel;
use super::problem::{Evaluator, Problem};
use super::proof::certify_optimum;
use super::search::{distinct, refine};
use super::settings::End;
use super::varied::Freedom;
use linkage_runtime::DimensionSet;

/// The inputs of designs.
pub(super) struct Results<'d, M, A, const N: usize> {
    pub(super) problem: &'d Problem<'d, M, A, N>,
    pub(super) assemblies: &'d [A],
    pub(super) circuits: &'d CircuitsOf<'d, M, A>,
    pub(super) freedom: &'d Freedom,
    /// The most evaluations of a descent.
    pub(super) steps: usize,
    /// The most designs that are listed.
    pub(super) listed: usize,
}

/// Why an optimum is no design.
pub(super) enum Refused {
    /// It does not run through its whole range.
    NotWhole(Interruption),
    /// In the assembly that would be returned this is missed, by so much.
    Violates(String, f64),
}

/// Optima that are certified side by side.
const CERTIFIED: usize = 16;

/// Optima with values of catalogues.
#[derive(Default)]
pub(super) struct Rounded {
    pub(super) optima: Vec<Optimum>,
    /// Optima near which no values hold all conditions.
    pub(super) no_values: usize,
    /// True if it ended before all combinations that might be better were tried.
    pub(super) ended: bool,
}

/// Optima that were looked at over the whole range.
pub(super) struct Certified<M, A> {
    pub(super) designs: Vec<FoundDesign<M, A>>,
    pub(super) not_whole: usize,
    /// The one with the least sum that is not whole.
    pub(super) nearest: Option<Interrupted>,
    /// Optima that violate a condition or relation in the assembly that would be returned.
    pub(super) unverified: usize,
    /// The one of these with the least sum: its worst condition or relation, and the size of the
    /// violation.
    pub(super) violated: Option<(String, f64)>,
    /// Optima that were not looked at.
    pub(super) left_out: usize,
    /// True if this is because the search was to end.
    pub(super) ended: bool,
}

impl<M, A> Default for Certified<M, A> {
    fn default() -> Self {
        Self {
            designs: Vec::new(),
            not_whole: 0,
            nearest: None,
            unverified: 0,
            violated: None,
            left_out: 0,
            ended: false,
        }
    }
}

impl<M, A> Certified<M, A> {
    /// Adds a design that is better than all others, in a list of so many.
    pub(super) fn add(&mut self, better: Option<FoundDesign<M, A>>, listed: usize) {
        if let Some(better) = better.filter(|_| listed > 0) {
            self.designs.insert(0, better);
            self.left_out += self.designs.len().saturating_sub(listed);
            self.designs.truncate(listed);
        }
    }
}

impl<'d, M, A, const N: usize> Results<'d, M, A, N>
where
    M: DimensionSet<N> + Copy + Send + Sync,
    A: Clone + Send + Sync,
{
    /// The optima with all catalogue parameters at values of their lists.
    pub(super) fn rounded(&self, optima: Vec<Optimum>, end: &End<'_>) -> Rounded {
        let problem = self.problem;
        if problem.catalogues.is_empty() {
            return Rounded {
                optima,
                ..Rounded::default()
            };
        }
        let ended = || end.is_over();
        let all = in_parallel(&optima, |optimum| {
            let mut evaluator = Evaluator::new(problem);
            let mode = (&self.assemblies[optimum.assembly], self.steps);
            let descend = |limits: &Limits, near: &Optimum| {
                refine(near, limits, problem, &mut evaluator, mode)
            };
            let (lists, limits) = (&problem.catalogues, &problem.limits);
            let best = rounded(lists, limits, optimum.clone(), descend, &ended);
            (best, ended())
        });
        let ended = all.iter().any(|(_, ended)| *ended);
        let none = all.iter().filter(|(best, ended)| best.is_none() && !ended);
        Rounded {
            no_values: none.count(),
            ended,
            optima: distinct(
                all.into_iter().filter_map(|(best, _)| best).collect(),
                &problem.widths(),
                &problem.periods(),
            ),
        }
    }

    /// The first optima that run through the whole range, as many as are listed. When the search is
    /// to end those that are being looked at are the last ones.
    pub(super) fn certified(&self, optima: &[Optimum], end: &End<'_>) -> Certified<M, A> {
        let mut certified = Certified::default();
        let mut seen = 0;
        for some in optima.chunks(CERTIFIED) {
            let full = certified.designs.len() >= self.listed;
            certified.ended = !full && seen > 0 && end.is_over();
            if full || certified.ended {
                break;
            }
            let all = in_parallel(some, |optimum| {
                self.found(&mut Evaluator::new(self.problem), optimum)
            });
            for (optimum, found) in some.iter().zip(all) {
                if certified.designs.len() == self.listed {
                    break;
                }
                seen += 1;
                match found {
                    Ok(found) => certified.designs.push(found),
                    Err(Refused::Violates(what, by)) => {
                        certified.unverified += 1;
                        certified.violated.get_or_insert((what, by));
                    }
                    Err(Refused::NotWhole(why)) => {
                        certified.not_whole += 1;
                        let sum = optimum.sum;
                        // The least one comes first.
                        certified.nearest.get_or_insert(Interrupted { sum, why });
                    }
                }
            }
        }
        certified.left_out = optima.len() - seen;
        // The order is that of the sums of the returned assemblies, whatever the descents claim.
        certified.designs.sort_by(|a, b| a.sum.total_cmp(&b.sum));
        certified
    }

    /// The design of an optimum, with directions within their bounds where relations and conditions
    /// allow it.
    pub(super) fn found(
        &self,
        evaluator: &mut Evaluator<'_, M, A, N>,
        optimum: &Optimum,
    ) -> Result<FoundDesign<M, A>, Refused> {
        let wrapped = self.problem.wrapped(optimum);
        match self.verified(evaluator, &wrapped) {
            // A relation between angles need not be the same after a turn of one of them.
            Err(Refused::Violates(..)) if wrapped.x != optimum.x => {
                self.verified(evaluator, optimum)
            }
            result => result,
        }
    }

    /// Checks bounds, relations and conditions. The error has the one that is missed most.
    fn must_hold(&self, x: &[f64], at: &Normal) -> Result<(), Refused> {
        let problem = self.problem;
        let limits = &problem.limits;
        if let Some((k, by)) = limits.worst(x) {
            let relation = self.freedom.relations().into_iter().nth(k);
            let order = || "the order of the inputs".to_string();
            return Err(Refused::Violates(relation.unwrap_or_else(order), by));
        }
        if !limits.bound(x) || !at.sum.is_finite() {
            return Err(Refused::NotWhole(Interruption::Apart));
        }
        let violations = problem.violations(at).into_iter();
        match violations.max_by(|a, b| a.part.total_cmp(&b.part)) {
            Some(worst) => Err(Refused::Violates(
                problem.objectives[worst.objective].title(),
                worst.by,
            )),
            None => Ok(()),
        }
    }

    /// The design, if it is there over the whole range and holds all that must hold: computed from
    /// its assembly, without the descent.
    fn verified(
        &self,
        evaluator: &mut Evaluator<'_, M, A, N>,
        optimum: &Optimum,
    ) -> Result<FoundDesign<M, A>, Refused> {
        let problem = self.problem;
        let assembly = &self.assemblies[optimum.assembly];
        let branch = certify_optimum(problem, evaluator, assembly, optimum, self.circuits)
            .map_err(Refused::NotWhole)?;
        evaluator.evaluate(&branch.assembly, core::iter::once(&optimum.x[..]));
        let mut normal = Normal::new(problem.limits.len());
        evaluator.normal(0, &mut normal);
        self.must_hold(&optimum.x, &normal)?;
        let objectives = 0..problem.objectives.len();
        let rows = |objective: usize| {
            let rows = evaluator.rows(objective);
            (0..rows.count()).map(|row| rows.row(0, row).0).collect()
        };
        let residuals: Vec<Vec<f64>> = objectives.clone().map(rows).collect();
        let farthest = |k: usize| {
            let (objective, rows) = (&problem.objectives[k], residuals[k].iter().enumerate());
            let farthest = rows.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
            let (row, value) = farthest.filter(|_| !objective.is_condition())?;
            Some(objective.missed(row, *value))
        };
        let inputs = |objective: usize| {
            problem.objectives[objective]
                .inputs(&optimum.x[problem.inputs(objective)], &problem.cycle)
        };
        let bound = |j: usize| {
            [problem.limits.lower[j], problem.limits.upper[j]]
                .into_iter()
                .find(|bound| *bound == optimum.x[j])
        };
        let active: Vec<(usize, f64)> = (0..problem.varied.len())
            .filter_map(|j| Some((j, bound(j)?)))
            .collect();
        Ok(FoundDesign {
            mechanism: problem.mechanism(&optimum.x),
            sum: normal.sum,
            objectives: problem
                .objectives
                .iter()
                .map(|objective| objective.title())
                .collect(),
            farthest: objectives.clone().map(farthest).collect(),
            residuals,
            inputs: objectives.map(inputs).collect(),
            margin: branch.margin,
            margin_at: branch.at,
            at_bound: active
                .iter()
                .map(|&(j, bound)| (problem.parameter(j).name, bound))
                .collect(),
            bound_units: active
                .iter()
                .map(|&(j, _)| problem.parameter(j).unit)
                .collect(),
            active_relations: self.freedom.active(&problem.limits, &optimum.x),
            active_conditions: problem.active(&normal),
            bound_slopes: active.iter().map(|&(j, _)| normal.gradient[j]).collect(),
            assembly: branch.assembly,
            converged: optimum.converged,
            start: optimum.start,
            hits: optimum.hits,
        })
    }
}
