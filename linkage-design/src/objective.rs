//! Objectives as rows of residuals or conditions with exact derivatives.

use linkage_core::Cycle;
use std::boxed::Box;
use std::format;
use std::string::String;
use std::vec;
use std::vec::Vec;

use super::DesignError;
use linkage_core::format::rounded;
use linkage_runtime::Parameter;

/// Something that is wanted of a mechanism: rows of residuals, whose sum of squares is made least,
/// or of conditions, which must not be negative.
///
/// [`Targets`](super::Targets) are the usual ones. One of your own needs rows with derivatives by
/// all parameters, and by the inputs that it leaves free, if there are any.
pub trait Objective<M, A>: Send + Sync {
    /// Returns the name in messages.
    fn title(&self) -> String;

    /// Returns the number of rows.
    fn rows(&self) -> usize;

    /// Returns true if the rows are conditions.
    fn is_condition(&self) -> bool {
        false
    }

    /// Describes the miss of a row: its name, with its unit where it is known. `value` is that of
    /// the row.
    fn missed(&self, row: usize, value: f64) -> String {
        format!(
            "by {} in row {} of {}",
            rounded(value.abs()),
            row + 1,
            self.rows()
        )
    }

    /// The inputs that the search may choose, beside the parameters; `None` if there are none.
    fn free(&self, cycle: &Cycle) -> Option<Free> {
        let _ = cycle;
        None
    }

    /// The inputs of its positions, for inputs that the search chose.
    fn inputs(&self, free: &[f64], cycle: &Cycle) -> Vec<f64> {
        let _ = cycle;
        free.to_vec()
    }

    /// Returns the mistakes of the objective, for a mechanism of which these parameters may vary.
    fn check(&self, cycle: &Cycle, parameters: &[Parameter], varied: &[usize]) -> Vec<DesignError>;

    /// Returns an evaluator with its own memory, one for each thread.
    fn evaluator(&self) -> Box<dyn Evaluate<M, A> + '_>;
}

/// Evaluates an objective for many mechanisms side by side.
pub trait Evaluate<M, A> {
    /// Fills the rows of all candidates. Rows of a mechanism that cannot be assembled are NaN.
    fn evaluate(&mut self, candidates: &Candidates<'_, M, A>, rows: &mut Rows);
}

/// Mechanisms that are evaluated together.
#[derive(Clone, Copy, Debug)]
pub struct Candidates<'a, M, A> {
    /// An assembly in whose modes they are.
    pub assembly: &'a A,
    /// Their dimensions.
    pub mechanisms: &'a [M],
    /// The free inputs of the objective, those of the first mechanism first.
    pub free: &'a [f64],
}

/// Inputs that an objective leaves free.
#[derive(Clone, Debug, PartialEq)]
pub struct Free {
    /// The number of inputs.
    pub count: usize,
    /// The bounds of each.
    pub bounds: (f64, f64),
    /// True if each is at least the one before it, and all are within a turn of the first one if
    /// the input turns.
    pub ordered: bool,
    /// The length of a turn, if the input turns.
    pub turn: Option<f64>,
    /// The bounds of the first one in starts.
    pub from: (f64, f64),
}

/// Rows of residuals or conditions with their derivatives.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rows {
    rows: usize,
    parameters: usize,
    width: usize,
    numbers: Vec<f64>,
}

impl Rows {
    /// Room for a number of rows with derivatives by so many parameters and free inputs.
    #[must_use]
    pub fn new(rows: usize, parameters: usize, free: usize) -> Self {
        Self {
            rows,
            parameters,
            width: 1 + parameters + free,
            numbers: Vec::new(),
        }
    }

    /// Makes room for so many candidates; all derivatives are 0 then.
    pub fn reset(&mut self, candidates: usize) {
        self.numbers.clear();
        self.numbers
            .resize(candidates * self.rows * self.width, 0.0);
    }

    /// A row of a candidate: the residual, its derivatives by all parameters in their order, those
    /// by the free inputs.
    ///
    /// # Panics
    ///
    /// Panics if there is no such candidate.
    #[inline]
    pub fn row_mut(&mut self, candidate: usize, row: usize) -> (&mut f64, &mut [f64], &mut [f64]) {
        self.nth_mut(candidate * self.rows + row)
    }

    /// The `n`th of all rows, those of the first candidate first.
    #[inline]
    pub(crate) fn nth_mut(&mut self, n: usize) -> (&mut f64, &mut [f64], &mut [f64]) {
        let start = n * self.width;
        let (value, slopes) = self.numbers[start..start + self.width].split_at_mut(1);
        let (parameters, free) = slopes.split_at_mut(self.parameters);
        (&mut value[0], parameters, free)
    }

    /// Returns a row as [`row_mut`](Self::row_mut), to be read.
    ///
    /// # Panics
    ///
    /// Panics if there is no such candidate.
    #[must_use]
    #[inline]
    pub fn row(&self, candidate: usize, row: usize) -> (f64, &[f64], &[f64]) {
        let start = (candidate * self.rows + row) * self.width;
        let numbers = &self.numbers[start..start + self.width];
        let (parameters, free) = numbers[1..].split_at(self.parameters);
        (numbers[0], parameters, free)
    }

    /// Returns the number of rows of each candidate.
    #[must_use]
    pub fn count(&self) -> usize {
        self.rows
    }
}

impl Free {
    /// A start from numbers between 0 and 1, of which there is one for each input.
    pub(crate) fn start(&self, unit: &[f64]) -> Vec<f64> {
        let (low, high) = self.from;
        if !self.ordered {
            return unit.iter().map(|u| low + (high - low) * u).collect();
        }
        match self.turn {
            // Somewhere, and the others within the turn after it.
            Some(turn) => {
                let first = low + (high - low) * unit[0];
                let mut others: Vec<f64> = unit[1..].iter().map(|u| first + turn * u).collect();
                others.sort_by(f64::total_cmp);
                let mut all = vec![first];
                all.append(&mut others);
                all
            }
            None => {
                let mut all: Vec<f64> = unit.iter().map(|u| low + (high - low) * u).collect();
                all.sort_by(f64::total_cmp);
                all
            }
        }
    }
}
