//! Tables of a report, and finding columns in them.

use std::string::String;
use std::vec::Vec;

use linkage_core::Meaning;
use linkage_runtime::{Column, Heading, Table};

/// A table as the report keeps it.
#[derive(Clone, Debug)]
pub(super) struct Saved {
    pub(super) heading: &'static Heading,
    pub(super) values: Vec<Vec<f64>>,
    pub(super) rows: usize,
}

impl Saved {
    pub(super) fn new(table: &impl Table) -> Self {
        let heading = table.heading();
        let count = heading.columns.len();
        Self {
            heading,
            values: (0..count).map(|i| table.column(i).to_vec()).collect(),
            rows: table.rows(),
        }
    }

    /// Columns with their values.
    pub(super) fn columns(&self) -> impl Iterator<Item = (&'static Column, &[f64])> {
        let columns = self.heading.columns.iter();
        columns.zip(self.values.iter().map(Vec::as_slice))
    }

    /// The name of the column that another one is a derivative of.
    pub(super) fn base_name(&self, column: &Column) -> Option<&'static str> {
        let of = match column.meaning {
            Meaning::Rate { of, .. } | Meaning::Sensitivity { of, .. } => of,
            Meaning::Value | Meaning::Margin | Meaning::Picture => None,
        };
        of.map(|index| self.heading.columns[index].name)
    }
}

/// Names of the tables.
pub(super) fn function_names(tables: &[Saved]) -> Vec<String> {
    let names = tables.iter().map(|table| table.heading.function);
    names.map(String::from).collect()
}
