//! Where results go.

use std::fs;
use std::io::{self, Write};
use std::path::Path;
use std::process;

use crate::failure::Failure;

/// Prints a text on the standard output. Who reads no further, as `head` does, is no mistake.
pub(super) fn print(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(Failure::Told(format!(
            "cannot write to the standard output: {error}"
        ))),
        _ => Ok(()),
    }
}

/// Writes a text to a file, or prints it without one.
pub(super) fn put(text: &str, file: Option<&Path>) -> Result<(), Failure> {
    match file {
        Some(file) => {
            let written = write_whole(file, text);
            written.map_err(|error| Failure::file("write", file, &error))
        }
        None => print(text),
    }
}

/// A file is written beside its place and put there in one step: nobody finds half of it.
fn write_whole(file: &Path, text: &str) -> io::Result<()> {
    let place = fs::canonicalize(file).unwrap_or_else(|_| file.to_path_buf());
    if place.is_dir() {
        return Err(io::ErrorKind::IsADirectory.into());
    }
    // A pipe or a device stays what it is.
    if place.exists() && !place.is_file() {
        return fs::write(&place, text);
    }
    let name = place.file_name().ok_or(io::ErrorKind::InvalidFilename)?;
    let beside = format!(".{}.{}.part", name.to_string_lossy(), process::id());
    let beside = place.with_file_name(beside);
    let written = fs::write(&beside, text).and_then(|()| fs::rename(&beside, &place));
    if written.is_err() {
        // What was not put in its place is worth nothing; that it cannot be removed changes nothing about the mistake.
        let _ = fs::remove_file(&beside);
    }
    written
}
