//! Values at positions as the goal of a cycle, or as a condition beside others.

use linkage_core::Cycle;
use std::format;
use std::string::String;
use std::vec;
use std::vec::Vec;

use super::super::DesignError;
use super::super::least_squares::minimise;
use super::super::limits::{Limits, Linear};
use super::super::normal::Normal;
use super::super::objective::{Candidates, Free, Objective, Rows};
use super::super::problem::order;
use super::super::quasi_random::unit;
use super::{AuxiliaryVariable, Candidate, Chosen, Conditions, CycleObjective, Piece, PieceKey};
use linkage_core::format::rounded;
use linkage_runtime::{Dimensions, Parameter};

/// The rows of [`Targets`](super::super::Targets), or of another [`Objective`], next to figures of
/// the whole cycle: a path with a margin that is never below a limit, a pose with a low peak of
/// torque.
///
/// Inputs that the objective leaves free are variables of its own; the search begins with those
/// that suit its first mechanism best. Rows of an objective that is a condition must not be
/// negative, whatever is asked of them here.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit<W> {
    objective: W,
    sense: Sense,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Sense {
    Least,
    Closest,
    Within(f64),
}

/// Starts of free inputs in the first mechanism: enough for the best of the ways in which a path of
/// some points may be run through.
const STARTS: usize = 32;
/// The most steps from each of them.
const STEPS: usize = 60;
/// The part of the range by which a free input may change in the first step.
const REACH: f64 = 0.02;

impl<W> Fit<W> {
    /// The sum of the squares of all weighted differences is to be least: the goal.
    pub fn least(objective: W) -> Self {
        Self {
            objective,
            sense: Sense::Least,
        }
    }

    /// The largest weighted difference, without its sign, is to be least: the goal.
    pub fn closest(objective: W) -> Self {
        Self {
            objective,
            sense: Sense::Closest,
        }
    }

    /// No weighted difference may be larger than this, without its sign.
    pub fn within(objective: W, limit: f64) -> Self {
        Self {
            objective,
            sense: Sense::Within(limit),
        }
    }

    /// The rows for a mechanism and free inputs; `None` where it does not assemble.
    fn rows<M, A, const N: usize>(
        &self,
        candidate: &Candidate<'_, M, A>,
        free: &[f64],
    ) -> Option<Rows>
    where
        W: Objective<M, A>,
    {
        let mut rows = Rows::new(self.objective.rows(), N, free.len());
        rows.reset(1);
        let candidates = Candidates {
            assembly: candidate.motion.assembly,
            mechanisms: core::slice::from_ref(candidate.mechanism),
            free,
        };
        self.objective.evaluator().evaluate(&candidates, &mut rows);
        let finite = (0..rows.count()).all(|row| rows.row(0, row).0.is_finite());
        finite.then_some(rows)
    }

    /// Free inputs that suit a mechanism: the best of descents from several.
    fn suited<M, A, const N: usize>(
        &self,
        candidate: &Candidate<'_, M, A>,
        free: &Free,
    ) -> Option<Vec<f64>>
    where
        W: Objective<M, A>,
    {
        let limits = Limits {
            lower: vec![free.bounds.0; free.count],
            upper: vec![free.bounds.1; free.count],
            relations: order(free, 0),
        };
        let places: Vec<usize> = (0..free.count).collect();
        let sum = |x: &[f64], normal: &mut Normal| match self.rows::<M, A, N>(candidate, x) {
            Some(rows) => (0..rows.count()).for_each(|row| {
                let (value, _, slopes) = rows.row(0, row);
                normal.add(value, &places, slopes);
            }),
            None => normal.sum = f64::NAN,
        };
        let from = |start: usize| {
            let x = limits.nearest(&free.start(&unit(0, start, free.count)))?;
            let (descent, _) = minimise(x, &limits, STEPS, sum);
            let found = descent.here.sum.is_finite();
            found.then_some((descent.here.sum, descent.x))
        };
        let all = (0..STARTS).filter_map(from);
        all.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, x)| x)
    }

    /// That free inputs come one after the other.
    fn in_order<const N: usize>(free: Option<&Free>, inputs: &[f64]) -> Vec<Piece<N>> {
        let piece = |(nth, relation): (usize, Linear)| {
            let mut slopes = vec![0.0; inputs.len()];
            relation.terms.iter().for_each(|&(k, by)| slopes[k] = by);
            Piece {
                key: PieceKey::Nth(nth),
                value: -relation.slack(inputs),
                parameters: [0.0; N],
                auxiliary: slopes,
            }
        };
        let relations = free.map_or(Vec::new(), |free| order(free, 0));
        relations.into_iter().enumerate().map(piece).collect()
    }
}

