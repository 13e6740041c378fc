//! Tables as CSV.

use std::borrow::Cow;
use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use super::tables::Saved;
use super::units::titled;
use super::{Mistake, Report, ReportError};

impl Report {
    /// The table of a function: the input, its columns, then the true velocities and accelerations that follow from them.
    ///
    /// The first line has names and units, `phi [rad],p.x [mm],v.x [mm/rad]`. Numbers have the digits that it takes to
    /// read them back exactly; a number that is not finite is an empty cell.
    ///
    /// # Errors
    ///
    /// As [`check`](Self::check), and if there is no table of this function.
    pub fn csv(&self, function: &str) -> Result<String, ReportError> {
        self.check()?;
        let mut tables = self.tables.iter();
        match tables.find(|table| table.heading.function == function) {
            Some(table) => Ok(self.lines(table)),
            None => Err(ReportError::from(Mistake::Unknown {
                kind: "table",
                name: function.to_string(),
                known: self.functions(),
            })),
        }
    }

    fn lines(&self, table: &Saved) -> String {
        let rates = self.true_rates();
        let rates = rates
            .iter()
            .filter(|rate| rate.table == table.heading.function);
        let input = (
            titled(self.input.name, self.input.unit),
            self.positions.as_slice(),
        );
        let given = table
            .columns()
            .map(|(column, values)| (titled(column.name, column.unit), values));
        let rates =
            rates.map(|rate| (titled(rate.column.name, &rate.unit), rate.values.as_slice()));
        let (titles, columns): (Vec<_>, Vec<_>) =
            [input].into_iter().chain(given).chain(rates).unzip();

        let mut text = line(titles.iter().map(|title| quoted(title)));
        for row in 0..self.positions.len() {
            let cells = columns.iter().map(|values| Cow::Owned(cell(values[row])));
            text.push_str(&line(cells));
        }
        text
    }
}

fn line<'a>(cells: impl Iterator<Item = Cow<'a, str>>) -> String {
    let mut line = cells.collect::<Vec<_>>().join(",");
    line.push_str("\r\n");
    line
}

/// Shortest digits that are read back to the same number.
fn cell(x: f64) -> String {
    if !x.is_finite() {
        return String::new();
    }
    let digits = format!("{x:?}");
    match digits.strip_suffix(".0") {
        Some(whole) => whole.to_string(),
        None => digits,
    }
}

/// A cell in quotes where commas or quotes in it would be misread.
fn quoted(cell: &str) -> Cow<'_, str> {
    if cell.contains([',', '"', '\r', '\n']) {
        Cow::Owned(format!("\"{}\"", cell.replace('"', "\"\"")))
    } else {
        Cow::Borrowed(cell)
    }
}
