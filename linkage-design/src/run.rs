//! The search of a design problem.

use core::ops::Range;
use std::boxed::Box;
use std::vec::Vec;

use super::builder::Design;
use super::numbered::missing;
use super::part::starts_of;
use super::problem::Problem;
use super::results::Results;
use super::rounds::in_rounds;
use super::search::{BLOCK, Block, block, distinct};
use super::settings::{End, Report};
use super::{DesignError, DesignPart, DesignSearch, Refusals};
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
        let (descents, ended_early) = self.descents(&problem, &end, &mut progress)?;
        let starts = descents.done();
        let mut total = Block::default();
        for block in descents.blocks.results.into_values() {
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

    /// Makes the descents of a [`part`](Self::part) of the starts, for a search in several
    /// processes: each computes a part, and one of them takes all parts by [`known`](Self::known)
    /// and runs.
    ///
    /// ```
    /// use linkage_design::{Design, DesignError, DesignPart, DesignSearch};
    /// # use linkage_runtime::DimensionSet;
    ///
    /// // In each process: a part, as bytes.
    /// type Bytes = Vec<u8>;
    /// fn part<M, A, const N: usize>(problem: Design<'_, M, A, N>, k: usize, of: usize) -> Result<Bytes, DesignError>
    /// # where M: DimensionSet<N> + Copy + Send + Sync, A: Clone + Send + Sync
    /// {
    ///     Ok(problem.part(k, of).descend()?.to_bytes())
    /// }
    ///
    /// // In one of them: the designs, as of one search.
    /// type Found<M, A> = Result<DesignSearch<M, A>, DesignError>;
    /// fn whole<M, A, const N: usize>(mut problem: Design<'_, M, A, N>, parts: &[Bytes]) -> Found<M, A>
    /// # where M: DimensionSet<N> + Copy + Send + Sync, A: Clone + Send + Sync
    /// {
    ///     for part in parts {
    ///         problem = problem.known(DesignPart::read(part)?);
    ///     }
    ///     problem.run()
    /// }
    /// ```
    ///
    /// # Errors
    ///
    /// All mistakes of the problem at once.
    pub fn descend(mut self) -> Result<DesignPart, DesignError> {
        let mut progress = self.settings.progress.take();
        let end = self.settings.end();
        let problem = self.problem()?;
        Ok(self.descents(&problem, &end, &mut progress)?.0)
    }

    /// Returns the known descents with those of the part that are missing, and whether some of them
    /// were not made.
    fn descents(
        &self,
        problem: &Problem<'_, M, A, N>,
        end: &End<'_>,
        progress: &mut Option<Report<'a>>,
    ) -> Result<(DesignPart, bool), DesignError> {
        let (seed, steps) = (self.settings.seed, self.settings.steps);
        let mut descents = DesignPart::new(
            problem,
            &self.assemblies,
            &self.settings,
            &self.nominal.numbers(),
        );
        for part in &self.known {
            descents.merge(part)?;
        }
        let count = self.settings.starts.div_ceil(BLOCK);
        let missing = missing(&descents.blocks.results, self.part, count);
        let starts: Vec<_> = missing
            .iter()
            .map(|&number| starts_of(number, self.settings.starts))
            .collect();
        let assemblies = &self.assemblies;
        let run = |starts: Range<usize>| block(problem, assemblies, seed, starts, steps);
        let least = |block: &Block| {
            let sums = block.optima.iter().map(|optimum| optimum.sum);
            sums.fold(f64::INFINITY, f64::min)
        };
        let (blocks, ended) = in_rounds(&starts, &|_| end.reached(), progress, run, least);
        let blocks = missing.into_iter().zip(blocks);
        descents.blocks.results.extend(blocks);
        Ok((descents, ended))
    }
}
