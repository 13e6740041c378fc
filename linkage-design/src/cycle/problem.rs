//! A checked design problem of a cycle: variables as a list of numbers, and their effects.

use core::ops::Range;
use std::vec;
use std::vec::Vec;

use super::super::DesignError;
use super::super::limits::Limits;
use super::super::minimax::{FunctionRow, Groups, Key};
use super::{AuxiliaryVariable, Candidate, Chosen, CycleObjective, Motion, Piece, PieceKey};
use linkage_runtime::{AssemblyError, Circuits, Dimensions};

/// The function that assembles a mechanism in the modes of another one.
pub(super) type Assemble<'p, M, A> = dyn Fn(&M) -> Result<A, AssemblyError> + Sync + 'p;

/// A problem, which searches on several threads share. The variables are the parameters that vary,
/// then those that each objective has for itself.
pub(super) struct Problem<'p, M, A, const N: usize> {
    pub(super) nominal: [f64; N],
    /// Indices of the parameters that vary, in ascending order.
    pub(super) varied: Vec<usize>,
    /// Their limits.
    pub(super) limits: Limits,
    /// Those of them that take some values only.
    pub(super) catalogues: Vec<(usize, Vec<f64>)>,
    pub(super) range: (f64, f64),
    /// True if the range is a full turn.
    pub(super) closed: bool,
    pub(super) positions: usize,
    pub(super) objectives: &'p [&'p (dyn CycleObjective<M, A, N> + 'p)],
    pub(super) assemble: &'p Assemble<'p, M, A>,
    pub(super) circuits: &'p (dyn Fn(&M) -> Result<Circuits<A>, AssemblyError> + Sync + 'p),
}

/// The position of a search, and its bounds.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SearchStart {
    pub(super) x: Vec<f64>,
    pub(super) limits: Limits,
    /// The largest change of each variable in the first step.
    pub(super) reach: Vec<f64>,
    /// The ranges of the variables of each objective.
    pub(super) auxiliary: Vec<Range<usize>>,
    /// The conditions that were added to each objective.
    pub(super) added: Vec<Vec<Vec<f64>>>,
}

impl SearchStart {
    /// The choice for the objective with this number, at some variables.
    pub(super) fn chosen<'c>(&'c self, objective: usize, x: &'c [f64]) -> Chosen<'c> {
        Chosen {
            auxiliary: &x[self.auxiliary[objective].clone()],
            added: &self.added[objective],
        }
    }
}

/// The largest changes of the goal and of each condition in a first step: the units in which both
/// are measured.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Sizes {
    pub(super) goal: f64,
    pub(super) conditions: Vec<f64>,
}

/// The part of the width of its bounds by which a parameter may change in the first step. The
/// search doubles it while it does well.
const REACH: f64 = 0.15;

