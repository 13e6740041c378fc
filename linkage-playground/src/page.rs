//! The data of the page of a mechanism.

use linkage_engine::{Assembly, Mechanism, Source};
use linkage_js::{description, description_data};
use linkage_page::{Missing, PageContents, PageReport, report, with_functions};
use linkage_report::Report;
use linkage_runtime::{Input, Programs};

/// Positions of the first input, as many as the command shows.
pub(crate) const STEPS: usize = 361;

/// A mechanism with the functions that its page needs.
///
/// # Errors
///
/// If it has no input.
pub(crate) fn shown(source: &Source, mechanism: Mechanism) -> Result<Mechanism, String> {
    if mechanism.inputs().is_empty() {
        let name = mechanism.name();
        return Err(format!("{name} has no input: nothing of it moves"));
    }
    let missing = Missing::in_mechanism(&mechanism);
    if missing == Missing::Nothing {
        return Ok(mechanism);
    }
    Ok(with_functions(source, &mechanism, missing).unwrap_or(mechanism))
}

/// The page of a mechanism: lines of JSON.
pub(crate) struct Page {
    /// The name of the mechanism.
    pub(crate) name: &'static str,
    /// The data of the report.
    pub(crate) report: String,
    /// The programs for the interpreter of the page.
    pub(crate) programs: String,
}

/// Returns the page of a mechanism.
pub(crate) fn page(source: &Source, mechanism: Mechanism) -> Result<Page, String> {
    let mechanism = shown(source, mechanism)?;
    // The page has the programs as data, next to the report.
    let report = report_of(source, &mechanism, Programs { description: "" })?;
    Ok(Page {
        name: mechanism.name(),
        report: report.page_data().map_err(|error| error.to_string())?,
        programs: description_data(mechanism.name(), mechanism.compiled()),
    })
}

/// Returns the page of a mechanism as a file of its own.
pub(crate) fn whole_page(source: &Source, mechanism: &Mechanism) -> Result<String, String> {
    let description = description(mechanism.name(), mechanism.compiled());
    let programs = Programs {
        description: Box::leak(description.into_boxed_str()),
    };
    let report = report_of(source, mechanism, programs)?;
    report.html().map_err(|error| error.to_string())
}

/// The report of all functions over the range of the first input.
pub(crate) fn report_of(
    source: &Source,
    mechanism: &Mechanism,
    programs: Programs,
) -> Result<Report, String> {
    let dimensions = mechanism.dimensions();
    let assembly = mechanism.assemble(&dimensions);
    let assembly: Assembly<'_> = assembly.map_err(|error| error.to_string())?;
    let positions = positions(&mechanism.inputs()[0], STEPS);
    let functions = 0..mechanism.headings().len();
    let contents = PageContents {
        assembly: &assembly,
        positions: &positions,
        arguments: functions
            .map(|function| Ok(arguments(mechanism, function)))
            .collect(),
        programs,
        source: Some(source.text().to_owned()),
        version: None,
    };
    let PageReport { report, .. } = report(mechanism, contents);
    Ok(report)
}

/// Evenly spaced positions over the range of an input.
pub(crate) fn positions(input: &Input, count: usize) -> Vec<f64> {
    (0..count)
        .map(|index| input.position(index, count))
        .collect()
}

/// The arguments of a function: inputs at their references and loads as declared. A speed that the
/// text does not give is 1, an acceleration as well: the page has a slider for each.
pub(crate) fn arguments(mechanism: &Mechanism, function: usize) -> Vec<f64> {
    let indices = &mechanism.compiled().functions[function].arguments;
    let default = |&index: &usize| mechanism.default_argument(index).unwrap_or(1.0);
    indices.iter().map(default).collect()
}
