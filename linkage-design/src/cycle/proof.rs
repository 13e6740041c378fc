//! The proof of an optimum: its conditions hold, and it runs through its whole range on one
//! circuit.

use std::boxed::Box;
use std::string::{String, ToString};
use std::vec::Vec;

use super::super::DesignError;
use super::super::certificate::{Interruption, alike, certify};
use super::super::minimax::largest;
use super::ladder::ROUNDED;
use super::problem::{Problem, SearchStart, Sizes};
use super::{Candidate, Piece};
use linkage_runtime::{AssemblyError, Branch, BranchEnd, Circuits, Dimensions};

/// Ends that differ by less than this part of their interval are one: that of two assemblies which
/// meet there.
const SAME_END: f64 = 1e-6;

impl<M: Dimensions<N>, A, const N: usize> Problem<'_, M, A, N> {
    /// True if all conditions hold to within a part of their sizes.
    pub(super) fn held(
        &self,
        start: &SearchStart,
        sizes: &Sizes,
        tolerance: f64,
    ) -> Result<(), DesignError> {
        let x = &start.x;
        let groups = self
            .tried(x, |candidate| self.asked(start, x, candidate))
            .ok_or_else(|| self.not_whole(x))?;
        let missed: Vec<f64> = groups.conditions.iter().map(|rows| largest(rows)).collect();
        let mut first = 0;
        for (k, objective) in self.objectives.iter().enumerate() {
            let count = self
                .tried(x, |candidate| {
                    Some(
                        objective
                            .evaluate(candidate, start.chosen(k, x))?
                            .conditions
                            .len(),
                    )
                })
                .ok_or_else(|| self.not_whole(x))?;
            let conditions = first..first + count;
            first += count;
            let worst = conditions
                .filter(|&k| missed[k] > tolerance * sizes.conditions[k])
                .map(|k| missed[k]);
            if let Some(by) = worst.max_by(f64::total_cmp) {
                return Err(self.out_of_reach(start, objective.title(), by));
            }
        }
        Ok(())
    }

    /// That a condition is missed by so much where a search is.
    pub(super) fn out_of_reach(
        &self,
        start: &SearchStart,
        objective: String,
        by: f64,
    ) -> DesignError {
        let at_bound = self.at_bound(&start.x);
        let (equations, variables) = self.freedom(start);
        let values = self.mechanism(&start.x).values();
        let value = |&index: &usize| (M::PARAMETERS[index].name, values[index]);
        DesignError::OutOfReach {
            objective,
            by,
            nearest: self.varied.iter().map(value).collect(),
            at_bound: at_bound.iter().map(|(name, _)| name.to_string()).collect(),
            equations,
            variables,
            settled: true,
        }
    }

    /// The number of equations of figures and between parameters, and the number of variables for
    /// them.
    fn freedom(&self, start: &SearchStart) -> (usize, usize) {
        let figures: usize = self
            .objectives
            .iter()
            .map(|objective| objective.equations())
            .sum();
        let relations = &start.limits.relations;
        let relations = relations.iter().filter(|relation| relation.equality);
        let bounds = start.limits.lower.iter().zip(&start.limits.upper);
        let free = bounds.filter(|(low, high)| low < high);
        (figures + relations.count(), free.count())
    }

    /// The parameters that are at a bound, or at where a search rounded it to, with the bound.
    pub(super) fn at_bound(&self, x: &[f64]) -> Vec<(&'static str, f64)> {
        let bound = |(j, &index): (usize, &usize)| {
            let bounds = [self.limits.lower[j], self.limits.upper[j]];
            // The end of a catalogue is a value like all others.
            let of_catalogue = self.catalogues.iter().any(|(position, _)| *position == j);
            let mut bounds = bounds.into_iter().filter(|_| !of_catalogue);
            let near = ROUNDED * x[j].abs();
            let reached = bounds.find(|bound| (bound - x[j]).abs() <= near)?;
            Some((M::PARAMETERS[index].name, reached))
        };
        self.varied.iter().enumerate().filter_map(bound).collect()
    }

    /// The names of the parameters that take values of catalogues.
    pub(super) fn of_catalogues(&self) -> Vec<String> {
        let names = self.catalogues.iter();
        names
            .map(|(index, _)| M::PARAMETERS[self.varied[*index]].name.to_string())
            .collect()
    }

    /// The assembly over the whole range: one that runs through it without a dead point, closes
    /// after a turn, and by which all objectives have their values of the optimum, so that it is
    /// the one that was optimised.
    pub(super) fn certify(&self, start: &SearchStart) -> Result<Branch<A>, DesignError> {
        let x = &start.x;
        let numbers = self
            .tried(x, |candidate| self.known_by(start, candidate))
            .ok_or_else(|| self.not_whole(x))?;
        let same = |branch: &Branch<A>| self.is_known(start, &numbers, &branch.assembly);
        certify((self.circuits)(&self.mechanism(x)), same).map_err(DesignError::NotWhole)
    }

    /// The numbers by which all objectives know an assembly of the mechanism where a search is.
    pub(super) fn known_by(
        &self,
        start: &SearchStart,
        candidate: &Candidate<'_, M, A>,
    ) -> Option<Vec<Vec<f64>>> {
        let objectives = self.objectives.iter().enumerate();
        objectives
            .map(|(k, objective)| objective.known_by(candidate, start.chosen(k, &start.x)))
            .collect()
    }

    /// Returns true if an assembly of this mechanism is the one with these numbers.
    pub(super) fn is_known(&self, start: &SearchStart, numbers: &[Vec<f64>], assembly: &A) -> bool {
        let other = self.assembled(&start.x, assembly, |candidate| {
            self.known_by(start, candidate)
        });
        let same = |(a, b): (&Vec<f64>, &Vec<f64>)| {
            let size = a.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            alike(a, b, a.iter().map(|_| size))
        };
        other.is_some_and(|other| numbers.iter().zip(&other).all(same))
    }

    /// That a mechanism which was found is not there over the whole range.
    pub(super) fn not_whole(&self, x: &[f64]) -> DesignError {
        let circuits = (self.circuits)(&self.mechanism(x));
        DesignError::NotWhole(self.interruption(x, &circuits))
    }

    /// Why nothing can be said of the mechanism that a search begins with: it does not run through
    /// its whole range, or an objective finds nothing in it.
    pub(super) fn refused(&self, start: &SearchStart) -> DesignError {
        let circuits = (self.circuits)(&self.mechanism(&start.x));
        let branches = circuits.as_ref().map_or(&[][..], |found| &found.branches);
        let mut whole = branches
            .iter()
            .filter(|branch| branch.is_whole())
            .peekable();
        // An objective that finds nothing even where an assembly runs through the whole range.
        let objectives = 0..self.objectives.len();
        let found = |k: usize| {
            whole
                .clone()
                .any(|branch| self.finds(start, k, &branch.assembly))
        };
        let nothing = objectives.clone().find(|&k| !found(k));
        match (whole.peek().is_some(), nothing) {
            (true, Some(k)) => DesignError::NoStart {
                objective: self.objectives[k].title(),
            },
            _ => DesignError::StartNotWhole(self.interruption(&start.x, &circuits)),
        }
    }

    /// Why a mechanism with these assemblies is not there over the whole range.
    fn interruption(
        &self,
        x: &[f64],
        circuits: &Result<Circuits<A>, AssemblyError>,
    ) -> Interruption {
        let branches = match circuits {
            Ok(circuits) => &circuits.branches,
            Err(error) => return Interruption::Unassembled(Box::new(error.clone())),
        };
        let parts: Vec<_> = branches
            .iter()
            .filter(|branch| !branch.is_whole())
            .collect();
        match (parts.is_empty(), (self.assemble)(&self.mechanism(x))) {
            (false, _) => Interruption::Ends(intervals(&parts)),
            (true, Err(error)) => Interruption::Unassembled(Box::new(error)),
            (true, Ok(_)) => Interruption::Apart,
        }
    }

    /// Returns true if an objective has values in an assembly: the variables of its own, and then
    /// all its numbers.
    fn finds(&self, start: &SearchStart, k: usize, assembly: &A) -> bool {
        let objective = &self.objectives[k];
        let asked = |candidate: &Candidate<'_, M, A>| {
            if start.auxiliary.get(k).is_none() {
                return objective.auxiliary_variables(candidate).map(|_| ());
            }
            let asked = objective.evaluate(candidate, start.chosen(k, &start.x))?;
            let mut all = asked.conditions.iter().chain([&asked.goal]).flatten();
            all.all(Piece::is_finite).then_some(())
        };
        self.assembled(&start.x, assembly, asked).is_some()
    }
}

/// Between which inputs some assemblies reach, each once: two that are mirrored reach equally far.
fn intervals<A>(parts: &[&Branch<A>]) -> Vec<[f64; 2]> {
    let mut intervals: Vec<[f64; 2]> = Vec::new();
    for part in parts {
        let interval = part.ends.map(BranchEnd::x);
        let near = |other: &[f64; 2]| {
            let [low, high] = [other[0] - interval[0], other[1] - interval[1]];
            low.abs().max(high.abs()) <= SAME_END * (interval[1] - interval[0])
        };
        if !intervals.iter().any(near) {
            intervals.push(interval);
        }
    }
    intervals
}
