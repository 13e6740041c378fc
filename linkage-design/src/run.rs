//! The search of a design problem.

use core::ops::Range;
use std::boxed::Box;
use std::vec::Vec;

use super::builder::Design;
use super::problem::Problem;
use super::results::Results;
use super::rounds::in_rounds;
use super::search::{BLOCK, Block, block, distinct};
use super::settings::{End, Report};
use super::{DesignError, DesignSearch, Refusals};
use linkage_runtime::DimensionSet;

impl<'a, M, A, const N: usize> Design<'a, M, A, N>
where
    M: DimensionSet<N> + Copy + Send + Sync,
    A: Clone + Send + Sync,
{
    /// Searches from all starts, and lists all distinct local optima that hold the conditions.
    ///
    /// Each is verified without the descent that led to it: bounds, relations, conditions and the
    /// sum of squares are computed from the assembly that is returned. A condition may be missed by
    /// a millionth of the mean size of its own number at most. Where inputs are given, the best is
    /// never worse than the declared mechanism, if that holds all that must hold.
    ///
    /// Equal seeds give equal designs on any number of threads, unless time limit or cancellation
    /// end the search.
    ///
    /// # Errors
    ///
    /// All mistakes of the problem at once; `NotFound` if no start led to a mechanism that runs
    /// through its whole range, `Ended` if the search was ended before one did.
    pub fn run(mut self) -> Result<DesignSearch<M, A>, DesignError> {
        let mut progress = self.settings.progress.take();
        let end = self.settings.end();
        let problem = self.problem()?;
        let (blocks, ended_early) = self.search(&problem, &end, &mut progress);
        let starts = self.settings.starts.min(blocks.len() * BLOCK);
        let mut total = Block::default();
        for block in blocks {
            total.tally.add(&block.tally);
            total.evaluations += block.evaluations;
            total.optima.extend(block.optima);
            total.feasible.extend(block.feasible);
        }
        let Block {
            tally,
            evaluations,
            optima,
            feasible,
        } = total;
        let optima = distinct(optima, &problem.widths(), &problem.periods());
        let results = Results {
            problem: &problem,
            assemblies: &self.assemblies,
            circuits: &self.circuits,
            freedom: &self.freedom,
            steps: self.settings.steps,
            listed: self.listed,
        };
        let rounded = results.rounded(optima, &end);
        let mut certified = results.certified(&rounded.optima, &end);
        let ended_early = ended_early || rounded.ended || certified.ended;
        let best = certified.designs.first().map(|best| best.sum);
        // Ended before there is a result, it has none.
        if best.is_some() || !ended_early {
            let (seed, starts) = (self.settings.seed, self.settings.starts);
            let better = results.better(best, feasible, seed, starts, &end);
            certified.add(better, self.listed);
        }
        if certified.designs.is_empty() {
            let titles = self
                .objectives
                .iter()
                .map(|objective| objective.title())
                .collect();
            let refusals = tally.refusals(starts, self.freedom.relations(), titles);
            let refusals = Box::new(Refusals {
                no_values: rounded.no_values,
                not_whole: certified.not_whole,
                nearest: certified.nearest,
                unverified: certified.unverified,
                violated: certified.violated,
                ..refusals
            });
            return Err(match ended_early {
                true => DesignError::Ended {
                    refusals,
                    count: self.settings.starts,
                    limit: end.limit(),
                },
                false => DesignError::NotFound(refusals),
            });
        }
        Ok(DesignSearch {
            designs: certified.designs,
            starts,
            refused: tally.refused,
            open: tally.open,
            broken: tally.broken,
            not_whole: certified.not_whole,
            unverified: certified.unverified,
            left_out: certified.left_out,
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
        end: &End<'_>,
        progress: &mut Option<Report<'a>>,
    ) -> (Vec<Block>, bool) {
        let (seed, steps) = (self.settings.seed, self.settings.steps);
        let assemblies = &self.assemblies;
        let run = |starts: Range<usize>| block(problem, assemblies, seed, starts, steps);
        let least = |block: &Block| {
            let sums = block.optima.iter().map(|optimum| optimum.sum);
            sums.fold(f64::INFINITY, f64::min)
        };
        in_rounds(
            (self.settings.starts, BLOCK),
            &|_| end.reached(),
            progress,
            run,
            least,
        )
    }
}
