//! A checked design problem: variables as a list of numbers, and their effects.

mod conditions;
mod sizes;

use core::f64::consts::TAU;
use core::ops::Range;
use linkage_core::Cycle;
use std::boxed::Box;
use std::vec::Vec;

use super::limits::{Limits, Linear};
use super::normal::{Block, Normal};
use super::objective::{Candidates, Evaluate, Free, Objective, Rows};
use super::optimum::Optimum;
use linkage_runtime::{DimensionSet, Parameter};

/// Positive bounds with a larger ratio say nothing of the size: starts then have every order of
/// size alike.
const WIDE: f64 = 100.0;

/// Turns that an angle has on both sides: a descent does not turn a part further.
pub(crate) const ROOM: f64 = 2.0;

/// The parts of a problem besides the objectives.
pub(crate) struct Given<M> {
    /// The parameters that do not vary, and those that do.
    pub(crate) nominal: M,
    /// Indices of the parameters that vary, in ascending order.
    pub(crate) varied: Vec<usize>,
    /// Their limits.
    pub(crate) limits: Limits,
    /// The variables that take some values only. The values ascend.
    pub(crate) catalogues: Vec<(usize, Vec<f64>)>,
    /// The range of the mechanism.
    pub(crate) cycle: Cycle,
}

/// The variables are the parameters that vary, then the free inputs of each objective.
pub(crate) struct Problem<'a, M, A, const N: usize> {
    nominal: M,
    pub(crate) varied: Vec<usize>,
    pub(crate) limits: Limits,
    /// Bounds of starts.
    starts: Vec<(f64, f64)>,
    pub(crate) catalogues: Vec<(usize, Vec<f64>)>,
    pub(crate) cycle: Cycle,
    pub(crate) objectives: &'a [Box<dyn Objective<M, A> + 'a>],
    free: Vec<Option<Free>>,
    /// The size of each row of a condition, from its own numbers; see [`measured`](Self::measured).
    sizes: Vec<f64>,
}

