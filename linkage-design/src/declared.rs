//! The declared mechanism as a candidate: a search is never worse than its start, if that is a
//! result at all.

use std::vec::Vec;

use super::FoundDesign;
use super::normal::Normal;
use super::optimum::Optimum;
use super::problem::Evaluator;
use super::results::Results;
use super::search;
use super::settings::End;
use linkage_runtime::DimensionSet;

/// Sums that differ by less than this part are equal, as those of optima that are one.
const SAME: f64 = 1e-6;
/// Sums below this part of those at the starts are zero.
const ZERO: f64 = 1e-20;
/// Feasible starts that are looked at over the whole range.
const LOOKED_AT: usize = 16;

impl<M, A, const N: usize> Results<'_, M, A, N>
where
    M: DimensionSet<N> + Copy + Send + Sync,
    A: Clone + Send + Sync,
{
    /// Returns a design that is better than the best one: the optimum next to the declared
    /// mechanism, that mechanism itself, or a start that holds all conditions. `None` if there is
    /// none, as it should be.
    pub(super) fn better(
        &self,
        best: Option<f64>,
        mut feasible: Vec<Optimum>,
        seed: u64,
        starts: usize,
        end: &End<'_>,
    ) -> Option<FoundDesign<M, A>> {
        let mut evaluator = Evaluator::new(self.problem);
        feasible.extend(self.declared(&mut evaluator, starts));
        feasible.retain(|feasible| self.is_of_catalogues(&feasible.x));
        feasible.sort_by(|a, b| a.sum.total_cmp(&b.sum));
        let mut scale = None;
        feasible.retain(|feasible| match best {
            Some(best) if best > feasible.sum => {
                let scale = scale.get_or_insert_with(|| self.scale(&mut evaluator, seed));
                best - feasible.sum > SAME * best + ZERO * *scale
            }
            Some(_) => false,
            None => true,
        });
        feasible.truncate(LOOKED_AT);
        for optimum in &feasible {
            let Ok(found) = self.found(&mut evaluator, optimum) else {
                continue;
            };
            let mode = (&self.assemblies[optimum.assembly], self.steps);
            let (problem, limits) = (self.problem, &self.problem.limits);
            let near = search::refine(optimum, limits, problem, &mut evaluator, mode);
            let near = self.rounded(near.into_iter().collect(), end).optima;
            let mut near = near.iter().map(|near| self.found(&mut evaluator, near));
            return match near.next() {
                Some(Ok(near)) if near.sum < found.sum => Some(near),
                _ => Some(found),
            };
        }
        None
    }

    /// The declared mechanism in each assembly, if it holds all that must hold; with free inputs
    /// its sum is not known.
    fn declared(&self, evaluator: &mut Evaluator<'_, M, A, N>, start: usize) -> Vec<Optimum> {
        let problem = self.problem;
        let x = problem.declared();
        let known = x.len() == problem.varied.len() && problem.limits.hold(&x);
        let assemblies = self.assemblies.iter().enumerate().filter(|_| known);
        let optima = assemblies.filter_map(|(assembly, modes)| {
            let mut normal = Normal::new(x.len());
            evaluator.evaluate(modes, core::iter::once(&x[..]));
            evaluator.normal(0, &mut normal);
            (normal.is_finite() && problem.meets(&normal)).then(|| Optimum {
                x: x.clone(),
                sum: normal.sum,
                assembly,
                start,
                hits: 1,
                converged: false,
                zero: false,
            })
        });
        optima.collect()
    }

    fn is_of_catalogues(&self, x: &[f64]) -> bool {
        let mut lists = self.problem.catalogues.iter();
        lists.all(|(index, values)| values.contains(&x[*index]))
    }

    /// The mean sum of squares at the first starts, where there is one.
    fn scale(&self, evaluator: &mut Evaluator<'_, M, A, N>, seed: u64) -> f64 {
        let places = self.problem.places(seed);
        let mut sums = Vec::new();
        for assembly in self.assemblies {
            evaluator.evaluate(assembly, places.iter().map(|x| &x[..]));
            for index in 0..places.len() {
                let mut normal = Normal::new(self.problem.limits.len());
                evaluator.normal(index, &mut normal);
                sums.extend(Some(normal.sum).filter(|sum| sum.is_finite()));
            }
        }
        sums.iter().sum::<f64>() / sums.len().max(1) as f64
    }
}
