//! The motion as CSV.

use std::borrow::Cow;
use std::io::{self, Write};

use linkage_dynamics::State;

use super::super::column::Column;
use super::super::output;
use super::motion_result::MotionResult;
use super::run_options::Options;
use crate::failure::Failure;

/// Rows of a table without `--steps`.
const ROWS: u32 = 201;

/// Writes the motion to the file of the command line, or prints it.
pub(super) fn put<const N: usize>(
    options: &Options,
    result: &MotionResult<'_, N>,
) -> Result<(), Failure> {
    let file = options.csv.output.as_deref();
    output::put(file, options.chosen.file(), |out| {
        written(options, result, out)
    })
}

/// A line for each time: inputs, speeds and all results of the function.
fn written<const N: usize>(
    options: &Options,
    result: &MotionResult<'_, N>,
    out: &mut dyn Write,
) -> io::Result<()> {
    let MotionResult {
        driven,
        assembly,
        motion,
    } = result;
    let style = options.csv.style();
    let heading = driven.mechanism().headings()[driven.function()];
    let results = heading
        .columns
        .iter()
        .map(|result| (result.name, result.unit));
    let titles = [("time", "s")].into_iter().chain(driven.titles());
    let columns: Vec<Column<'_>> = titles
        .chain(results)
        .map(|(name, unit)| Column::new(name, unit, options.csv.degrees))
        .collect();
    let titles: Vec<String> = columns.iter().map(Column::title).collect();
    let title = style.line(titles.iter().map(|title| style.word(title)));
    out.write_all(title.as_bytes())?;
    for State {
        time,
        inputs,
        speeds,
    } in motion.states(options.steps.unwrap_or(ROWS) as usize)
    {
        let row = [time].into_iter().chain(inputs).chain(speeds);
        let row = row.chain(driven.results(assembly, inputs, speeds));
        let cells = row.zip(&columns).map(|(x, column)| column.shown(x));
        let cells = cells.map(|x| Cow::Owned(style.number(x)));
        out.write_all(style.line(cells).as_bytes())?;
    }
    Ok(())
}
