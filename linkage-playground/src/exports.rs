//! Files of other formats from a text.

use linkage_c::{Real, all_sources};
use linkage_engine::{Mechanism, Source, compile};
use linkage_js::modules;
use linkage_report::{CsvStyle, Report, ReportError};
use linkage_runtime::Programs;
use serde_json::{Value, json};

use crate::document::FILE;
use crate::page::{report_of, shown, whole_page};

/// Returns files of a format as JSON, each with name and text: `c` and `js` for all mechanisms of
/// the text, `svg`, `dxf`, `csv`, `csv-radians` and `page` for the one of this name. Angles in `csv` are in
/// degrees, as the page shows them.
///
/// # Errors
///
/// The message, if the text has mistakes or the format refuses the mechanism.
pub(crate) fn export(text: &str, format: &str, mechanism: &str) -> Result<String, String> {
    let mechanisms = compile(FILE, text).map_err(|error| error.to_string())?;
    let files = match format {
        "c" => c_files(&mechanisms)?,
        "js" => js_files(&mechanisms)?,
        _ => report_files(text, format, mechanism, mechanisms)?,
    };
    let files = files.into_iter();
    let files = files.map(|(name, text)| json!({ "name": name, "text": text }));
    Ok(Value::from(files.collect::<Vec<_>>()).to_string())
}

type Files = Vec<(String, String)>;

fn c_files(mechanisms: &[Mechanism]) -> Result<Files, String> {
    let named: Vec<_> = mechanisms.iter().map(named).collect();
    let sources = all_sources(&named, Real::Double).map_err(|refused| refused.to_string())?;
    let files = sources.into_iter().flat_map(|sources| {
        let name = sources.name;
        [
            (format!("{name}.h"), sources.header),
            (format!("{name}.c"), sources.source),
        ]
    });
    Ok(files.collect())
}

fn js_files(mechanisms: &[Mechanism]) -> Result<Files, String> {
    let named: Vec<_> = mechanisms.iter().map(named).collect();
    let modules = modules(&named).map_err(|clash| clash.to_string())?;
    let files = modules.into_iter().flat_map(|module| {
        let name = module.name;
        [
            (format!("{name}.js"), module.script),
            (format!("{name}.d.ts"), module.types),
        ]
    });
    Ok(files.collect())
}

fn named(mechanism: &Mechanism) -> (&str, &linkage_compiler::ir::CompiledMechanism) {
    (mechanism.name(), mechanism.compiled())
}

/// Files of the report of a mechanism.
fn report_files(
    text: &str,
    format: &str,
    name: &str,
    mechanisms: Vec<Mechanism>,
) -> Result<Files, String> {
    let mut found = mechanisms.into_iter();
    let found = found.find(|mechanism| mechanism.name() == name);
    let found = found.ok_or_else(|| format!("there is no mechanism `{name}`"))?;
    let source = Source::new(FILE, text).map_err(|error| error.to_string())?;
    let mechanism = shown(&source, found)?;
    let why = |error: ReportError| error.to_string();
    let report = report_of(&source, &mechanism, Programs { description: "" })?;
    match format {
        "svg" => {
            let drawing = report.drawing().map_err(why)?;
            Ok(vec![(format!("{name}.svg"), drawing.svg().map_err(why)?)])
        }
        "dxf" => {
            let drawing = report.drawing().map_err(why)?;
            Ok(vec![(format!("{name}.dxf"), drawing.dxf().map_err(why)?)])
        }
        "page" => Ok(vec![(
            format!("{name}.html"),
            whole_page(&source, &mechanism)?,
        )]),
        "csv" => Ok(tables(
            &report.csv_style(CsvStyle::default().degrees(true)),
            &mechanism,
        )),
        "csv-radians" => Ok(tables(&report, &mechanism)),
        other => Err(format!("there is no format `{other}`")),
    }
}

/// A table for each function that takes the first input.
fn tables(report: &Report, mechanism: &Mechanism) -> Files {
    let headings = mechanism.headings().iter();
    let tables = headings.filter_map(|heading| {
        let table = report.csv(heading.function).ok()?;
        Some((format!("{}.csv", heading.function), table))
    });
    tables.collect()
}
