//! Parts of a search, for several processes.

mod bytes;

use std::format;
use std::vec::Vec;

use linkage_runtime::DimensionSet;

use super::DesignError;
use super::normal::Normal;
use super::numbered::{Identity, Numbered};
use super::problem::{Evaluator, Problem};
use super::quasi_random;
use super::search::{BLOCK, Block};
use super::settings::Settings;

/// Starts at which the sums of two problems are compared.
const PROBES: usize = 4;

/// Ends of descents from some starts of a design problem.
/// [`Design::descend`](crate::Design::descend) computes them, in any process;
/// [`Design::known`](crate::Design::known) takes them, so that these descents are not made again.
///
/// Parts may come in any number and order: the designs are equal to those of one search, to the
/// last bit on equal processors.
#[derive(Clone, Debug, PartialEq)]
pub struct DesignPart {
    /// Results with the numbers of their blocks.
    pub(crate) blocks: Numbered<Block>,
}

impl DesignPart {
    /// A part without starts of a problem, and the dimensions that do not vary.
    pub(crate) fn new<M, A, const N: usize>(
        problem: &Problem<'_, M, A, N>,
        assemblies: &[A],
        settings: &Settings<'_>,
        nominal: &[f64; N],
    ) -> Self
    where
        M: DimensionSet<N> + Copy,
    {
        let numbers = (settings.starts, settings.seed, settings.steps);
        let titles = problem.objectives.iter().map(|wanted| wanted.title());
        let titles: Vec<_> = titles.collect();
        // Rust's notation of numbers is exact.
        let text = format!(
            "{numbers:?} {titles:?} {:?} {:?} {:?} {}",
            problem.varied,
            problem.limits,
            nominal,
            assemblies.len()
        );
        let probes = probes(problem, assemblies, (settings.seed, settings.starts));
        Self {
            blocks: Numbered::new(Identity::new(settings.starts, &text, probes)),
        }
    }

    /// Adds the descents of another part of the same problem.
    ///
    /// # Errors
    ///
    /// `OtherProblem` if goals, conditions, variables, bounds, starts, seed or steps differ; `Repeated`
    /// if both have a start. Nothing changes then.
    pub fn merge(&mut self, part: &Self) -> Result<(), DesignError> {
        self.blocks.merge(&part.blocks)
    }

    /// The number of starts that have been tried.
    #[must_use]
    pub fn done(&self) -> usize {
        let starts = |&number: &usize| starts_of(number, self.count()).len();
        self.blocks.results.keys().map(starts).sum()
    }

    /// The number of all starts of the problem.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.blocks.problem.starts
    }
}

/// The starts of a block.
pub(crate) fn starts_of(number: usize, starts: usize) -> core::ops::Range<usize> {
    number * BLOCK..starts.min((number + 1) * BLOCK)
}

fn probes<M: DimensionSet<N> + Copy, A, const N: usize>(
    problem: &Problem<'_, M, A, N>,
    assemblies: &[A],
    (seed, starts): (u64, usize),
) -> Vec<f64> {
    let count = problem.limits.len();
    let mut evaluator = Evaluator::new(problem);
    let mut normal = Normal::new(count);
    let starts = (0..starts).filter_map(|index| {
        let start = problem.start(&quasi_random::unit(seed, index, count));
        start.ok()
    });
    let starts: Vec<_> = starts.take(PROBES).collect();
    let mut sums = Vec::new();
    for assembly in assemblies {
        evaluator.evaluate(assembly, starts.iter().map(Vec::as_slice));
        for index in 0..starts.len() {
            evaluator.normal(index, &mut normal);
            sums.push(normal.sum);
        }
    }
    sums
}
