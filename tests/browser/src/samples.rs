//! Mechanisms computed by hand, for pages that a test makes.

mod four_bar;
mod machine;
#[path = "../../../linkage-report/tests/report/fixture/pictures.rs"]
mod pictures;
mod sheet;
mod sliders;
mod slots;
mod spatial;
mod yokes;

pub use four_bar::{FourBar, four_bar};
pub use machine::{lift, machine};
pub use sheet::{Sheet, falling, many, roundoff};
pub use sliders::sliders;
pub use slots::slots;
pub use spatial::{spatial, spatial_machine};
pub use yokes::{yokes, yokes_cyclogram};

use linkage_report::Report;
use std::fs;
use std::path::{Path, PathBuf};

/// Writes the page of a report into `target/browser` of the workspace; the page's file.
///
/// # Panics
/// If the report has mistakes or the file cannot be written.
#[must_use]
pub fn written(report: &Report, name: &str) -> PathBuf {
    let page = report.html().unwrap_or_else(|error| panic!("{error}"));
    page_written(&page, name)
}

/// Writes a page into `target/browser` of the workspace; its file.
///
/// # Panics
/// If the file cannot be written.
#[must_use]
pub fn page_written(page: &str, name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/browser");
    fs::create_dir_all(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let file = folder.join(format!("{name}.html"));
    fs::write(&file, page).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    file
}
