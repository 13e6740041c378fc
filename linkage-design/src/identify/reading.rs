//! Readings that exist or are possible: quantities of a generated function at inputs.

use core::f64::consts::TAU;
use core::marker::PhantomData;
use std::boxed::Box;
use std::string::{String, ToString};
use std::vec;
use std::vec::Vec;

use crate::columns::{Number, Numbers};
use crate::error::DesignError;
use linkage_runtime::{Dimensions, Heading, Parameter, Table};

/// A quantity at positions of the input, with readings or without: `Measured::new("tracer",
/// values)` was measured, `Measured::offer("psi")` could be.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    quantity: String,
    /// Readings by position; `None` if nothing was read.
    values: Option<Vec<Vec<f64>>>,
    inputs: Vec<f64>,
    /// Standard deviations by position, or one row for all.
    deviations: Vec<Vec<f64>>,
}

impl Measured {
    /// Readings of all numbers of a quantity at each position; NaN where one is missing.
    #[must_use]
    pub fn new<const K: usize>(quantity: &str, values: impl IntoIterator<Item = [f64; K]>) -> Self {
        Self {
            values: Some(values.into_iter().map(|row| row.to_vec()).collect()),
            ..Self::offer(quantity)
        }
    }

    /// A quantity that could be measured, should the readings not determine everything.
    #[must_use]
    pub fn offer(quantity: &str) -> Self {
        Self {
            quantity: quantity.to_string(),
            values: None,
            inputs: Vec::new(),
            deviations: Vec::new(),
        }
    }

    /// The inputs, one for each position, which are taken to be exact.
    #[must_use]
    pub fn at_inputs(mut self, inputs: impl IntoIterator<Item = f64>) -> Self {
        self.inputs = inputs.into_iter().collect();
        self
    }

    /// The standard deviation of each number of the quantity, the same at all positions, in its
    /// unit.
    ///
    /// Without deviations all readings are taken to be as good as each other, and how good is found
    /// from their scatter.
    #[must_use]
    pub fn deviations<const K: usize>(mut self, deviations: [f64; K]) -> Self {
        self.deviations = vec![deviations.to_vec()];
        self
    }

    /// Sets standard deviations as [`deviations`](Self::deviations) does, for each position.
    #[must_use]
    pub fn deviations_each<const K: usize>(
        mut self,
        deviations: impl IntoIterator<Item = [f64; K]>,
    ) -> Self {
        self.deviations = deviations.into_iter().map(|row| row.to_vec()).collect();
        self
    }

    /// The quantity and its sensitivities are in the columns of this function, a `_sweep_sets_into`
    /// method such as `FourBarAssembly::path_sweep_sets_into`.
    #[must_use]
    pub fn computed_by<M, A, C, F, const N: usize>(self, function: F) -> Readings<M, A, C, F, N>
    where
        M: Dimensions<N> + Copy,
        F: Fn(&A, &[M], &[f64], &mut C) + Send + Sync,
        C: Table + Default,
    {
        Readings {
            measured: self,
            function,
            of: PhantomData,
        }
    }
}

/// [`Measured`] of a generated function.
pub struct Readings<M, A, C, F, const N: usize> {
    measured: Measured,
    function: F,
    of: PhantomData<fn(&M, &A) -> C>,
}

/// One number at one position.
#[derive(Clone, Debug)]
pub(super) struct ReadingRow {
    pub(super) number: &'static str,
    pub(super) unit: &'static str,
    pub(super) input_name: &'static str,
    pub(super) input: f64,
    /// The reading, NaN if there is none.
    pub(super) reading: f64,
    /// The value minus the reading, without whole turns of an angle.
    pub(super) difference: f64,
    pub(super) deviation: f64,
    /// Derivatives of the value by the unknown parameters.
    pub(super) slopes: Vec<f64>,
}

/// A source of rows.
pub(super) trait Source<M, A> {
    fn check(&self, parameters: &[Parameter], unknown: &[usize]) -> Vec<DesignError>;
    /// Returns true if standard deviations are given.
    fn has_deviations(&self) -> bool;
    fn quantity(&self) -> &str;
    /// Returns the other numbers of the function with derivatives with respect to all unknown
    /// parameters, at the same inputs, as if each number had a standard deviation of 1.
    fn beside(&self, assembly: &A, mechanism: &M, unknown: &[usize]) -> Vec<ReadingRow>;
    /// All rows of a mechanism, missing readings left out.
    fn rows(&self, assembly: &A, mechanism: &M, unknown: &[usize]) -> Vec<ReadingRow>;
}

