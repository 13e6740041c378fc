//! Targets of a generated function, in lanes over mechanisms.

use core::f64::consts::TAU;
use core::marker::PhantomData;
use linkage_core::Cycle;
use std::boxed::Box;
use std::format;
use std::string::String;
use std::vec::Vec;

use super::DesignError;
use super::columns::Numbers;
use super::objective::{Candidates, Evaluate, Free, Objective, Rows};
use super::problem::ROOM;
use super::targets::{Targets, Timing};
use linkage_core::format::rounded;
use linkage_runtime::{DimensionSet, Parameter, Table};

/// Positions that are longer than the range by less than this part of it fill it: steps in degrees
/// are rounded.
const ROUNDING: f64 = 1e-12;

/// [`Targets`] of a generated function.
pub struct Sampled<M, A, C, F, const N: usize> {
    targets: Targets,
    function: F,
    /// Makes columns of the function, whether they are filled or not.
    columns: Box<dyn Fn() -> C + Send + Sync>,
    of: PhantomData<fn(&M, &A)>,
}

impl Targets {
    /// Makes an objective of it: the quantities and their derivatives are in the columns of this
    /// function, a `_sweep_sets_into` method such as `FourBarAssembly::path_sweep_sets_into`.
    ///
    /// The function has each quantity, its `sensitivity(..)` by all parameters that may vary, and,
    /// where inputs are free, its `velocity(..)`.
    #[must_use]
    pub fn computed_by<M, A, C, F, const N: usize>(self, function: F) -> Sampled<M, A, C, F, N>
    where
        M: DimensionSet<N> + Copy,
        F: Fn(&A, &[M], &[f64], &mut C) + Send + Sync,
        C: Table + Default + 'static,
    {
        self.computed_into(C::default, function)
    }

    /// Makes an objective of it as [`computed_by`](Self::computed_by) does, for columns whose
    /// heading is that of the object: `columns` makes columns of the function, empty ones.
    #[must_use]
    pub fn computed_into<M, A, C, F, const N: usize>(
        self,
        columns: impl Fn() -> C + Send + Sync + 'static,
        function: F,
    ) -> Sampled<M, A, C, F, N>
    where
        M: DimensionSet<N> + Copy,
        F: Fn(&A, &[M], &[f64], &mut C) + Send + Sync,
        C: Table,
    {
        Sampled {
            targets: self,
            function,
            columns: Box::new(columns),
            of: PhantomData,
        }
    }
}

impl<M, A, C, F, const N: usize> Sampled<M, A, C, F, N> {
    fn called(&self) -> String {
        format!("targets of {}", self.targets.quantities.join(", "))
    }

    fn count(&self, what: &'static str, expected: usize, found: usize) -> Option<DesignError> {
        let objective = self.called();
        (expected != found).then_some(DesignError::Count {
            what,
            objective,
            expected,
            found,
        })
    }

    /// Returns the mistakes of the given inputs.
    fn given(&self, cycle: &Cycle) -> Vec<DesignError> {
        let Timing::Given(inputs) = &self.targets.timing else {
            return Vec::new();
        };
        let outside = |x: &&f64| cycle.turn().is_none() && !(cycle.low..=cycle.high).contains(*x);
        let count = self.count("inputs", self.targets.targets.len(), inputs.len());
        let beyond = inputs
            .iter()
            .find(outside)
            .map(|&input| DesignError::OutOfRange {
                objective: self.called(),
                input,
                low: cycle.low,
                high: cycle.high,
            });
        count.into_iter().chain(beyond).collect()
    }

    /// Positions that are evenly spaced over more than there is.
    fn too_long(&self, cycle: &Cycle) -> Option<DesignError> {
        let &Timing::Evenly(step) = &self.targets.timing else {
            return None;
        };
        let range = cycle.high - cycle.low;
        let error = DesignError::TooLong {
            objective: self.called(),
            positions: self.targets.targets.len(),
            step,
            length: self.rest(step).abs(),
            range,
        };
        let fits = self.rest(step).abs() <= range * (1.0 + ROUNDING);
        (cycle.turn().is_none() && step.is_finite() && !fits).then_some(error)
    }

