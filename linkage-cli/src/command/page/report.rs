//! The report of a mechanism, with options of the command.

use std::path::Path;

use linkage_engine::Mechanism;
use linkage_js::description;
use linkage_page::{PageContents, PageReport, columns, report as page_report};
use linkage_report::Report;
use linkage_runtime::Programs;

use crate::command::arguments_given::among;
use crate::command::declaration::declaration;
use crate::command::range;
use crate::command::sweep::{arguments, positions};
use crate::command::values::Dimensions;
use crate::failure::Failure;

/// Bytes for each number, about: the number, and its texts in the page and in all files.
const BYTES: usize = 100;

/// Options of a report.
pub(super) struct ReportOptions<'a> {
    /// The file with the mechanisms.
    pub(super) file: &'a Path,
    /// Dimensions other than those of the file, of all its mechanisms.
    pub(super) dimensions: &'a Dimensions,
    /// Arguments, as `omega=20rad/s`, of all mechanisms.
    pub(super) at: &'a [String],
    /// The number of positions.
    pub(super) steps: u32,
    /// The version of a page that is written again.
    pub(super) version: Option<u64>,
}

/// All functions over the range of the first input.
pub(super) fn report(
    options: &ReportOptions<'_>,
    mechanism: &Mechanism,
) -> Result<Report, Failure> {
    let input = &mechanism.inputs()[0];
    let dimensions = options.dimensions.known_to(mechanism);
    let assembly = range::assembled(&dimensions, mechanism)?;
    let positions = positions(mechanism, input, [None; 2], options.steps)?;
    let positions = positions.held(columns(mechanism), BYTES)?;
    let functions = 0..mechanism.headings().len();
    let arguments = functions.map(|function| function_arguments(options, mechanism, function));
    let description = description(mechanism.name(), mechanism.compiled());
    let contents = PageContents {
        assembly: &assembly,
        positions: &positions,
        arguments: arguments.collect::<Result<_, _>>()?,
        programs: Programs {
            description: Box::leak(description.into_boxed_str()),
        },
        source: declaration(options.file, mechanism.name()),
        version: options.version,
    };
    let PageReport { report, notes } = page_report(mechanism, contents);
    for note in notes {
        eprintln!("note: {}: {note}", mechanism.name());
    }
    Ok(report)
}

/// The arguments of a function, or which one is missing.
fn function_arguments(
    options: &ReportOptions<'_>,
    mechanism: &Mechanism,
    function: usize,
) -> Result<Result<Vec<f64>, String>, Failure> {
    // The input may be a constant argument in another mechanism of the file.
    let names = mechanism.headings()[function].arguments.iter().copied();
    let constant: Vec<&str> = names
        .filter(|name| *name != mechanism.inputs()[0].name)
        .collect();
    let given = arguments(mechanism, function, &among(&constant, options.at))?;
    Ok(given.complete())
}
