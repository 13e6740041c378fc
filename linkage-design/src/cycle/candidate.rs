//! A mechanism that is tried, and its values for the objectives.

use linkage_core::Cycle;
use std::string::String;
use std::vec::Vec;

use super::super::DesignError;
use super::conditions::Conditions;
use super::verdict::Verdict;
use linkage_runtime::Parameter;

/// The function that assembles a mechanism in the modes of the first one.
pub(super) type Assemble<'c, M, A> = dyn Fn(&M) -> Option<A> + 'c;

/// A mechanism over the range of its input.
#[derive(Debug)]
pub struct Motion<'c, A> {
    /// The mechanism assembled.
    pub assembly: &'c A,
    /// The range of its input.
    pub range: (f64, f64),
    /// True if the range is a full turn of an angle, so that its ends are one position.
    pub closed: bool,
    /// Number of evenly spaced positions from which limits are searched.
    pub positions: usize,
}

impl<A> Clone for Motion<'_, A> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<A> Copy for Motion<'_, A> {}

impl<A> Motion<'_, A> {
    /// The input in the range, and after how many turns, if the range is a full turn.
    #[must_use]
    pub fn in_range(&self, input: f64) -> (f64, f64) {
        let (low, high) = self.range;
        let width = high - low;
        if !self.closed || (low..=high).contains(&input) {
            return (input, 0.0);
        }
        let turns = ((input - low) / width).floor();
        (input - turns * width, turns)
    }
}

/// A mechanism that is tried.
pub struct Candidate<'c, M, A> {
    /// Its dimensions.
    pub mechanism: &'c M,
    /// It over the range of its input.
    pub motion: Motion<'c, A>,
    pub(super) assemble: &'c Assemble<'c, M, A>,
}

impl<'c, M, A> Candidate<'c, M, A> {
    /// A mechanism, it over its range, and how others are assembled in its modes.
    #[must_use]
    pub fn new(
        mechanism: &'c M,
        motion: Motion<'c, A>,
        assemble: &'c dyn Fn(&M) -> Option<A>,
    ) -> Self {
        Self {
            mechanism,
            motion,
            assemble,
        }
    }

    /// Another mechanism in the same modes; `None` if it does not assemble.
    #[must_use]
    pub fn assemble(&self, mechanism: &M) -> Option<A> {
        (self.assemble)(mechanism)
    }
}

/// A variable that an objective has for itself, such as where a dwell begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AuxiliaryVariable {
    /// The value with which the search begins.
    pub start: f64,
    /// The bounds.
    pub bounds: (f64, f64),
    /// The largest change in the first step.
    pub reach: f64,
}

/// The state of a search for an objective.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chosen<'c> {
    /// The variables that the objective has for itself.
    pub auxiliary: &'c [f64],
    /// The conditions that [`refine`](CycleObjective::refine) found in this search, each in numbers
    /// of the objective.
    pub added: &'c [Vec<f64>],
}

/// Something that is wanted of a whole cycle. Searches on several threads share it: the values that
/// one of them finds are in [`Chosen`].
pub trait CycleObjective<M, A, const N: usize>: Send + Sync {
    /// The name in messages.
    fn title(&self) -> String;

    /// Returns true for the goal, of which a design has one.
    fn is_goal(&self) -> bool;

    /// Returns its mistakes, for a mechanism of which these parameters may vary.
    fn check(&self, cycle: &Cycle, parameters: &[Parameter], varied: &[usize]) -> Vec<DesignError> {
        let _ = (cycle, parameters, varied);
        Vec::new()
    }

    /// Returns the number of its equations between the variables: one for a figure that must have a
    /// value.
    fn equations(&self) -> usize {
        0
    }

    /// Returns the goal as it is reported, from the value that the search makes least: a greatest
    /// value is the least of its opposite.
    fn reported_goal(&self, least: f64) -> f64 {
        least
    }

    /// The variables that it has for itself, with starts that suit a mechanism; `None` if there is
    /// none.
    fn auxiliary_variables(
        &self,
        candidate: &Candidate<'_, M, A>,
    ) -> Option<Vec<AuxiliaryVariable>> {
        let _ = candidate;
        Some(Vec::new())
    }

    /// Goal and conditions; `None` where the mechanism does not assemble over the range.
    fn evaluate(
        &self,
        candidate: &Candidate<'_, M, A>,
        chosen: Chosen<'_>,
    ) -> Option<Conditions<N>>;

    /// Computes goal and conditions of a result without the search, before it is returned; `None`
    /// where the mechanism does not assemble over the range.
    ///
    /// The candidate has four times the intervals of the search, from which limits are found. A
    /// result whose verdict breaks a condition is discarded, and the goal of the verdict is the
    /// goal of the result.
    fn verify(&self, candidate: &Candidate<'_, M, A>, chosen: Chosen<'_>) -> Option<Verdict> {
        Some(Verdict::from_conditions(&self.evaluate(candidate, chosen)?))
    }

    /// Numbers by which the assembly is known again among the others of the same mechanism; they
    /// are compared as parts of the largest. Here all slopes: values are near their limits, and may
    /// count whole turns.
    fn known_by(&self, candidate: &Candidate<'_, M, A>, chosen: Chosen<'_>) -> Option<Vec<f64>> {
        let asked = self.evaluate(candidate, chosen)?;
        let all = asked.conditions.iter().chain([&asked.goal]).flatten();
        Some(all.flat_map(|piece| piece.parameters).collect())
    }

    /// Looks for conditions that the optimum breaks and that have not been added yet, each in
    /// numbers of the objective; if there are any, the search goes on with them.
    fn refine(&self, candidate: &Candidate<'_, M, A>, chosen: Chosen<'_>) -> Vec<Vec<f64>> {
        let _ = (candidate, chosen);
        Vec::new()
    }
}
