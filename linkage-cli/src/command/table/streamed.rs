//! A table that is written row by row as it is computed: any number of rows in the same memory.

use std::borrow::Cow;
use std::io::{self, Write};
use std::mem::take;

use linkage_engine::{Assembly, Mechanism};
use linkage_report::CsvStyle;
use serde_json::{Value, json};

use super::super::column::Column;
use super::super::running_input::Along;
use super::super::unbounded::Unbounded;

/// Numbers of a table in JSON that are held, where column follows column: those of 361 positions
/// always.
const HELD: usize = 1 << 18;

/// A function over a course.
pub(super) struct Streamed<'a> {
    mechanism: &'a Mechanism,
    assembly: &'a Assembly<'a>,
    function: usize,
    along: &'a Along,
    /// The input that runs, if one does, and the results.
    columns: Vec<Column<'a>>,
    /// At how many positions a number is not finite, of those that have been written.
    pub(super) missing: usize,
    /// The arguments at the first of them.
    pub(super) first_missing: Option<Vec<f64>>,
    /// The forces of the positions that have been written.
    unbounded: Unbounded,
}

impl<'a> Streamed<'a> {
    pub(super) fn new(
        mechanism: &'a Mechanism,
        assembly: &'a Assembly<'a>,
        function: usize,
        along: &'a Along,
        in_degrees: bool,
    ) -> Self {
        let input = along.running.map(|(_, input)| (input.name, input.unit));
        let results = mechanism.headings()[function].columns.iter();
        let results = results.map(|result| (result.name, result.unit));
        let columns = input.into_iter().chain(results);
        let columns = columns.map(|(name, unit)| Column::new(name, unit, in_degrees));
        Self {
            mechanism,
            assembly,
            function,
            along,
            columns: columns.collect(),
            missing: 0,
            first_missing: None,
            unbounded: Unbounded::new(mechanism, function),
        }
    }

    /// Returns the messages about singular positions among those that have been written.
    pub(super) fn singular_positions(self) -> Vec<String> {
        let Some((index, input)) = self.along.running else {
            return Vec::new();
        };
        let results = |x: f64| {
            let mut arguments = self.along.given.clone();
            arguments[index] = x;
            self.assembly.call(self.function, &arguments)
        };
        self.unbounded
            .messages(self.mechanism, self.function, input, results)
    }

    /// Hands over the numbers of each position, in the order of the columns.
    fn rows(&mut self, mut each: impl FnMut(&[f64]) -> io::Result<()>) -> io::Result<()> {
        let Along {
            given,
            running,
            positions,
        } = self.along;
        let mut arguments = given.clone();
        let mut row = Vec::with_capacity(self.columns.len());
        self.missing = 0;
        self.first_missing = None;
        self.unbounded = Unbounded::new(self.mechanism, self.function);
        for x in positions.iter() {
            row.clear();
            if let Some((index, _)) = running {
                arguments[*index] = x;
                row.push(x);
            }
            let results = self.assembly.call(self.function, &arguments);
            if !results.iter().all(|x| x.is_finite()) {
                self.missing += 1;
                self.first_missing.get_or_insert_with(|| arguments.clone());
            }
            self.unbounded.add(x, &results);
            row.extend(results);
            for (x, column) in row.iter_mut().zip(&self.columns) {
                *x = column.shown(*x);
            }
            each(&row)?;
        }
        Ok(())
    }

    /// A line for each position, names and units in the first one.
    pub(super) fn in_lines(&mut self, out: &mut dyn Write, style: &CsvStyle) -> io::Result<()> {
        let titles: Vec<String> = self.columns.iter().map(Column::title).collect();
        let title = style.line(titles.iter().map(|title| style.word(title)));
        out.write_all(title.as_bytes())?;
        self.rows(|row| {
            let cells = row.iter().map(|x| Cow::Owned(style.number(*x)));
            out.write_all(style.line(cells).as_bytes())
        })
    }

    /// An object with all numbers, column by column.
    pub(super) fn in_json(
        &mut self,
        out: &mut dyn Write,
        function: &str,
        dimensions: &[f64],
    ) -> io::Result<()> {
        out.write_all(b"{\"columns\":[")?;
        self.columns_in_json(out)?;
        let parameters = self.mechanism.parameters().iter().zip(dimensions);
        let parameters: Vec<Value> = parameters
            .map(|(parameter, value)| json!({ "name": parameter.name, "unit": parameter.unit, "value": value }))
            .collect();
        let [parameters, function, name] = [
            json!(parameters),
            json!(function),
            json!(self.mechanism.name()),
        ];
        writeln!(
            out,
            "],\"dimensions\":{parameters},\"function\":{function},\"mechanism\":{name}}}"
        )
    }

    /// All columns. The rows are computed as often as needed: each time the next column is written
    /// meanwhile, and as many after it as can be held.
    fn columns_in_json(&mut self, out: &mut dyn Write) -> io::Result<()> {
        let count = self.columns.len();
        let rows = self.along.positions.count;
        let together = 1 + HELD / rows;
        for first in (0..count).step_by(together) {
            let last = count.min(first + together);
            let mut held = vec![Vec::new(); last - first - 1];
            self.begin_in_json(out, first)?;
            let mut separator = "";
            self.rows(|row| {
                for (column, x) in held.iter_mut().zip(&row[first + 1..last]) {
                    column.push(*x);
                }
                number_in_json(out, take_first(&mut separator), row[first])
            })?;
            out.write_all(b"]}")?;
            for (index, column) in (first + 1..last).zip(held) {
                self.begin_in_json(out, index)?;
                let mut separator = "";
                for x in column {
                    number_in_json(out, take_first(&mut separator), x)?;
                }
                out.write_all(b"]}")?;
            }
        }
        Ok(())
    }

    fn begin_in_json(&self, out: &mut dyn Write, index: usize) -> io::Result<()> {
        let Column { name, unit, .. } = self.columns[index];
        let separator = if index == 0 { "" } else { "," };
        let [name, unit] = [name, unit].map(|text| json!(text));
        write!(
            out,
            "{separator}{{\"name\":{name},\"unit\":{unit},\"values\":["
        )
    }
}

/// Nothing before the first number, a comma before all others.
fn take_first(separator: &mut &'static str) -> &'static str {
    let mark = take(separator);
    *separator = ",";
    mark
}

/// A number with all digits; `null` if it is not finite.
fn number_in_json(out: &mut dyn Write, separator: &str, x: f64) -> io::Result<()> {
    write!(out, "{separator}{}", json!(x))
}
