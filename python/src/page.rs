//! The page of a mechanism.

use linkage_engine::Mechanism;
use linkage_js::description;
use linkage_page::{Missing, PageContents, PageReport, report, with_functions};
use linkage_runtime::Programs;

use crate::text::File;

/// Returns the page with drawing, plots and tables as HTML.
///
/// # Errors
///
/// If the mechanism has no input, or cannot be assembled.
pub(crate) fn page(
    file: &File,
    mechanism: &Mechanism,
    dimensions: &[f64],
    positions: usize,
) -> Result<String, String> {
    let Some(input) = mechanism.inputs().first() else {
        return Err(format!(
            "{} has no input: nothing of it moves",
            mechanism.name()
        ));
    };
    let source = file.source().map_err(|error| error.to_string())?;
    let missing = Missing::in_mechanism(mechanism);
    let added = match missing {
        Missing::Nothing => None,
        Missing::Drawing | Missing::All => with_functions(&source, mechanism, missing),
    };
    let mechanism = added.as_ref().unwrap_or(mechanism);
    let assembly = mechanism.assemble(dimensions);
    let assembly = assembly.map_err(|error| error.to_string())?;
    let positions = input.positions(positions);
    let functions = 0..mechanism.headings().len();
    let description = description(mechanism.name(), mechanism.compiled());
    let contents = PageContents {
        assembly: &assembly,
        positions: &positions,
        arguments: functions.map(|one| Ok(arguments(mechanism, one))).collect(),
        programs: Programs {
            description: Box::leak(description.into_boxed_str()),
        },
        source: Some(source.text().to_owned()),
        version: None,
    };
    let PageReport { report, .. } = report(mechanism, contents);
    report.html().map_err(|error| error.to_string())
}

/// The arguments of a function: inputs at their references and loads as declared. A speed or an
/// acceleration is 1: the page has a slider for it.
fn arguments(mechanism: &Mechanism, function: usize) -> Vec<f64> {
    let indices = mechanism.compiled().functions[function].arguments.iter();
    let default = |&index: &usize| mechanism.default_argument(index).unwrap_or(1.0);
    indices.map(default).collect()
}