impl<M, A, C, F, const N: usize> Source<M, A> for Readings<M, A, C, F, N>
where
    M: Dimensions<N> + Copy,
    F: Fn(&A, &[M], &[f64], &mut C),
    C: Table + Default,
{
    fn check(&self, parameters: &[Parameter], unknown: &[usize]) -> Vec<DesignError> {
        let measured = &self.measured;
        let names = [measured.quantity.clone()];
        let mut errors = Vec::new();
        let count = |what, expected, found| DesignError::Count {
            what,
            objective: measured.quantity.clone(),
            expected,
            found,
        };
        if measured.inputs.is_empty() {
            errors.push(DesignError::Nothing {
                what: "no inputs; name them with `at`",
                objective: measured.quantity.clone(),
            });
        }
        if let Some(&number) = measured.inputs.iter().find(|input| !input.is_finite()) {
            let objective = measured.quantity.clone();
            errors.push(DesignError::NotFinite { objective, number });
        }
        if let Some(values) = &measured.values
            && values.len() != measured.inputs.len()
        {
            errors.push(count("inputs", values.len(), measured.inputs.len()));
        }
        if measured.deviations.len() > 1 && measured.deviations.len() != measured.inputs.len() {
            errors.push(count(
                "rows of deviations",
                measured.inputs.len(),
                measured.deviations.len(),
            ));
        }
        let is_wrong = |deviation: &&f64| !(**deviation > 0.0 && deviation.is_finite());
        if let Some(&deviation) = measured.deviations.iter().flatten().find(is_wrong) {
            let quantity = measured.quantity.clone();
            errors.push(DesignError::Deviation {
                quantity,
                deviation,
            });
        }
        let columns = C::default();
        match Numbers::find(columns.heading(), &names, false, parameters, unknown) {
            Err(more) => errors.extend(more),
            Ok(numbers) => {
                let rows = measured.values.iter().flatten().chain(&measured.deviations);
                if let Some(row) = rows.into_iter().find(|row| row.len() != numbers.len()) {
                    errors.push(count("numbers at a position", numbers.len(), row.len()));
                }
            }
        }
        errors
    }

    fn has_deviations(&self) -> bool {
        !self.measured.deviations.is_empty()
    }

    fn quantity(&self) -> &str {
        &self.measured.quantity
    }

    fn rows(&self, assembly: &A, mechanism: &M, unknown: &[usize]) -> Vec<ReadingRow> {
        let columns = self.columns(assembly, mechanism);
        let quantity = core::slice::from_ref(&self.measured.quantity);
        let numbers = Numbers::all(columns.heading(), quantity);
        let numbers = numbers.iter().enumerate();
        let rows = numbers.map(|(k, number)| self.rows_of(&columns, number, Some(k), unknown));
        rows.flatten().collect()
    }

    fn beside(&self, assembly: &A, mechanism: &M, unknown: &[usize]) -> Vec<ReadingRow> {
        let columns = self.columns(assembly, mechanism);
        let numbers = Numbers::beside(columns.heading(), &self.measured.quantity, unknown);
        let rows = numbers
            .iter()
            .map(|number| self.rows_of(&columns, number, None, unknown));
        rows.flatten().collect()
    }
}

impl<M, A, C, F, const N: usize> Readings<M, A, C, F, N>
where
    M: Dimensions<N> + Copy,
    F: Fn(&A, &[M], &[f64], &mut C),
    C: Table + Default,
{
    /// The function at all inputs.
    fn columns(&self, assembly: &A, mechanism: &M) -> C {
        let inputs = &self.measured.inputs;
        let mut columns = C::default();
        let mechanisms = vec![*mechanism; inputs.len()];
        (self.function)(assembly, &mechanisms, inputs, &mut columns);
        columns
    }

    /// The rows of a number, which was `read` as this one of its quantity, or not at all.
    fn rows_of(
        &self,
        columns: &C,
        number: &Number,
        read: Option<usize>,
        unknown: &[usize],
    ) -> Vec<ReadingRow> {
        let measured = &self.measured;
        let Heading {
            columns: all,
            arguments,
            ..
        } = columns.heading();
        let heading = &all[number.value];
        // Parameters that the list of sensitivities leaves out are no unknowns: the check has seen
        // to it.
        let places = unknown.iter().filter_map(|index| {
            let sensitivity = number
                .sensitivities
                .iter()
                .find(|(sensitivity, _)| sensitivity == index);
            sensitivity.map(|&(_, column)| column)
        });
        let places: Vec<usize> = places.collect();
        let mut rows = Vec::new();
        for (position, &input) in measured.inputs.iter().enumerate() {
            let values = read.and_then(|k| Some((k, measured.values.as_ref()?)));
            let reading = values.map(|(k, values)| values[position][k]);
            if reading.is_some_and(f64::is_nan) {
                continue;
            }
            let value = columns.column(number.value)[position];
            let reading = reading.unwrap_or(f64::NAN);
            let difference = value - reading;
            let turns = if number.angle {
                TAU * (difference / TAU).round()
            } else {
                0.0
            };
            let deviations = measured
                .deviations
                .get(position)
                .or(measured.deviations.first());
            let deviation = read.and_then(|k| Some(deviations?[k]));
            rows.push(ReadingRow {
                number: heading.name,
                unit: heading.unit,
                input_name: arguments.first().copied().unwrap_or("input"),
                input,
                reading,
                difference: difference - turns,
                deviation: deviation.unwrap_or(1.0),
                slopes: places
                    .iter()
                    .map(|&column| columns.column(column)[position])
                    .collect(),
            });
        }
        rows
    }
}

/// A parameter that was measured itself.
#[derive(Clone, Debug)]
pub(super) struct Direct {
    pub(super) name: String,
    pub(super) value: f64,
    pub(super) deviation: f64,
}

pub(super) type Sources<'a, M, A> = Vec<Box<dyn Source<M, A> + 'a>>;