impl<M: Dimensions<N>, A, const N: usize> Problem<'_, M, A, N> {
    /// The start of a search: the mechanism nearest to some dimensions within limits, and the
    /// variables that suit it.
    pub(super) fn start(
        &self,
        limits: &Limits,
        values: Vec<f64>,
    ) -> Result<SearchStart, DesignError> {
        let x = limits.nearest(&values).unwrap_or(values);
        let reach = |j: usize| {
            let width = limits.upper[j] - limits.lower[j];
            // A parameter that its bounds hold has no width; it is measured by something.
            if width > 0.0 { REACH * width } else { 1.0 }
        };
        let mut start = SearchStart {
            reach: (0..x.len()).map(reach).collect(),
            x,
            limits: limits.clone(),
            auxiliary: Vec::new(),
            added: vec![Vec::new(); self.objectives.len()],
        };
        for objective in self.objectives {
            let auxiliary =
                |candidate: &Candidate<'_, M, A>| objective.auxiliary_variables(candidate);
            let variables: Vec<AuxiliaryVariable> = self
                .tried(&start.x, auxiliary)
                .ok_or_else(|| self.refused(&start))?;
            let first = start.reach.len();
            for AuxiliaryVariable {
                start: value,
                bounds: (low, high),
                reach,
            } in variables
            {
                start.x.push(value);
                start.limits.lower.push(low);
                start.limits.upper.push(high);
                start.reach.push(reach);
            }
            start.auxiliary.push(first..start.reach.len());
        }
        Ok(start)
    }

    /// The parameters that vary, in the first mechanism.
    pub(super) fn first(&self) -> Vec<f64> {
        let values = self.varied.iter().map(|&index| self.nominal[index]);
        values.collect()
    }

    /// The mechanism with these variables.
    pub(super) fn mechanism(&self, x: &[f64]) -> M {
        let mut values = self.nominal;
        for (&index, x) in self.varied.iter().zip(x) {
            values[index] = *x;
        }
        M::from_values(&values)
    }

    /// Something of the mechanism with these variables; `None` if it does not assemble.
    pub(super) fn tried<R>(
        &self,
        x: &[f64],
        of: impl FnOnce(&Candidate<'_, M, A>) -> Option<R>,
    ) -> Option<R> {
        let assembly = (self.assemble)(&self.mechanism(x)).ok()?;
        self.assembled(x, &assembly, of)
    }

    pub(super) fn assembled<R>(
        &self,
        x: &[f64],
        assembly: &A,
        of: impl FnOnce(&Candidate<'_, M, A>) -> Option<R>,
    ) -> Option<R> {
        let mechanism = self.mechanism(x);
        let motion = Motion {
            assembly,
            range: self.range,
            closed: self.closed,
            positions: self.positions,
        };
        let assemble = |mechanism: &M| (self.assemble)(mechanism).ok();
        of(&Candidate::new(&mechanism, motion, &assemble))
    }

    /// Goal and conditions of a candidate in their own units; those of an objective come together,
    /// in the order of the objectives.
    pub(super) fn asked(
        &self,
        start: &SearchStart,
        x: &[f64],
        candidate: &Candidate<'_, M, A>,
    ) -> Option<Groups> {
        let mut groups = Groups::default();
        for (k, objective) in self.objectives.iter().enumerate() {
            let asked = objective.evaluate(candidate, start.chosen(k, x))?;
            let row = |piece: &Piece<N>| self.row(piece, &start.auxiliary[k], x.len());
            let rows = |pieces: Vec<Piece<N>>| pieces.iter().map(row).collect();
            groups
                .objective
                .extend::<Vec<FunctionRow>>(rows(asked.goal));
            groups
                .squares
                .extend::<Vec<FunctionRow>>(rows(asked.squares));
            groups
                .conditions
                .extend(asked.conditions.into_iter().map(rows));
        }
        let finite = |row: &FunctionRow| {
            row.value.is_finite() && row.slopes.iter().all(|slope| slope.is_finite())
        };
        let all = groups
            .conditions
            .iter()
            .chain([&groups.objective])
            .flatten()
            .all(finite);
        all.then_some(groups)
    }

    pub(super) fn row(
        &self,
        piece: &Piece<N>,
        indices: &Range<usize>,
        variables: usize,
    ) -> FunctionRow {
        let mut slopes = vec![0.0; variables];
        for (slope, &index) in slopes.iter_mut().zip(&self.varied) {
            *slope = piece.parameters[index];
        }
        // Figures have no variables of their own and leave the list empty.
        for (slope, value) in slopes[indices.clone()].iter_mut().zip(&piece.auxiliary) {
            *slope = *value;
        }
        let key = match piece.key {
            PieceKey::Nth(nth) => Key::Nth(nth),
            PieceKey::At(input) => Key::At(input),
        };
        FunctionRow {
            key,
            value: piece.value,
            slopes,
        }
    }

    /// The units of goal and conditions, from their slopes at a point.
    pub(super) fn sizes(&self, start: &SearchStart) -> Option<Sizes> {
        let groups = self.tried(&start.x, |candidate| self.asked(start, &start.x, candidate))?;
        let change = |row: &FunctionRow| {
            row.slopes
                .iter()
                .zip(&start.reach)
                .map(|(s, r)| (s * r).abs())
                .sum::<f64>()
        };
        let size = |rows: &Vec<FunctionRow>| {
            let most = rows.iter().map(change).fold(0.0, f64::max);
            // A condition that no variable changes is measured by its own value.
            if most > 0.0 {
                most
            } else {
                rows.iter()
                    .map(|row| row.value.abs())
                    .fold(f64::MIN_POSITIVE, f64::max)
            }
        };
        Some(Sizes {
            goal: size(&groups.objective),
            conditions: groups.conditions.iter().map(size).collect(),
        })
    }

    /// Goal and conditions, measured by their sizes.
    pub(super) fn groups(&self, start: &SearchStart, x: &[f64], sizes: &Sizes) -> Option<Groups> {
        let mut groups = self.tried(x, |candidate| self.asked(start, x, candidate))?;
        scale(&mut groups.objective, sizes.goal);
        scale(&mut groups.squares, sizes.goal.sqrt());
        groups
            .conditions
            .iter_mut()
            .zip(&sizes.conditions)
            .for_each(|(rows, size)| scale(rows, *size));
        Some(groups)
    }

    /// Lets all objectives look for further conditions, and adds them; whether there are any.
    pub(super) fn refine(&self, start: &mut SearchStart) -> bool {
        let refined = |candidate: &Candidate<'_, M, A>| {
            let objectives = self.objectives.iter().enumerate();
            let more = objectives
                .map(|(k, objective)| objective.refine(candidate, start.chosen(k, &start.x)));
            Some(more.collect::<Vec<_>>())
        };
        let more = self.tried(&start.x, refined).unwrap_or_default();
        let any = more.iter().any(|more| !more.is_empty());
        for (added, more) in start.added.iter_mut().zip(more) {
            added.extend(more);
        }
        any
    }
}

fn scale(rows: &mut [FunctionRow], size: f64) {
    for row in rows {
        row.value /= size;
        row.slopes.iter_mut().for_each(|slope| *slope /= size);
    }
}
