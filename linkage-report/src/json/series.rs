//! Series of numbers in the JSON, each of which stands there once.

use core::hash::{Hash, Hasher};
use serde_json::{Value, json};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::hash::DefaultHasher;
use std::vec::Vec;

use super::packed::packed;
use crate::builder::Report;

/// Columns of tables whose numbers are in the JSON. Equal series refer to one of them.
pub(super) struct Series<'a> {
    report: &'a Report,
    /// The rows that are there; `None` for all.
    pub(super) rows: Option<&'a [usize]>,
    /// True if numbers are packed, false if every program has to read them.
    is_packed: bool,
    /// Tables and columns by a number that follows from theirs.
    columns: BTreeMap<u64, Vec<[usize; 2]>>,
}

impl<'a> Series<'a> {
    /// The first column with its numbers has them, others refer to it.
    pub(super) fn new(report: &'a Report, rows: Option<&'a [usize]>, is_packed: bool) -> Self {
        let mut series = Self {
            report,
            rows,
            is_packed,
            columns: BTreeMap::new(),
        };
        for (table, saved) in report.tables.iter().enumerate() {
            for (column, values) in saved.values.iter().enumerate() {
                if series.first(values).is_none() {
                    let there = series.columns.entry(hash(values)).or_default();
                    there.push([table, column]);
                }
            }
        }
        series
    }

    /// The numbers of a column of a table.
    pub(super) fn column(&self, table: usize, column: usize) -> Value {
        let values = &self.report.tables[table].values[column];
        match self.first(values) {
            Some(first) if first != [table, column] => reference(first),
            _ => self.picked(values),
        }
    }

    /// Numbers that stand beside the tables.
    pub(super) fn other(&self, values: &[f64]) -> Value {
        let found = self.first(values);
        found.map_or_else(|| self.picked(values), reference)
    }

    /// The numbers themselves.
    pub(super) fn picked(&self, values: &[f64]) -> Value {
        let values = match self.rows {
            None => Cow::Borrowed(values),
            Some(rows) => rows.iter().map(|row| values[*row]).collect(),
        };
        match self.is_packed {
            true => packed(&values),
            false => json!(values),
        }
    }

    fn first(&self, values: &[f64]) -> Option<[usize; 2]> {
        let same = |&&[table, column]: &&[usize; 2]| {
            let there = &self.report.tables[table].values[column];
            bits(there).eq(bits(values))
        };
        self.columns.get(&hash(values))?.iter().find(same).copied()
    }
}

fn reference([table, column]: [usize; 2]) -> Value {
    json!({ "table": table, "column": column })
}

fn hash(values: &[f64]) -> u64 {
    let mut hasher = DefaultHasher::new();
    bits(values).for_each(|bits| bits.hash(&mut hasher));
    hasher.finish()
}

/// The bits that differ in JSON: a zero has its sign, and every number that is not finite is
/// `null`.
fn bits(values: &[f64]) -> impl Iterator<Item = u64> {
    let known = |x: &f64| if x.is_finite() { *x } else { f64::NAN };
    values.iter().map(move |x| known(x).to_bits())
}
