//! `linkage new`: a mechanism to start from.

use std::fs::OpenOptions;
use std::io::Write;
use std::path::Path;

use super::output::print;
use crate::failure::Failure;

const SLIDER_CRANK: &str = include_str!("../templates/slider.mech");

/// Writes a slider-crank, but never over a file.
pub(super) fn run(file: &Path) -> Result<(), Failure> {
    let made = OpenOptions::new().write(true).create_new(true).open(file);
    let written = made.and_then(|mut made| made.write_all(SLIDER_CRANK.as_bytes()));
    written.map_err(|error| Failure::file("write", file, &error))?;
    let file = file.display();
    print(&format!(
        "a slider-crank is in `{file}`: change it, then `linkage check {file}`\n"
    ))
}
