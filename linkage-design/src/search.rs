//! Descents from many starts, side by side.

use std::vec::Vec;

use super::least_squares::{Descent, State, StepProgram, minimise};
use super::limits::Limits;
use super::normal::Normal;
use super::optimum::Optimum;
use super::problem::{Evaluator, Problem};
use super::quasi_random;
use super::refusals::{Fate, Tally};
use linkage_runtime::DimensionSet;

/// Starts of a block, which are evaluated side by side: enough for lanes, and few enough that their
/// numbers stay in the cache.
pub(crate) const BLOCK: usize = 32;

/// The optimum within narrower limits, from this one.
pub(crate) fn refine<M: DimensionSet<N> + Copy, A, const N: usize>(
    optimum: &Optimum,
    limits: &Limits,
    problem: &Problem<'_, M, A, N>,
    evaluator: &mut Evaluator<'_, M, A, N>,
    (assembly, most): (&A, usize),
) -> Option<Optimum> {
    let start = limits.nearest(&optimum.x)?;
    let (descent, state) = minimise(start, limits, most, |x, normal| {
        evaluator.evaluate(assembly, core::iter::once(x));
        evaluator.normal(0, normal);
    });
    let valid = descent.here.sum.is_finite() && problem.meets(&descent.here);
    valid.then(|| Optimum {
        zero: optimum.zero && descent.is_zero(),
        x: descent.x,
        sum: descent.here.sum,
        converged: state == State::Converged,
        ..*optimum
    })
}

/// The results of a block of starts.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Block {
    pub(crate) optima: Vec<Optimum>,
    /// Starts that hold all conditions, where descents end at nothing that holds them and has a
    /// smaller sum.
    pub(crate) feasible: Vec<Optimum>,
    pub(crate) tally: Tally,
    pub(crate) evaluations: usize,
}

/// Runs the starts of a block, in the modes of each assembly.
pub(crate) fn block<M: DimensionSet<N> + Copy, A, const N: usize>(
    problem: &Problem<'_, M, A, N>,
    assemblies: &[A],
    seed: u64,
    indices: core::ops::Range<usize>,
    most: usize,
) -> Block {
    let mut block = Block::default();
    let count = problem.limits.len();
    let mut begun: Vec<(usize, Vec<f64>)> = Vec::new();
    for index in indices {
        match problem.start(&quasi_random::unit(seed, index, count)) {
            Ok(x) => begun.push((index, x)),
            Err(relations) => block.tally.refuse(&relations),
        }
    }
    let mut fates = std::vec![Fate::Open; begun.len()];
    let mut evaluator = Evaluator::new(problem);
    let mut step = StepProgram::new(&problem.limits);
    for (number, assembly) in assemblies.iter().enumerate() {
        let descents = begun
            .iter()
            .enumerate()
            .map(|(start, (_, x))| (start, Descent::new(x.clone(), most)));
        let mut running: Vec<(usize, Descent)> = descents.collect();
        // The sums of starts that hold all conditions.
        let mut first = std::vec![None; begun.len()];
        let mut there = Normal::new(count);
        while !running.is_empty() {
            evaluator.evaluate(
                assembly,
                running.iter().map(|(_, descent)| &descent.trial[..]),
            );
            block.evaluations += running.len();
            let mut index = 0;
            running.retain_mut(|(start, descent)| {
                evaluator.value(index, &mut there);
                let derivatives = |there: &mut Normal| evaluator.derivatives(index, there);
                let state = descent.advance(&mut step, &mut there, derivatives);
                index += 1;
                if descent.count == 1 && problem.meets(&descent.here) {
                    first[*start] = Some(descent.here.sum).filter(|sum| sum.is_finite());
                }
                if state == State::Running {
                    return true;
                }
                if !descent.here.sum.is_finite() {
                    return false;
                }
                let broken = problem.violations(&descent.here);
                let smaller = |sum: &f64| !broken.is_empty() || descent.here.sum > *sum;
                if let Some(sum) = first[*start].filter(smaller) {
                    block.feasible.push(Optimum {
                        x: begun[*start].1.clone(),
                        sum,
                        assembly: number,
                        start: begun[*start].0,
                        hits: 1,
                        converged: false,
                        zero: false,
                    });
                }
                if broken.is_empty() {
                    fates[*start] = Fate::Ended;
                    block.optima.push(Optimum {
                        x: descent.x.clone(),
                        sum: descent.here.sum,
                        assembly: number,
                        start: begun[*start].0,
                        hits: 1,
                        converged: state == State::Converged,
                        zero: descent.is_zero(),
                    });
                } else if !matches!(fates[*start], Fate::Ended) {
                    block.tally.missed(&broken);
                    fates[*start] =
                        Fate::Broken(broken.iter().map(|broken| broken.objective).collect());
                }
                false
            });
        }
    }
    fates.iter().for_each(|fate| block.tally.begun(fate));
    block
}

/// Optima whose variables differ by less than this part of the bounds' widths are one: descents
/// stop that near.
const SAME: f64 = 1e-4;
/// Neither are two optima with sums that differ by more than this part.
const SAME_SUM: f64 = 1e-6;

/// The distinct ones, the least first; of equal ones that of the first start. A variable with a
/// period counts without whole ones.
pub(crate) fn distinct(
    mut optima: Vec<Optimum>,
    widths: &[f64],
    periods: &[Option<f64>],
) -> Vec<Optimum> {
    optima.sort_by(|a, b| {
        let sums = a.sum.total_cmp(&b.sum);
        sums.then(a.start.cmp(&b.start))
            .then(a.assembly.cmp(&b.assembly))
    });
    let mut kept: Vec<Optimum> = Vec::new();
    for optimum in optima {
        let near = |other: &&mut Optimum| {
            let close = |j: usize| {
                let difference = other.x[j] - optimum.x[j];
                let whole = periods[j].map_or(0.0, |period| period * (difference / period).round());
                (difference - whole).abs() <= SAME * widths[j]
            };
            other.assembly == optimum.assembly && (0..widths.len()).all(close)
        };
        let alike = |other: &&mut Optimum| {
            (other.zero && optimum.zero) || optimum.sum - other.sum <= SAME_SUM * optimum.sum
        };
        match kept.iter_mut().rev().take_while(alike).find(near) {
            Some(other) => other.hits += 1,
            None => kept.push(optimum),
        }
    }
    kept
}