impl<'a, M: DimensionSet<N> + Copy, A, const N: usize> Problem<'a, M, A, N> {
    pub(crate) fn new(
        given: Given<M>,
        objectives: &'a [Box<dyn Objective<M, A> + 'a>],
        free: Vec<Option<Free>>,
    ) -> Self {
        let mut limits = given.limits;
        let starts = limits
            .lower
            .iter()
            .copied()
            .zip(limits.upper.iter().copied())
            .collect();
        for (j, &index) in given.varied.iter().enumerate() {
            let width = limits.upper[j] - limits.lower[j];
            if given.nominal.declared()[index].unit == "rad" && width >= TAU - Cycle::TURN {
                // An angle that may have any direction has no bounds: room to turn past the seam.
                limits.lower[j] -= ROOM * TAU;
                limits.upper[j] += ROOM * TAU;
            }
        }
        for free in free.iter().flatten() {
            let first = limits.len();
            limits.lower.resize(first + free.count, free.bounds.0);
            limits.upper.resize(first + free.count, free.bounds.1);
            limits.relations.extend(order(free, first));
        }
        Self {
            nominal: given.nominal,
            varied: given.varied,
            limits,
            starts,
            catalogues: given.catalogues,
            cycle: given.cycle,
            objectives,
            free,
            sizes: Vec::new(),
        }
    }

    /// The widths between the bounds.
    pub(crate) fn widths(&self) -> Vec<f64> {
        let bounds = self.limits.lower.iter().zip(&self.limits.upper);
        bounds.map(|(low, high)| high - low).collect()
    }

    /// The parameter of a variable that is one.
    pub(crate) fn parameter(&self, variable: usize) -> Parameter {
        self.nominal.declared()[self.varied[variable]]
    }

    /// The mechanism with these variables.
    pub(crate) fn mechanism(&self, x: &[f64]) -> M {
        let mut values = self.nominal.numbers();
        for (&index, x) in self.varied.iter().zip(x) {
            values[index] = *x;
        }
        self.nominal.with_numbers(&values)
    }

    /// Returns the places of the free inputs of an objective among the variables.
    pub(crate) fn inputs(&self, objective: usize) -> Range<usize> {
        let count = |free: &Option<Free>| free.as_ref().map_or(0, |free| free.count);
        let first = self.varied.len() + self.free[..objective].iter().map(count).sum::<usize>();
        first..first + count(&self.free[objective])
    }

    /// A place within the bounds from numbers between 0 and 1.
    fn within_bounds(&self, unit: &[f64]) -> Vec<f64> {
        let value = |(u, &(low, high)): (&f64, &(f64, f64))| match low > 0.0 && high > WIDE * low {
            true => low * (high / low).powf(*u),
            false => low + (high - low) * u,
        };
        let mut x: Vec<f64> = unit.iter().zip(&self.starts).map(value).collect();
        for (objective, free) in self.free.iter().enumerate() {
            if let Some(free) = free {
                x.extend(free.start(&unit[self.inputs(objective)]));
            }
        }
        x
    }

    /// A start from numbers between 0 and 1, on all equalities; or the relations that it
    /// contradicts.
    pub(crate) fn start(&self, unit: &[f64]) -> Result<Vec<f64>, Vec<usize>> {
        let x = self.within_bounds(unit);
        let Some(x) = self.limits.on_equalities(x.clone()) else {
            return Err(self.limits.broken(&x));
        };
        match self.limits.hold(&x) {
            true => Ok(x),
            false => Err(self.limits.broken(&x)),
        }
    }

    /// The period of each variable that has one: angles and the inputs of a turn are the same after
    /// a turn.
    pub(crate) fn periods(&self) -> Vec<Option<f64>> {
        let angle = |j: usize| (self.parameter(j).unit == "rad").then_some(TAU);
        let mut periods: Vec<Option<f64>> = (0..self.varied.len()).map(angle).collect();
        for free in self.free.iter().flatten() {
            periods.resize(periods.len() + free.count, free.turn);
        }
        periods
    }

    /// The optimum with directions within the bounds of starts.
    pub(crate) fn wrapped(&self, optimum: &Optimum) -> Optimum {
        let mut wrapped = optimum.clone();
        for (j, (low, _)) in self.starts.iter().enumerate() {
            if self.limits.lower[j] < *low {
                wrapped.x[j] -= TAU * ((wrapped.x[j] - low) / TAU).floor();
            }
        }
        wrapped
    }

    /// Returns the number of residuals.
    pub(crate) fn residuals(&self) -> usize {
        self.objectives
            .iter()
            .filter(|objective| !objective.is_condition())
            .map(|objective| objective.rows())
            .sum()
    }
}

/// The inputs of an objective come in order, all within a turn.
pub(crate) fn order(free: &Free, first: usize) -> Vec<Linear> {
    let less = |a: usize, b: usize, most: f64| Linear {
        terms: Vec::from([(first + a, 1.0), (first + b, -1.0)]),
        most,
        equality: false,
    };
    if !free.ordered || free.count < 2 {
        return Vec::new();
    }
    let mut relations: Vec<Linear> = (1..free.count).map(|k| less(k - 1, k, 0.0)).collect();
    relations.extend(free.turn.map(|turn| less(free.count - 1, 0, turn)));
    relations
}

/// Evaluates a problem for many places side by side, with memory of its own.
pub(crate) struct Evaluator<'a, M, A, const N: usize> {
    problem: &'a Problem<'a, M, A, N>,
    objectives: Vec<(Box<dyn Evaluate<M, A> + 'a>, Rows)>,
    mechanisms: Vec<M>,
    free: Vec<f64>,
    block: Block,
    free_slopes: Vec<(usize, f64)>,
}

