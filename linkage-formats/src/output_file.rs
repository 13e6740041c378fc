//! Files that are replaced in one step.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::vec::Vec;

use crate::atomic_file::AtomicFile;
use crate::error::{ReportError, failed};

/// Writes a picture by the ending of its name.
pub fn picture(path: &Path, svg: &str) -> Result<PathBuf, ReportError> {
    let content = match path.extension().and_then(|ending| ending.to_str()) {
        Some("svg") => Vec::from(svg),
        #[cfg(feature = "png")]
        Some("png") => crate::png::rendered(svg)?,
        _ => {
            return Err(ReportError::Ending {
                path: path.to_path_buf(),
            });
        }
    };
    file(path, content)
}

/// Writes a file.
pub fn file(path: &Path, content: impl AsRef<[u8]>) -> Result<PathBuf, ReportError> {
    let whole = complete(path, content)?;
    whole.put().map_err(failed(path))?;
    Ok(path.to_path_buf())
}

/// A file with its content, not yet in its place.
pub fn complete(path: &Path, content: impl AsRef<[u8]>) -> Result<AtomicFile, ReportError> {
    let mut whole = AtomicFile::new(path).map_err(failed(path))?;
    let written = whole.write_all(content.as_ref());
    written.map_err(failed(path))?;
    Ok(whole)
}
