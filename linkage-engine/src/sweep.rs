//! Functions at many positions, and of many mechanisms.

pub(crate) mod parts;
mod positions;
mod run;
mod slices;

use std::num::NonZero;
use std::sync::OnceLock;
use std::thread;

use crate::columns::{Columns, rows};
use crate::compiled::Assembly;
use parts::Sweep;
use positions::positions;
use slices::number;

impl Assembly<'_> {
    /// Computes a function, by its number, at many positions. Each argument of the function is a
    /// slice with a value for each position, or with one value for all of them.
    ///
    /// Numbers are those of the macro's sweeps, to the last bit, except for the sines of sweeps of
    /// a few positions.
    ///
    /// # Panics
    ///
    /// If there is no such function, it takes another number of arguments, or slices differ in
    /// length.
    #[must_use]
    pub fn sweep(&self, function: usize, arguments: &[&[f64]]) -> Columns {
        let mut columns = Columns::default();
        self.sweep_into(function, arguments, &mut columns);
        columns
    }

    /// Computes the same into columns that are there: allocates for results only if they are too
    /// small.
    ///
    /// # Panics
    ///
    /// As [`sweep`](Self::sweep).
    pub fn sweep_into(&self, function: usize, arguments: &[&[f64]], columns: &mut Columns) {
        self.fill(function, arguments, 1, columns);
    }

    /// Computes the same on all cores.
    ///
    /// # Panics
    ///
    /// As [`sweep`](Self::sweep).
    pub fn sweep_parallel_into(
        &self,
        function: usize,
        arguments: &[&[f64]],
        columns: &mut Columns,
    ) {
        self.fill(function, arguments, cores(), columns);
    }

    /// Computes the same by a [`call`](Self::call) for each position: the columns have the bits of
    /// single calls.
    ///
    /// # Panics
    ///
    /// As [`sweep`](Self::sweep).
    #[must_use]
    pub fn calls(&self, function: usize, arguments: &[&[f64]]) -> Columns {
        let heading = self.mechanism().headings()[function];
        let positions = positions(heading.function, heading.arguments, arguments);
        let mut columns = Columns::default();
        columns.fill(heading, positions, 1, |from, mut columns| {
            for row in 0..rows(&columns) {
                let slices = arguments.iter();
                let given: Vec<f64> = slices.map(|slice| number(slice, from + row)).collect();
                let numbers = self.call(function, &given);
                for (column, number) in columns.iter_mut().zip(numbers) {
                    column[row] = number;
                }
            }
        });
        columns
    }

    /// Computes a function for many mechanisms, each at inputs of its own. Each scalar parameter is
    /// a slice with a value for each mechanism, or with one value for all of them; so is each
    /// argument of the function.
    ///
    /// All are assembled in the modes of this assembly, and their angles count turns from those of
    /// this one. Coupled groups are followed straight from the dimensions of this one, at the
    /// position. Where one cannot be assembled at its position, the results are NaN.
    ///
    /// # Panics
    ///
    /// As [`sweep`](Self::sweep); if there is another number of parameters.
    #[must_use]
    pub fn sweep_sets(
        &self,
        function: usize,
        parameters: &[&[f64]],
        arguments: &[&[f64]],
    ) -> Columns {
        let mut columns = Columns::default();
        self.sweep_sets_into(function, parameters, arguments, &mut columns);
        columns
    }

    /// Computes the same into columns that are there.
    ///
    /// # Panics
    ///
    /// As [`sweep_sets`](Self::sweep_sets).
    pub fn sweep_sets_into(
        &self,
        function: usize,
        parameters: &[&[f64]],
        arguments: &[&[f64]],
        columns: &mut Columns,
    ) {
        self.fill_sets(function, parameters, arguments, 1, columns);
    }

    /// Computes the same on all cores.
    ///
    /// # Panics
    ///
    /// As [`sweep_sets`](Self::sweep_sets).
    pub fn sweep_sets_parallel_into(
        &self,
        function: usize,
        parameters: &[&[f64]],
        arguments: &[&[f64]],
        columns: &mut Columns,
    ) {
        self.fill_sets(function, parameters, arguments, cores(), columns);
    }

    fn fill(&self, number: usize, arguments: &[&[f64]], threads: usize, columns: &mut Columns) {
        fill_columns(&self.sweep_in_parts(number, arguments), threads, columns);
    }

    fn fill_sets(
        &self,
        number: usize,
        parameters: &[&[f64]],
        arguments: &[&[f64]],
        threads: usize,
        columns: &mut Columns,
    ) {
        let sweep = self.sweep_sets_in_parts(number, parameters, arguments);
        fill_columns(&sweep, threads, columns);
    }
}

/// Computes a whole sweep into columns.
fn fill_columns(sweep: &Sweep<'_>, threads: usize, columns: &mut Columns) {
    columns.fill(
        sweep.heading(),
        sweep.positions(),
        threads,
        |from, columns| sweep.fill(from, columns),
    );
}

/// The number of threads that run at once; to ask the system for it takes longer than a sweep.
fn cores() -> usize {
    static CORES: OnceLock<usize> = OnceLock::new();
    *CORES.get_or_init(|| thread::available_parallelism().map_or(1, NonZero::get))
}