    /// Returns the distance from the first position to the last, if they are evenly spaced.
    fn rest(&self, step: f64) -> f64 {
        step * self.targets.targets.len().saturating_sub(1) as f64
    }

    /// The first number that is none.
    fn not_finite(&self) -> Option<DesignError> {
        let Targets {
            targets,
            weights,
            timing,
            ..
        } = &self.targets;
        let inputs: &[f64] = match timing {
            Timing::Given(inputs) => inputs,
            Timing::Evenly(step) => core::slice::from_ref(step),
            _ => &[],
        };
        let mut numbers = targets.iter().flatten().chain(weights).chain(inputs);
        let number = *numbers.find(|x| !x.is_finite())?;
        let objective = self.called();
        Some(DesignError::NotFinite { objective, number })
    }
}

impl<M, A, C, F, const N: usize> Objective<M, A> for Sampled<M, A, C, F, N>
where
    M: DimensionSet<N> + Copy + Send + Sync,
    A: Sync,
    F: Fn(&A, &[M], &[f64], &mut C) + Send + Sync,
    C: Table,
{
    fn title(&self) -> String {
        self.called()
    }

    fn rows(&self) -> usize {
        self.targets.targets.len() * self.targets.weights.len()
    }

    /// Without its weight, in the unit of the quantity.
    fn missed(&self, row: usize, value: f64) -> String {
        let Targets {
            quantities,
            targets,
            weights,
            ..
        } = &self.targets;
        let (position, k) = (row / weights.len() + 1, row % weights.len());
        let columns = (self.columns)();
        let heading = columns.heading();
        let numbers = Numbers::all(heading, quantities);
        let column = numbers.iter().nth(k).map(|nth| &heading.columns[nth.value]);
        let (name, unit) = column.map_or((self.called(), ""), |column| {
            (column.name.into(), column.unit)
        });
        let (by, unit) = match unit {
            "rad" => ((value / weights[k]).to_degrees().abs(), "deg"),
            unit => ((value / weights[k]).abs(), unit),
        };
        let space = if unit.is_empty() { "" } else { " " };
        let (by, count) = (rounded(by), targets.len());
        format!("by {by}{space}{unit} in `{name}` at position {position} of {count}")
    }

    fn free(&self, cycle: &Cycle) -> Option<Free> {
        let Targets {
            targets, timing, ..
        } = &self.targets;
        let count = match timing {
            Timing::Given(_) => return None,
            Timing::Evenly(_) => 1,
            _ => targets.len(),
        };
        let (low, high) = (cycle.low, cycle.high);
        let turn = cycle.turn();
        let mut bounds = match turn {
            // Inputs that differ by turns are the same: room to turn past the seam.
            Some(turn) => (low - ROOM * turn, high + ROOM * turn),
            None => (low, high),
        };
        if let (Timing::Evenly(step), None) = (timing, turn) {
            let rest = self.rest(*step);
            let first = low - rest.min(0.0);
            // Positions over the whole range, except for rounding, begin at its end.
            bounds = (first, (high - rest.max(0.0)).max(first));
        }
        let backwards = matches!(timing, Timing::Backwards);
        let from = if turn.is_some() { (low, high) } else { bounds };
        let flip = |(a, b): (f64, f64)| if backwards { (-b, -a) } else { (a, b) };
        Some(Free {
            count,
            bounds: flip(bounds),
            ordered: matches!(timing, Timing::InOrder | Timing::Backwards),
            turn,
            from: flip(from),
        })
    }

    /// The first one within the range, where the input turns.
    fn inputs(&self, free: &[f64], cycle: &Cycle) -> Vec<f64> {
        let timing = &self.targets.timing;
        let positions = 0..self.targets.targets.len();
        let inputs: Vec<f64> = positions
            .map(|position| timing.input(free, position).0)
            .collect();
        match (timing, cycle.turn(), inputs.first()) {
            (Timing::Given(_), _, _) | (_, None, _) | (_, _, None) => inputs,
            (_, Some(turn), Some(first)) => {
                let past = turn * ((first - cycle.low) / turn).floor();
                inputs.iter().map(|input| input - past).collect()
            }
        }
    }

    fn check(&self, cycle: &Cycle, parameters: &[Parameter], varied: &[usize]) -> Vec<DesignError> {
        let Targets {
            quantities,
            targets,
            weights,
            timing,
        } = &self.targets;
        let mut errors = self.given(cycle);
        if targets.is_empty() {
            let objective = self.called();
            errors.push(DesignError::Nothing {
                what: "no positions",
                objective,
            });
        }
        errors.extend(self.not_finite());
        errors.extend(self.too_long(cycle));
        let each = targets.first().map_or(0, Vec::len);
        errors.extend(self.count("weights", each, weights.len()));
        let uneven = targets.iter().find(|row| row.len() != each);
        errors.extend(uneven.and_then(|row| self.count("numbers of a target", each, row.len())));
        let free = !matches!(timing, Timing::Given(_));
        match Numbers::find(
            (self.columns)().heading(),
            quantities,
            free,
            parameters,
            varied,
        ) {
            Err(more) => errors.extend(more),
            Ok(numbers) => errors.extend(self.count("numbers of a target", numbers.len(), each)),
        }
        errors
    }

    fn evaluator(&self) -> Box<dyn Evaluate<M, A> + '_> {
        let columns = (self.columns)();
        let numbers = Numbers::all(columns.heading(), &self.targets.quantities);
        Box::new(Evaluator {
            objective: self,
            columns,
            numbers,
            sets: Vec::new(),
            inputs: Vec::new(),
        })
    }
}

