//! Mistakes of a watched file on its open pages.

use std::path::{Path, PathBuf};

use linkage_engine::Source;
use linkage_report::{Index, ReportError, show_mistakes};

use crate::command::choose::mistakes;
use crate::failure::Failure;

/// Shows on all pages of a file the reason why they could not be written again.
pub(super) fn show(folders: &[PathBuf], file: &Path, failure: &Failure) -> Result<(), ReportError> {
    let text = match failure {
        Failure::Silent => Source::read(file).map_or_else(
            |error| Failure::from(error).to_string(),
            |source| mistakes(&source),
        ),
        other => other.to_string(),
    };
    let text = text.trim_end();
    for folder in folders {
        show_mistakes(folder, text)?;
    }
    Ok(())
}

/// Writes a page that waits for the first report, unless the folder has a page.
pub(super) fn write_waiting_page(
    folder: &Path,
    title: &str,
    version: u64,
) -> Result<(), ReportError> {
    if !folder.join("index.html").exists() {
        Index::new(title).version(version).write(folder)?;
    }
    Ok(())
}
