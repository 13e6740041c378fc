//! The folder into which mechanisms are printed in another language.

use std::fs;
use std::path::{Path, PathBuf};

use clap::Args;

use super::output::{print, put};
use super::replaced::refuse_mechanism;
use crate::failure::Failure;

/// Options of commands that write several files.
#[derive(Debug, Args)]
pub(super) struct TargetFolder {
    /// The folder; by default the current one
    #[arg(short, long, value_name = "DIR", default_value = ".")]
    output: PathBuf,
}

impl TargetFolder {
    /// Makes the folder, unless the file of the mechanisms would be replaced.
    pub(super) fn make(&self, mechanisms: &Path) -> Result<(), Failure> {
        refuse_mechanism(&self.output, mechanisms)?;
        let made = fs::create_dir_all(&self.output);
        made.map_err(|error| Failure::file("make", &self.output, &error))
    }

    /// Writes a file into the folder, and prints its path.
    pub(super) fn write(&self, mechanisms: &Path, file: &str, text: &str) -> Result<(), Failure> {
        let path = self.output.join(file);
        put(Some(&path), mechanisms, |out| {
            out.write_all(text.as_bytes())
        })?;
        print(&format!("{}\n", path.display()))
    }
}
