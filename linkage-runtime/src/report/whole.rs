//! Files that are written whole or not at all.

use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicUsize, Ordering};

use super::ReportError;

/// A file that is complete beside its place. Put there, it takes the place of what was there in one step: who reads meanwhile,
/// or stops the program, finds the old file or the new one. What is not put there is removed.
pub(super) struct Whole {
    path: PathBuf,
    /// Where the path leads if it is a link.
    place: PathBuf,
    beside: PathBuf,
}

impl Whole {
    /// Writes it beside its place, which need not be there yet, in a folder that must.
    pub(super) fn new(path: &Path, content: impl AsRef<[u8]>) -> Result<Self, ReportError> {
        let place = fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
        let whole = Self {
            beside: beside(&place),
            path: path.to_path_buf(),
            place,
        };
        // A rename would say so, but when other files are in their places already.
        if whole.place.is_dir() {
            return Err(failed(path)(io::ErrorKind::IsADirectory.into()));
        }
        fs::write(&whole.beside, content).map_err(failed(path))?;
        Ok(whole)
    }

    /// Puts it in its place.
    pub(super) fn put(self) -> Result<PathBuf, ReportError> {
        fs::rename(&self.beside, &self.place).map_err(failed(&self.path))?;
        Ok(self.path.clone())
    }
}

impl Drop for Whole {
    fn drop(&mut self) {
        // After `put` there is none, and of one that cannot be removed nothing better is known than to leave it.
        let _ = fs::remove_file(&self.beside);
    }
}

/// A hidden name in the same folder: a rename stays within a file system. No two writers share one.
fn beside(place: &Path) -> PathBuf {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let count = COUNT.fetch_add(1, Ordering::Relaxed);
    let mut name = OsString::from(".");
    name.push(place.file_name().unwrap_or_default());
    name.push(std::format!(".{}-{count}.part", process::id()));
    place.with_file_name(name)
}

pub(super) fn failed(path: &Path) -> impl Fn(io::Error) -> ReportError {
    let path = path.to_path_buf();
    move |error| ReportError::File {
        path: path.clone(),
        error,
    }
}
