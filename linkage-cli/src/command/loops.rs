//! `linkage loops`: the loops that joints and links stand for.

use std::path::PathBuf;

use clap::Args;
use linkage_compiler::loops;
use linkage_engine::Source;

use super::choose::checked;
use super::output::print;
use crate::failure::Failure;

/// Options of the command.
#[derive(Debug, Args)]
pub(super) struct Options {
    /// File with the text between the braces of `mechanism! { ... }`, or a Rust file
    file: PathBuf,
}

/// Prints the mechanisms. Loops that cannot be solved are printed, too: their messages count them.
pub(super) fn run(options: &Options) -> Result<(), Failure> {
    let source = Source::read(&options.file)?;
    let result = checked(&source);
    let calls = source.calls().iter();
    let text: Option<String> = calls.map(|call| loops(call.tokens.clone())).collect();
    print(&text.unwrap_or_default())?;
    result.map(|_| ())
}
