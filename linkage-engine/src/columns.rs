//! The results of a sweep.

use std::ops::Index;
use std::thread;

use linkage_runtime::{Heading, Table};
use linkage_symbolic::blocks::BLOCK;

/// Fewest positions for which a thread is worth its start.
const FEW: usize = 16 * BLOCK;

/// The results of a function at many positions, column by column, with their names and units.
///
/// A column has a number for each position, NaN where the mechanism cannot be assembled. Columns
/// are found by name, as `columns["p.x"]`, or by index; reports and analyses take them as a
/// [`Table`].
#[derive(Clone, Debug, PartialEq)]
pub struct Columns {
    heading: &'static Heading,
    rows: usize,
    columns: Vec<Vec<f64>>,
}

/// Columns before the first sweep.
impl Default for Columns {
    fn default() -> Self {
        const NOTHING: &Heading = &Heading {
            function: "",
            arguments: &[],
            columns: &[],
            picture: None,
        };
        Self {
            heading: NOTHING,
            rows: 0,
            columns: Vec::new(),
        }
    }
}

impl Columns {
    /// Columns of a function, without a row.
    #[cfg(feature = "design")]
    pub(crate) fn empty(heading: &'static Heading) -> Self {
        Self {
            heading,
            rows: 0,
            columns: vec![Vec::new(); heading.columns.len()],
        }
    }

    /// Makes them columns of a function, and fills them in parts by threads: each part from a row
    /// on.
    pub(crate) fn fill(
        &mut self,
        heading: &'static Heading,
        positions: usize,
        threads: usize,
        fill: impl Fn(usize, Vec<&mut [f64]>) + Sync,
    ) {
        (self.heading, self.rows) = (heading, positions);
        self.columns.resize(heading.columns.len(), Vec::new());
        for column in &mut self.columns {
            column.resize(positions, 0.0);
        }
        let share = positions.div_ceil(threads).next_multiple_of(BLOCK).max(FEW);
        let last = positions.saturating_sub(1) / share * share;
        let mut rest: Vec<&mut [f64]> = self.columns.iter_mut().map(Vec::as_mut_slice).collect();
        let fill = &fill;
        thread::scope(|scope| {
            for from in (0..last).step_by(share) {
                let (part, others) = split(std::mem::take(&mut rest), share);
                rest = others;
                scope.spawn(move || fill(from, part));
            }
            fill(last, rest);
        });
    }

    /// Returns the numbers of a column; `None` if no column has that name.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&[f64]> {
        let mut columns = self.heading.columns.iter();
        let index = columns.position(|column| column.name == name)?;
        Some(&self.columns[index])
    }
}

impl Table for Columns {
    fn heading(&self) -> &'static Heading {
        self.heading
    }

    fn rows(&self) -> usize {
        self.rows
    }

    fn column(&self, index: usize) -> &[f64] {
        &self.columns[index]
    }
}

impl Index<&str> for Columns {
    type Output = [f64];

    /// Returns the numbers of a column.
    ///
    /// # Panics
    ///
    /// If no column has that name; the message lists those that there are.
    fn index(&self, name: &str) -> &[f64] {
        self.get(name).unwrap_or_else(|| {
            let names: Vec<&str> = self
                .heading
                .columns
                .iter()
                .map(|column| column.name)
                .collect();
            panic!(
                "`{}` has no column `{name}`; it has `{}`",
                self.heading.function,
                names.join("`, `")
            )
        })
    }
}

/// The number of rows of columns.
pub(crate) fn rows(columns: &[&mut [f64]]) -> usize {
    columns.first().map_or(0, |column| column.len())
}

/// The first rows of columns, and the others.
pub(crate) fn split(columns: Vec<&mut [f64]>, rows: usize) -> (Vec<&mut [f64]>, Vec<&mut [f64]>) {
    let halves = columns.into_iter().map(|column| column.split_at_mut(rows));
    halves.unzip()
}
