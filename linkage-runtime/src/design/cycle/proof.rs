//! What must hold of an optimum: its conditions, and that it runs through its whole range on one circuit.

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::super::DesignError;
use super::super::minimax::Row;
use super::Candidate;
use super::problem::{Problem, Sizes, Start};
use crate::{Branch, Dimensions};

/// Numbers of the same assembly differ by less than this part of the largest one; those of other assemblies by far more.
const SAME: f64 = 1e-6;

impl<M: Dimensions<N>, A, const N: usize> Problem<'_, M, A, N> {
    /// Whether all conditions hold to within a part of their sizes.
    pub(super) fn held(
        &self,
        start: &Start,
        sizes: &Sizes,
        tolerance: f64,
    ) -> Result<(), DesignError> {
        let x = &start.x;
        let groups = self
            .tried(x, |candidate| self.asked(start, x, candidate))
            .ok_or(DesignError::NotWhole)?;
        let missed: Vec<f64> = groups.conditions.iter().map(|rows| largest(rows)).collect();
        let mut first = 0;
        for (k, wish) in self.wishes.iter().enumerate() {
            let count = self
                .tried(x, |candidate| {
                    Some(
                        wish.evaluate(candidate, start.chosen(k, x))?
                            .conditions
                            .len(),
                    )
                })
                .ok_or(DesignError::NotWhole)?;
            let own = first..first + count;
            first += count;
            let worst = own
                .filter(|&k| missed[k] > tolerance * sizes.conditions[k])
                .map(|k| missed[k]);
            if let Some(by) = worst.max_by(f64::total_cmp) {
                let at_bound = self.at_bound(x);
                return Err(DesignError::OutOfReach {
                    wish: wish.title(),
                    by,
                    at_bound: at_bound.iter().map(|(name, _)| name.to_string()).collect(),
                });
            }
        }
        Ok(())
    }

    /// The parameters that are at a bound, with it.
    pub(super) fn at_bound(&self, x: &[f64]) -> Vec<(&'static str, f64)> {
        let bound = |(j, &index): (usize, &usize)| {
            let bounds = [self.limits.lower[j], self.limits.upper[j]];
            // The end of a catalogue is a value like all others.
            let of_catalogue = self.catalogues.iter().any(|(place, _)| *place == j);
            let mut bounds = bounds.into_iter().filter(|_| !of_catalogue);
            let own = bounds.find(|bound| *bound == x[j])?;
            Some((M::PARAMETERS[index].name, own))
        };
        self.varied.iter().enumerate().filter_map(bound).collect()
    }

    /// The names of the parameters that take values of catalogues.
    pub(super) fn of_catalogues(&self) -> Vec<String> {
        let names = self.catalogues.iter();
        names
            .map(|(place, _)| M::PARAMETERS[self.varied[*place]].name.to_string())
            .collect()
    }

    /// The assembly over the whole range: one that runs through it without a dead point, closes after a turn, and by which all wishes are
    /// what they are for the optimum, so that it is the one that was optimised.
    pub(super) fn certify(&self, start: &Start) -> Result<Branch<A>, DesignError> {
        let x = &start.x;
        let circuits = (self.circuits)(&self.mechanism(x)).map_err(|_| DesignError::NotWhole)?;
        let turns = super::super::turn(&circuits.cycle).is_some();
        let known_by = |candidate: &Candidate<'_, M, A>| {
            let wishes = self.wishes.iter().enumerate();
            wishes
                .map(|(k, wish)| wish.known_by(candidate, start.chosen(k, x)))
                .collect::<Option<Vec<_>>>()
        };
        let own = self.tried(x, known_by).ok_or(DesignError::NotWhole)?;
        let whole = circuits
            .branches
            .into_iter()
            .filter(|branch| branch.is_whole() && (branch.closed || !turns));
        let same = |branch: &Branch<A>| {
            let other = self.assembled(x, &branch.assembly, known_by);
            other.is_some_and(|other| own.iter().zip(&other).all(|(a, b)| alike(a, b)))
        };
        whole.into_iter().find(same).ok_or(DesignError::NotWhole)
    }
}

fn largest(rows: &[Row]) -> f64 {
    rows.iter()
        .map(|row| row.value)
        .fold(f64::NEG_INFINITY, f64::max)
}

fn alike(a: &[f64], b: &[f64]) -> bool {
    let size = a.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() <= SAME * size)
}
