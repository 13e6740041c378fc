//! The report as a folder.

use std::format;
use std::fs;
use std::path::{Path, PathBuf};
use std::vec::Vec;

use super::AtomicFile;
use super::builder::Report;
use super::drawing::Drawing;
use super::version::version_file;
use super::{csv, json, machine, page, plots, positioned_picture, tables};
use linkage_analysis::internals::bars;
use linkage_formats::error::{ReportError, failed};
use linkage_formats::output_file;

/// Further positions in the drawing.
const GHOSTS: usize = 8;

/// Systems limit the number of files that a program has open, some to 256.
const MOST_OPEN: usize = 100;

/// Writes all files of the report into a folder.
pub(super) fn write_report(
    report: &Report,
    folder: impl AsRef<Path>,
) -> Result<Vec<PathBuf>, ReportError> {
    let folder = folder.as_ref();
    let mut files = Vec::from([
        (folder.join("index.html"), page::page_html(report)?),
        (folder.join("data.json"), json::report_json(report)?),
    ]);
    for function in tables::function_names(&report.tables) {
        files.push((
            folder.join(format!("{function}.csv")),
            csv::table_csv(report, &function)?,
        ));
    }
    if positioned_picture::is_drawable(report) {
        let drawing = Drawing::new(report)?.ghosts(GHOSTS);
        files.push((folder.join("drawing.svg"), drawing.svg()?));
        files.push((folder.join("drawing.dxf"), drawing.dxf()?));
    }
    if let Some(cyclogram) = &report.cyclogram {
        let hues = machine::organ_hues(report, cyclogram);
        files.push((folder.join("cyclogram.svg"), bars::drawn(cyclogram, &hues)));
        let style = &report.csv_style;
        for (name, csv) in [
            ("cyclogram.csv", cyclogram.csv(style)?),
            ("cyclogram-order.csv", cyclogram.order_csv(style)?),
            ("cyclogram-overlaps.csv", cyclogram.overlaps_csv(style)?),
        ] {
            files.push((folder.join(name), csv));
        }
    }
    for (name, plot) in plots::all_plots(report)? {
        files.push((folder.join(format!("plots/{name}.svg")), plot.svg()?));
    }
    // Put in its place last: who reloads the page then finds the new one.
    if let Some(version) = report.version {
        files.push(version_file(folder, version));
    }
    let mut written = Vec::new();
    for (path, text) in &files {
        let folder = path.parent().unwrap_or(folder);
        fs::create_dir_all(folder).map_err(failed(folder))?;
        let mut whole = output_file::complete(path, text)?;
        if written.len() >= MOST_OPEN {
            whole.close();
        }
        written.push((path, whole));
    }
    let put = |(path, whole): (&PathBuf, AtomicFile)| {
        whole.put().map_err(failed(path))?;
        Ok(path.clone())
    };
    written.into_iter().map(put).collect()
}