impl<'a, M: DimensionSet<N> + Copy, A, const N: usize> Evaluator<'a, M, A, N> {
    pub(crate) fn new(problem: &'a Problem<'a, M, A, N>) -> Self {
        let rows = |(objective, free): (_, &Option<Free>)| {
            let objective: &'a (dyn Objective<M, A> + 'a) = Box::as_ref(objective);
            let free = free.as_ref().map_or(0, |free| free.count);
            (objective.evaluator(), Rows::new(objective.rows(), N, free))
        };
        Self {
            problem,
            objectives: problem
                .objectives
                .iter()
                .zip(&problem.free)
                .map(rows)
                .collect(),
            mechanisms: Vec::new(),
            free: Vec::new(),
            block: Block::default(),
            free_slopes: Vec::new(),
        }
    }

    /// Evaluates all objectives at some places; [`rows`](Self::rows) has the result.
    pub(crate) fn evaluate<'x>(
        &mut self,
        assembly: &A,
        places: impl Iterator<Item = &'x [f64]> + Clone,
    ) {
        self.mechanisms.clear();
        self.mechanisms
            .extend(places.clone().map(|x| self.problem.mechanism(x)));
        for (index, (objective, rows)) in self.objectives.iter_mut().enumerate() {
            let inputs = self.problem.inputs(index);
            self.free.clear();
            places
                .clone()
                .for_each(|x| self.free.extend_from_slice(&x[inputs.clone()]));
            rows.reset(self.mechanisms.len());
            let candidates = Candidates {
                assembly,
                mechanisms: &self.mechanisms,
                free: &self.free,
            };
            objective.evaluate(&candidates, rows);
        }
    }

    /// The rows of an objective, after the last evaluation.
    pub(crate) fn rows(&self, objective: usize) -> &Rows {
        &self.objectives[objective].1
    }

    /// Fills the sum of squares of a place with its derivatives, after the last evaluation.
    pub(crate) fn normal(&mut self, start: usize, normal: &mut Normal) {
        self.value(start, normal);
        self.derivatives(start, normal);
    }

    /// Fills the sum of squares of a place and its conditions, after the last evaluation.
    pub(crate) fn value(&self, start: usize, normal: &mut Normal) {
        normal.sum = 0.0;
        normal.conditions.clear();
        for (index, (_, rows)) in self.objectives.iter().enumerate() {
            if !self.problem.objectives[index].is_condition() {
                let residuals = (0..rows.count()).map(|row| rows.row(start, row).0);
                residuals.for_each(|residual| normal.sum += residual * residual);
                continue;
            }
            for row in 0..rows.count() {
                let (value, parameters, free) = rows.row(start, row);
                let mut dense = std::vec![0.0; self.problem.limits.len()];
                for (slope, &parameter) in dense.iter_mut().zip(&self.problem.varied) {
                    *slope = parameters[parameter];
                }
                dense[self.problem.inputs(index)].copy_from_slice(free);
                normal.conditions.push((value, dense));
            }
        }
    }

    /// Fills the derivatives of the sum of squares of a place, after the last evaluation.
    pub(crate) fn derivatives(&mut self, start: usize, normal: &mut Normal) {
        normal.gradient.fill(0.0);
        normal.gram.fill(0.0);
        let (varied, count) = (&self.problem.varied, self.problem.limits.len());
        // A single free input is in all rows; each of several is in a few.
        let dense = if count == varied.len() + 1 {
            count
        } else {
            varied.len()
        };
        self.block.begin(dense);
        for (index, (_, rows)) in self.objectives.iter().enumerate() {
            if self.problem.objectives[index].is_condition() {
                continue;
            }
            let inputs = self.problem.inputs(index);
            for row in 0..rows.count() {
                let (value, parameters, free) = rows.row(start, row);
                let (slopes, others) = self.block.push(value).split_at_mut(varied.len());
                for (slope, &parameter) in slopes.iter_mut().zip(varied) {
                    *slope = parameters[parameter];
                }
                others.iter_mut().zip(free).for_each(|(to, x)| *to = *x);
                if dense < count {
                    let free = inputs.clone().zip(free.iter().copied());
                    let free = free.filter(|(_, slope)| *slope != 0.0);
                    self.free_slopes.clear();
                    self.free_slopes.extend(free);
                    normal.add_inputs(&self.block, &self.free_slopes);
                }
            }
            self.block.add_products();
        }
        normal.take_block(&self.block);
    }
}
