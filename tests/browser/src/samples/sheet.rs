//! Tables of numbers with headings.

use linkage_runtime::{Column, Heading, Input, Meaning, Table};
use std::f64::consts::TAU;

/// The angle of a crank, without a range.
pub(super) const PHI: Input = Input {
    name: "phi",
    unit: "rad",
    reference: 0.0,
    range: None,
};

/// The angle of a shaft over a turn.
pub(super) const SHAFT: Input = Input {
    name: "shaft",
    unit: "rad",
    reference: 0.0,
    range: Some((0.0, TAU)),
};

/// A table filled position by position.
pub struct Sheet {
    heading: &'static Heading,
    columns: Vec<Vec<f64>>,
}

impl Sheet {
    /// The numbers of `row`, one for each column, at every position.
    #[must_use]
    pub fn new<const N: usize>(
        heading: &'static Heading,
        positions: &[f64],
        row: impl Fn(f64) -> [f64; N],
    ) -> Self {
        let rows: Vec<[f64; N]> = positions.iter().map(|&position| row(position)).collect();
        let columns = (0..N).map(|i| rows.iter().map(|row| row[i]).collect());
        Self {
            heading,
            columns: columns.collect(),
        }
    }
}

impl Table for Sheet {
    fn heading(&self) -> &'static Heading {
        self.heading
    }

    fn rows(&self) -> usize {
        self.columns[0].len()
    }

    fn column(&self, index: usize) -> &[f64] {
        &self.columns[index]
    }
}

pub(super) const fn column(name: &'static str, unit: &'static str, meaning: Meaning) -> Column {
    Column {
        name,
        unit,
        meaning,
    }
}

pub(super) const fn shown(name: &'static str, unit: &'static str) -> Column {
    column(name, unit, Meaning::Picture)
}

/// The numbers of a row: those of all vectors, one after the other, then `last` in the columns that remain.
pub(super) fn flat<const N: usize, const D: usize>(vectors: &[[f64; D]], last: f64) -> [f64; N] {
    let mut row = [last; N];
    for (number, value) in row.iter_mut().zip(vectors.iter().flatten()) {
        *number = *value;
    }
    row
}

/// A derivative by central differences: what is tested is how it is shown.
pub(super) fn slope<const N: usize>(f: impl Fn(f64) -> [f64; N], at: f64, step: f64) -> [f64; N] {
    let (low, high) = (f(at - step), f(at + step));
    std::array::from_fn(|i| (high[i] - low[i]) / (2.0 * step))
}