/// The range as objectives know it.
fn cycle<M, A>(candidate: &Candidate<'_, M, A>) -> Cycle {
    let motion = &candidate.motion;
    Cycle {
        low: motion.range.0,
        high: motion.range.1,
        angle: motion.closed,
        samples: motion.positions,
    }
}

impl<M: Dimensions<N>, A, W: Objective<M, A>, const N: usize> CycleObjective<M, A, N> for Fit<W> {
    fn title(&self) -> String {
        let title = self.objective.title();
        match self.sense {
            _ if self.objective.is_condition() => title,
            Sense::Least => format!("least sum of squares of {title}"),
            Sense::Closest => format!("least difference from {title}"),
            Sense::Within(limit) => format!("{title} within {}", rounded(limit)),
        }
    }

    fn is_goal(&self) -> bool {
        !self.objective.is_condition() && !matches!(self.sense, Sense::Within(_))
    }

    fn check(&self, cycle: &Cycle, parameters: &[Parameter], varied: &[usize]) -> Vec<DesignError> {
        self.objective.check(cycle, parameters, varied)
    }

    fn auxiliary_variables(
        &self,
        candidate: &Candidate<'_, M, A>,
    ) -> Option<Vec<AuxiliaryVariable>> {
        let Some(free) = self.objective.free(&cycle(candidate)) else {
            return Some(Vec::new());
        };
        let (low, high) = candidate.motion.range;
        let variable = |start: f64| AuxiliaryVariable {
            start,
            bounds: free.bounds,
            reach: REACH * (high - low),
        };
        Some(
            self.suited::<M, A, N>(candidate, &free)?
                .into_iter()
                .map(variable)
                .collect(),
        )
    }

    fn evaluate(
        &self,
        candidate: &Candidate<'_, M, A>,
        chosen: Chosen<'_>,
    ) -> Option<Conditions<N>> {
        let rows = self.rows::<M, A, N>(candidate, chosen.auxiliary)?;
        let piece = |nth: usize| {
            let (value, parameters, auxiliary) = rows.row(0, nth);
            Piece {
                key: PieceKey::Nth(nth),
                value,
                parameters: core::array::from_fn(|k| parameters[k]),
                auxiliary: auxiliary.to_vec(),
            }
        };
        let pieces: Vec<Piece<N>> = (0..rows.count()).map(piece).collect();
        let mut asked = Conditions::default();
        match self.sense {
            _ if self.objective.is_condition() => {
                let below = |piece: &Piece<N>| vec![piece.times(-1.0, 0.0)];
                asked.conditions.extend(pieces.iter().map(below));
            }
            Sense::Least => {
                asked
                    .goal
                    .push(sum_of_squares(&pieces, chosen.auxiliary.len()));
                asked.squares = pieces;
            }
            Sense::Closest => asked.goal = sizes(&pieces, 0.0),
            Sense::Within(limit) => asked.conditions.push(sizes(&pieces, limit)),
        }
        let free = self.objective.free(&cycle(candidate));
        let in_order = Self::in_order(free.as_ref(), chosen.auxiliary);
        if !in_order.is_empty() {
            asked.conditions.push(in_order);
        }
        Some(asked)
    }

    /// Slopes of all rows: those of a sum of squares vanish where it does.
    fn known_by(&self, candidate: &Candidate<'_, M, A>, chosen: Chosen<'_>) -> Option<Vec<f64>> {
        let rows = self.rows::<M, A, N>(candidate, chosen.auxiliary)?;
        let slopes = (0..rows.count()).flat_map(|row| rows.row(0, row).1.to_vec());
        Some(slopes.collect())
    }
}

fn sum_of_squares<const N: usize>(rows: &[Piece<N>], free: usize) -> Piece<N> {
    let mut sum = Piece {
        key: PieceKey::Nth(0),
        value: 0.0,
        parameters: [0.0; N],
        auxiliary: vec![0.0; free],
    };
    for row in rows {
        sum.value += row.value * row.value;
        let slopes = row.parameters.iter().chain(&row.auxiliary);
        let sums = sum.parameters.iter_mut().chain(&mut sum.auxiliary);
        sums.zip(slopes)
            .for_each(|(sum, slope)| *sum += 2.0 * row.value * slope);
    }
    sum
}

/// The amounts by which the sizes of rows are above a limit.
fn sizes<const N: usize>(rows: &[Piece<N>], limit: f64) -> Vec<Piece<N>> {
    let both = |(nth, row): (usize, &Piece<N>)| {
        [1.0, -1.0].map(|sign| Piece {
            key: PieceKey::Nth(2 * nth + usize::from(sign < 0.0)),
            ..row.times(sign, -limit)
        })
    };
    rows.iter().enumerate().flat_map(both).collect()
}
