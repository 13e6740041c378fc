//! Tables as CSV.

use std::borrow::Cow;
use std::string::{String, ToString};
use std::vec::Vec;

use super::builder::Report;
use super::tables::Saved;
use super::{check, rates, tables};
use linkage_formats::units::titled;
use linkage_formats::{Mistake, ReportError};

/// Returns the table of a function as CSV.
pub(super) fn table_csv(report: &Report, function: &str) -> Result<String, ReportError> {
    check::check(report)?;
    let mut tables = report.tables.iter();
    match tables.find(|table| table.heading.function == function) {
        Some(table) => Ok(table_lines(report, table)),
        None => Err(ReportError::from(Mistake::Unknown {
            kind: "table",
            name: function.to_string(),
            known: tables::function_names(&report.tables),
        })),
    }
}

fn table_lines(report: &Report, table: &Saved) -> String {
    let rates = rates::true_rates(report);
    let rates = rates
        .iter()
        .filter(|rate| rate.table == table.heading.function);
    let style = &report.csv_style;
    let input = (
        report.input.name,
        report.input.unit,
        report.positions.as_slice(),
    );
    let given = table.columns();
    let given = given.map(|(column, values)| (column.name, column.unit, values));
    let rates = rates.map(|rate| (rate.column.name, &*rate.unit, rate.values.as_slice()));
    let columns: Vec<_> = [input].into_iter().chain(given).chain(rates).collect();

    let titles: Vec<String> = columns
        .iter()
        .map(|(name, unit, _)| titled(name, style.shown(unit).0))
        .collect();
    let mut text = style.line(titles.iter().map(|title| style.word(title)));
    for row in 0..report.positions.len() {
        let cells = columns.iter().map(|(_, unit, values)| {
            let (_, shown) = style.shown(unit);
            Cow::Owned(style.number(shown(values[row])))
        });
        text.push_str(&style.line(cells));
    }
    text
}
