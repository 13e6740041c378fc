//! Tables as CSV.

mod style;

use std::borrow::Cow;
use std::string::{String, ToString};
use std::vec::Vec;

use super::tables::Saved;
use super::units::titled;
use super::{Mistake, Report, ReportError};
pub use style::CsvStyle;

impl Report {
    /// How [`csv`](Self::csv) and the files of [`write`](Self::write) are written: angles in degrees, digits, separator, decimal mark.
    #[must_use]
    pub fn csv_style(mut self, style: CsvStyle) -> Self {
        self.csv_style = style;
        self
    }

    pub(super) fn check_csv(&self, mistakes: &mut Vec<Mistake>) {
        mistakes.extend(self.csv_style.mistake());
    }

    /// The table of a function: the input, its columns, then the true velocities and accelerations that follow from them.
    ///
    /// The first line has names and units, `phi [rad],p.x [mm],v.x [mm/rad]`. Numbers have the digits that it takes to
    /// read them back exactly, unless [`csv_style`](Self::csv_style) says something else; a number that is not finite is an empty cell.
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
        let style = &self.csv_style;
        let input = (self.input.name, self.input.unit, self.positions.as_slice());
        let given = table.columns();
        let given = given.map(|(column, values)| (column.name, column.unit, values));
        let rates = rates.map(|rate| (rate.column.name, &*rate.unit, rate.values.as_slice()));
        let columns: Vec<_> = [input].into_iter().chain(given).chain(rates).collect();

        let titles: Vec<String> = columns
            .iter()
            .map(|(name, unit, _)| titled(name, style.shown(unit).0))
            .collect();
        let mut text = style.line(titles.iter().map(|title| style.word(title)));
        for row in 0..self.positions.len() {
            let cells = columns.iter().map(|(_, unit, values)| {
                let (_, shown) = style.shown(unit);
                Cow::Owned(style.number(shown(values[row])))
            });
            text.push_str(&style.line(cells));
        }
        text
    }
}
