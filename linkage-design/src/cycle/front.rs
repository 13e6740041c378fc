//! The Pareto front of two objectives: mechanisms of which none is better in both.

use std::boxed::Box;
use std::string::ToString;
use std::vec::Vec;

use super::super::DesignError;
use super::super::numbered::WHOLE;
use super::builder::CycleDesign;
use super::found::BestCycle;
use super::requirement::{Figure, Requirement};
use super::searches::Beginning;
use super::{CycleObjective, Motion};
use linkage_runtime::Dimensions;

/// A mechanism on the Pareto front of two objectives.
#[derive(Clone, Debug, PartialEq)]
pub struct Compromise<M, A> {
    /// The mechanism; its goal is the first objective.
    pub best: BestCycle<M, A>,
    /// The value of the figure of the second objective.
    pub other: f64,
}

/// The distance of the last limit of the front from the best value that can be reached, as a part
/// of the way between its ends: there the first objective has no room.
const SPARE: f64 = 1e-3;

impl<M, A, const N: usize> CycleDesign<'_, M, A, N>
where
    M: Dimensions<N> + Copy + Send + Sync,
    A: Send + Sync,
{
    /// Compromises between two goals, which contradict each other, beside the conditions that are
    /// wanted: from the best mechanism for `goal` alone to that for `other` alone, so many of them.
    /// Between the ends `other` is a condition, with limits at equal distances.
    ///
    /// Each search begins with the compromise beside it, from both ends; the better one of both is
    /// kept, and none than which another is better in both objectives. So the front is one of local
    /// optima, as all that is found here. The ends are searched from all [starts](Self::starts).
    ///
    /// # Errors
    ///
    /// As [`run`](Self::run); `Nothing` for less than two compromises; `Undivided` for a
    /// [`part`](Self::part), or with [`known`](Self::known) descents.
    pub fn front<F: Figure<A, N> + Send + Sync>(
        mut self,
        goal: impl CycleObjective<M, A, N>,
        other: Requirement<F>,
        compromises: usize,
    ) -> Result<Vec<Compromise<M, A>>, DesignError> {
        if compromises < 2 {
            return Err(DesignError::Nothing {
                what: "less than two compromises",
                objective: "a front".to_string(),
            });
        }
        if self.part != WHOLE || !self.known.is_empty() {
            return Err(DesignError::Undivided);
        }
        let end = self.settings.end();
        let mut report = self.settings.progress.take();
        let starts = self.settings.starts.max(1);
        let mut search = |goal: &dyn CycleObjective<M, A, N>,
                          limit: Option<&dyn CycleObjective<M, A, N>>,
                          (first, starts, widening): (&M, usize, bool)| {
            let conditions = self.objectives.iter().map(Box::as_ref);
            let objectives: Vec<_> = conditions.chain([goal]).chain(limit).collect();
            let checked = self.checked(&objectives)?;
            let beginning = Beginning {
                first,
                starts,
                widening,
                part: WHOLE,
                known: &[],
            };
            let mut found =
                self.searches(&checked, &objectives)
                    .searched(&beginning, &end, &mut report)?;
            let best = found.swap_remove(0);
            let cycle = &checked.circuits.cycle;
            let motion = Motion {
                assembly: &best.assembly,
                range: (cycle.low, cycle.high),
                closed: cycle.turn().is_some(),
                positions: self.positions,
            };
            let other = other.value(&motion).unwrap_or(f64::NAN);
            Ok::<_, DesignError>(Compromise { best, other })
        };
        let [sense, other_sense] = [sense::<M, A, N>(&goal), sense::<M, A, N>(&other)];
        let first = search(&goal, None, (&self.nominal, starts, true))?;
        let last = search(&other, None, (&self.nominal, starts, true))?;
        let span = last.other - first.other;
        let limit = |k: usize| {
            let part = k as f64 / (compromises - 1) as f64;
            first.other + part.min(1.0 - SPARE) * span
        };
        let mut between: Vec<Option<Compromise<M, A>>> = Vec::new();
        let mut near = first.best.mechanism;
        for k in 1..compromises {
            let limited = other.within(limit(k));
            let found = search(&goal, Some(&limited), (&near, 1, false)).ok();
            near = found.as_ref().map_or(near, |found| found.best.mechanism);
            between.push(found);
        }
        near = last.best.mechanism;
        for (k, kept) in (1..compromises).zip(&mut between).rev() {
            let limited = other.within(limit(k));
            let found = search(&goal, Some(&limited), (&near, 1, false)).ok();
            let better = |a: &Compromise<M, A>, b: &Compromise<M, A>| {
                sense * a.best.goal < sense * b.best.goal
            };
            if let Some(found) = found {
                near = found.best.mechanism;
                if kept.as_ref().is_none_or(|kept| better(&found, kept)) {
                    *kept = Some(found);
                }
            }
        }
        let all: Vec<_> = [Some(first)].into_iter().chain(between).flatten().collect();
        Ok(front(all, |found| {
            [sense * found.best.goal, other_sense * found.other]
        }))
    }
}

/// Returns 1 for a goal that is made least, -1 for a goal that is to be greatest.
fn sense<M, A, const N: usize>(goal: &dyn CycleObjective<M, A, N>) -> f64 {
    goal.reported_goal(1.0) - goal.reported_goal(0.0)
}

/// Those than which none is smaller in both numbers.
fn front<T>(all: Vec<T>, of: impl Fn(&T) -> [f64; 2]) -> Vec<T> {
    let numbers: Vec<[f64; 2]> = all.iter().map(of).collect();
    let beaten = |k: usize| {
        let [a, b] = numbers[k];
        let better =
            |(j, [c, d]): (usize, &[f64; 2])| *c <= a && *d <= b && (*c < a || *d < b || j < k);
        numbers
            .iter()
            .enumerate()
            .any(|(j, other)| j != k && better((j, other)))
    };
    let kept = all.into_iter().enumerate().filter(|(k, _)| !beaten(*k));
    kept.map(|(_, found)| found).collect()
}
