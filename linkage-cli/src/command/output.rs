//! Output of results.

use std::fs::{self, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::iter::successors;
use std::path::{Path, PathBuf};
use std::process;

use linkage_report::AtomicFile;

use super::replaced::refuse_mechanism;
use crate::failure::Failure;

/// Links that lead to links: a circle of them ends here.
const MOST_LINKS: usize = 40;

/// Prints a text on the standard output.
pub(super) fn print(text: &str) -> Result<(), Failure> {
    printed(|out| out.write_all(text.as_bytes()))
}

/// Prints on the standard output. A reader that stops early, as `head` does, is no mistake.
fn printed(content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Failure> {
    let mut out = BufWriter::new(io::stdout().lock());
    match content(&mut out).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(Failure::Told(format!(
            "cannot write to the standard output: {error}"
        ))),
        _ => Ok(()),
    }
}

/// Writes to a file, or prints without one. Mechanisms are never replaced, neither the one that is
/// read nor another.
///
/// A file is replaced as a whole when its content is complete. Devices, pipes and open files like
/// `/dev/stdout` are written to and not replaced.
pub(super) fn put(
    file: Option<&Path>,
    input: &Path,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), Failure> {
    let Some(file) = file else {
        return printed(content);
    };
    let descriptor = descriptor(file);
    if descriptor == Some(Descriptor::StandardOutput) {
        return printed(content);
    }
    refuse_mechanism(file, input)?;
    let is_special = fs::metadata(file).is_ok_and(|data| !data.is_file() && !data.is_dir());
    let written = match is_special || descriptor.is_some() {
        true => extend(file, content),
        false => replace(file, content),
    };
    written.map_err(|error| Failure::file("write", file, &error))
}

/// Writes to an existing target.
fn extend(file: &Path, content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let mut out = BufWriter::new(OpenOptions::new().append(true).open(file)?);
    content(&mut out)?;
    out.flush()
}

/// Replaces a file.
fn replace(file: &Path, content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let mut out = BufWriter::new(AtomicFile::new(file)?);
    content(&mut out)?;
    out.into_inner()
        .map_err(io::IntoInnerError::into_error)?
        .put()
}

/// A file that a process has open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Descriptor {
    /// The open files of this process.
    StandardOutput,
    Other,
}

/// The open file that a path names, as `/dev/stdout` and `/proc/self/fd/3` do, be it over links.
fn descriptor(path: &Path) -> Option<Descriptor> {
    let next = |path: &PathBuf| {
        let target = fs::read_link(path).ok()?;
        Some(path.parent()?.join(target))
    };
    let process = Path::new("/proc").join(process::id().to_string());
    let way = successors(Some(path.to_path_buf()), next).take(MOST_LINKS);
    let mut found = way.filter_map(|path| {
        let folder = fs::canonicalize(path.parent()?).ok()?;
        let of_processes = folder.starts_with("/proc") && folder.ends_with("fd");
        let is_own = folder == Path::new("/dev/fd") || folder.starts_with(&process);
        let number = path.file_name()?;
        match is_own {
            true if number == "1" => Some(Descriptor::StandardOutput),
            true => Some(Descriptor::Other),
            false => of_processes.then_some(Descriptor::Other),
        }
    });
    found.next()
}
