//! The report as a folder.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::string::String;
use std::vec::Vec;

use super::{Report, ReportError};

impl Report {
    /// Writes everything into a folder, which is made if it is not there: `index.html`, `data.json`, and a CSV file for
    /// each table, named after its function. Returns the files.
    ///
    /// # Errors
    ///
    /// As [`check`](Self::check), and if a file cannot be written.
    pub fn write(&self, folder: impl AsRef<Path>) -> Result<Vec<PathBuf>, ReportError> {
        self.check()?;
        let folder = folder.as_ref();
        let mut files: Vec<(PathBuf, String)> = Vec::new();
        let mut add = |name: &str, text: String| files.push((folder.join(name), text));
        add("index.html", self.html()?);
        add("data.json", self.json()?);
        for function in self.functions() {
            add(&std::format!("{function}.csv"), self.csv(&function)?);
        }
        write_all(folder, files)
    }
}

fn write_all(folder: &Path, files: Vec<(PathBuf, String)>) -> Result<Vec<PathBuf>, ReportError> {
    let at = |path: &Path| {
        let path = path.to_path_buf();
        move |error: io::Error| ReportError::File { path, error }
    };
    fs::create_dir_all(folder).map_err(at(folder))?;
    for (path, text) in &files {
        fs::write(path, text).map_err(at(path))?;
    }
    Ok(files.into_iter().map(|(path, _)| path).collect())
}
