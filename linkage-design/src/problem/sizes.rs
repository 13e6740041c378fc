//! The size of each condition, from its own numbers.
//!
//! Near a place where a number ceases to exist, such as the height of a flat triangle, its
//! derivatives grow without limit. Whatever is compared with them is small. The number itself stays
//! as large as it is elsewhere.

use std::vec;
use std::vec::Vec;

use super::super::quasi_random;
use super::{Evaluator, Problem};
use linkage_runtime::DimensionSet;

/// Starts at which conditions are looked at.
const PLACES: usize = 32;

impl<M: DimensionSet<N> + Copy, A, const N: usize> Problem<'_, M, A, N> {
    /// With the size of each row of a condition: the mean of its absolute values in the declared
    /// mechanism and at the first starts, where it has a value.
    pub(crate) fn measured(mut self, assemblies: &[A], seed: u64) -> Self {
        self.sizes = self.means(assemblies, seed);
        self
    }

    /// The variables of the declared mechanism, with free inputs in the middle of their starts.
    pub(crate) fn declared(&self) -> Vec<f64> {
        let nominal = self.nominal.numbers();
        let mut x: Vec<f64> = self.varied.iter().map(|&k| nominal[k]).collect();
        for free in self.free.iter().flatten() {
            x.extend(free.start(&vec![0.5; free.count]));
        }
        x
    }

    /// The declared mechanism and the first starts, whether relations hold or not.
    pub(crate) fn places(&self, seed: u64) -> Vec<Vec<f64>> {
        let count = self.limits.len();
        let start = |index| self.within_bounds(&quasi_random::unit(seed, index, count));
        let first = core::iter::once(self.declared());
        first.chain((0..PLACES).map(start)).collect()
    }

    fn means(&self, assemblies: &[A], seed: u64) -> Vec<f64> {
        let conditions = self.objectives.iter().enumerate();
        let conditions = conditions.filter(|(_, objective)| objective.is_condition());
        let rows =
            conditions.flat_map(|(k, objective)| (0..objective.rows()).map(move |row| (k, row)));
        let rows: Vec<(usize, usize)> = rows.collect();
        if rows.is_empty() {
            return Vec::new();
        }
        let places = self.places(seed);
        let mut evaluator = Evaluator::new(self);
        let mut sums = vec![(0.0, 0_u32); rows.len()];
        for assembly in assemblies {
            evaluator.evaluate(assembly, places.iter().map(|x| &x[..]));
            for (&(objective, row), (sum, count)) in rows.iter().zip(&mut sums) {
                let values = (0..places.len()).map(|at| evaluator.rows(objective).row(at, row).0);
                for value in values.filter(|value| value.is_finite()) {
                    *sum += value.abs();
                    *count += 1;
                }
            }
        }
        let mean = |(sum, count): (f64, u32)| sum / f64::from(count.max(1));
        sums.into_iter().map(mean).collect()
    }
}
