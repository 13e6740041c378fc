//! Series of numbers in the JSON, each of which stands there once.

use serde_json::{Value, json};
use std::collections::HashMap;
use std::vec::Vec;

use crate::report::Report;
use crate::report::tables::Saved;

/// Which columns of tables stand in the JSON. Whatever has the same numbers refers to one of them.
pub(super) struct Series {
    /// Table and column by the bits of their numbers.
    columns: HashMap<Vec<u64>, [usize; 2]>,
}

impl Series {
    /// The first column with its numbers has them, others refer to it.
    pub(super) fn of(report: &Report) -> Self {
        let mut columns = HashMap::new();
        for (table, saved) in report.tables.iter().enumerate() {
            for (column, values) in saved.values.iter().enumerate() {
                columns.entry(bits(values)).or_insert([table, column]);
            }
        }
        Self { columns }
    }

    /// The numbers of a column of a table.
    pub(super) fn column(&self, table: usize, column: usize, saved: &Saved) -> Value {
        let values = &saved.values[column];
        match self.columns.get(&bits(values)) {
            Some(first) if *first != [table, column] => reference(*first),
            _ => json!(values),
        }
    }

    /// Numbers that stand beside the tables.
    pub(super) fn other(&self, values: &[f64]) -> Value {
        let found = self.columns.get(&bits(values));
        found.map_or_else(|| json!(values), |first| reference(*first))
    }
}

fn reference([table, column]: [usize; 2]) -> Value {
    json!({ "table": table, "column": column })
}

/// What tells numbers apart as JSON does: a zero has its sign, and all that is not finite is `null`.
fn bits(values: &[f64]) -> Vec<u64> {
    let bits = |x: &f64| if x.is_finite() { *x } else { f64::NAN };
    values.iter().map(|x| bits(x).to_bits()).collect()
}
