//! `linkage fmt`: texts with all blanks by the rules.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use linkage_editor::formatted;
use linkage_engine::Source;
use linkage_report::AtomicFile;

use super::output::print;
use crate::failure::Failure;

/// Options of the command.
#[derive(Debug, Args)]
pub(super) struct Options {
    /// Files with mechanisms, not with Rust code
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Only lists the files that would change; the exit status is 1 if there are any
    #[arg(long)]
    check: bool,
}

/// Formats files, or lists those that would change.
pub(super) fn run(options: &Options) -> Result<(), Failure> {
    let mut changed = false;
    for file in &options.files {
        let Some(new) = change(file)? else { continue };
        changed = true;
        if options.check {
            print(&format!("{}\n", file.display()))?;
        } else {
            written(file, &new).map_err(|error| Failure::file("write", file, &error))?;
        }
    }
    match changed && options.check {
        true => Err(Failure::Silent),
        false => Ok(()),
    }
}

/// Replaces a file in one step.
fn written(file: &Path, text: &str) -> io::Result<()> {
    // A link stays one, and leads to the new text.
    let mut out = AtomicFile::new(&fs::canonicalize(file)?)?;
    out.write_all(text.as_bytes())?;
    out.put()
}

/// Returns the new text of a file, if it changes.
fn change(file: &Path) -> Result<Option<String>, Failure> {
    if file.extension().is_some_and(|ending| ending == "rs") {
        return Err(Failure::Told(format!(
            "`{}` is a Rust file\nhelp: format it with `rustfmt`, which leaves mechanisms as they are",
            file.display()
        )));
    }
    let text = fs::read_to_string(file).map_err(|error| Failure::file("read", file, &error))?;
    // A bracket without partner is reported as by all other commands.
    Source::new(&file.display().to_string(), &text)?;
    Ok(formatted(&text).filter(|new| *new != text))
}
