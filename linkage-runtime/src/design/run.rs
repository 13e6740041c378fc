//! The search of a design problem.

use alloc::boxed::Box;
use alloc::vec::Vec;
use core::ops::Range;

use super::builder::Design;
use super::catalogue::rounded;
use super::certificate::{Interrupted, Interruption, certify};
use super::limits::Limits;
use super::problem::{Evaluator, Problem};
use super::rounds::in_rounds;
use super::search::{BLOCK, Block, Optimum, block, distinct};
use super::settings::Report;
use super::{DesignError, Found, Refusals, Search};
use crate::Dimensions;

impl<'a, M, A, const N: usize> Design<'a, M, A, N>
where
    M: Dimensions<N> + Copy + Send + Sync,
    A: Clone + Send + Sync,
{
    /// Searches from all starts, and lists all distinct local optima that hold what must hold.
    ///
    /// Equal seeds give equal designs on any number of threads, unless time limit or cancellation end the search.
    ///
    /// # Errors
    ///
    /// All mistakes of the problem at once; `NotFound` if no start led to a mechanism that runs through its whole range.
    pub fn run(mut self) -> Result<Search<M, A>, DesignError> {
        let mut progress = self.settings.progress.take();
        let problem = self.problem()?;
        let (blocks, ended_early) = self.search(&problem, &mut progress);
        let starts = self.settings.starts.min(blocks.len() * BLOCK);
        let mut total = Block::default();
        for block in blocks {
            total.tally.add(&block.tally);
            total.evaluations += block.evaluations;
            total.optima.extend(block.optima);
        }
        let mut optima = distinct(total.optima, &problem.widths(), &problem.periods());
        let mut evaluator = Evaluator::new(&problem);
        let mut no_values = 0;
        if !problem.catalogues.is_empty() {
            optima.truncate(self.listed);
            let round = |optimum: Optimum| {
                let mode = (&self.assemblies[optimum.assembly], self.settings.steps);
                let descend = |limits: &Limits, near: &Optimum| {
                    near.within(limits, &problem, &mut evaluator, mode)
                };
                rounded(&problem.catalogues, &problem.limits, optimum, descend)
            };
            let count = optima.len();
            let all: Vec<Optimum> = optima.into_iter().filter_map(round).collect();
            no_values = count - all.len();
            optima = distinct(all, &problem.widths(), &problem.periods());
        }
        let (mut designs, mut not_whole, mut nearest) = (Vec::new(), 0, None);
        for optimum in &optima {
            if designs.len() == self.listed {
                break;
            }
            match self.found(&problem, &mut evaluator, optimum) {
                Ok(found) => designs.push(found),
                Err(why) => {
                    not_whole += 1;
                    let sum = optimum.sum;
                    // The least one comes first.
                    nearest.get_or_insert(Interrupted { sum, why });
                }
            }
        }
        let Block {
            tally, evaluations, ..
        } = total;
        if designs.is_empty() {
            let titles = self.wishes.iter().map(|wish| wish.title()).collect();
            let refusals = tally.refusals(starts, self.freedom.relations(), titles);
            return Err(DesignError::NotFound(Box::new(Refusals {
                no_values,
                not_whole,
                nearest,
                ..refusals
            })));
        }
        Ok(Search {
            designs,
            starts,
            refused: tally.refused,
            open: tally.open,
            broken: tally.broken,
            not_whole,
            evaluations,
            ended_early,
            residuals: problem.residuals(),
            variables: problem.limits.len(),
        })
    }

    /// All blocks that were run, and whether some were not.
    fn search(
        &self,
        problem: &Problem<'_, M, A, N>,
        progress: &mut Option<Report<'a>>,
    ) -> (Vec<Block>, bool) {
        let (seed, steps) = (self.settings.seed, self.settings.steps);
        let assemblies = &self.assemblies;
        let run = |starts: Range<usize>| block(problem, assemblies, seed, starts, steps);
        let least = |block: &Block| {
            let sums = block.optima.iter().map(|optimum| optimum.sum);
            sums.fold(f64::INFINITY, f64::min)
        };
        let end = self.settings.end();
        in_rounds(
            (self.settings.starts, BLOCK),
            &|_| end.reached(),
            progress,
            run,
            least,
        )
    }

    fn found(
        &self,
        problem: &Problem<'_, M, A, N>,
        evaluator: &mut Evaluator<'_, M, A, N>,
        optimum: &Optimum,
    ) -> Result<Found<M, A>, Interruption> {
        let assembly = &self.assemblies[optimum.assembly];
        let optimum = &problem.wrapped(optimum);
        let branch = certify(problem, evaluator, assembly, optimum, &*self.circuits)?;
        evaluator.evaluate(&branch.assembly, core::iter::once(&optimum.x[..]));
        let mut normal = super::normal::Normal::new(problem.limits.len());
        evaluator.normal(0, &mut normal);
        let wishes = 0..problem.wishes.len();
        let rows = |wish: usize| {
            let rows = evaluator.rows(wish);
            (0..rows.count()).map(|row| rows.row(0, row).0).collect()
        };
        let inputs = |wish: usize| {
            problem.wishes[wish].inputs(&optimum.x[problem.inputs(wish)], &problem.cycle)
        };
        let bound = |j: usize| {
            [problem.limits.lower[j], problem.limits.upper[j]]
                .into_iter()
                .find(|bound| *bound == optimum.x[j])
        };
        let active: Vec<(usize, f64)> = (0..problem.varied.len())
            .filter_map(|j| Some((j, bound(j)?)))
            .collect();
        Ok(Found {
            mechanism: problem.mechanism(&optimum.x),
            sum: normal.sum,
            wishes: problem.wishes.iter().map(|wish| wish.title()).collect(),
            residuals: wishes.clone().map(rows).collect(),
            inputs: wishes.map(inputs).collect(),
            margin: branch.margin,
            margin_at: branch.at,
            at_bound: active
                .iter()
                .map(|&(j, bound)| (M::PARAMETERS[problem.varied[j]].name, bound))
                .collect(),
            bound_slopes: active.iter().map(|&(j, _)| normal.gradient[j]).collect(),
            assembly: branch.assembly,
            converged: optimum.converged,
            start: optimum.start,
            hits: optimum.hits,
        })
    }
}