struct Evaluator<'a, M, A, C, F, const N: usize> {
    objective: &'a Sampled<M, A, C, F, N>,
    columns: C,
    numbers: Numbers,
    sets: Vec<M>,
    inputs: Vec<f64>,
}

impl<M, A, C, F, const N: usize> Evaluate<M, A> for Evaluator<'_, M, A, C, F, N>
where
    M: DimensionSet<N> + Copy,
    F: Fn(&A, &[M], &[f64], &mut C) + Send + Sync,
    C: Table,
{
    fn evaluate(&mut self, candidates: &Candidates<'_, M, A>, rows: &mut Rows) {
        let count = candidates.mechanisms.len();
        if count == 0 {
            return;
        }
        let Targets {
            targets,
            weights,
            timing,
            ..
        } = &self.objective.targets;
        let each = candidates.free.len() / count;
        self.sets.clear();
        self.inputs.clear();
        for (index, mechanism) in candidates.mechanisms.iter().enumerate() {
            let free = &candidates.free[index * each..(index + 1) * each];
            for position in 0..targets.len() {
                let (input, _) = timing.input(free, position);
                self.sets.push(*mechanism);
                self.inputs.push(input);
            }
        }
        (self.objective.function)(
            candidates.assembly,
            &self.sets,
            &self.inputs,
            &mut self.columns,
        );
        // Row `at * width + k` of all is number `k` at position `at` of all.
        let (positions, width) = (targets.len(), weights.len());
        for (k, (number, weight)) in self.numbers.iter().zip(weights).enumerate() {
            let column = |column: usize| self.columns.column(column);
            let sensitivities = number.sensitivities.iter();
            let sensitivities: Vec<(usize, &[f64])> = sensitivities
                .map(|&(parameter, of)| (parameter, column(of)))
                .collect();
            let rates = number.rate.map(column);
            for (at, value) in column(number.value).iter().enumerate() {
                let position = at % positions;
                let (row, parameters, inputs) = rows.nth_mut(at * width + k);
                let difference = value - targets[position][k];
                let turns = match number.angle {
                    true => TAU * (difference / TAU).round(),
                    false => 0.0,
                };
                *row = weight * (difference - turns);
                for &(parameter, slopes) in &sensitivities {
                    parameters[parameter] = weight * slopes[at];
                }
                if let Some(rates) = rates {
                    let free = &candidates.free[at / positions * each..];
                    if let Some((index, by)) = timing.input(free, position).1 {
                        inputs[index] = by * weight * rates[at];
                    }
                }
            }
        }
    }
}
