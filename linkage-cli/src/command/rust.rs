//! `linkage rust`: mechanisms as the Rust code that the macro makes of them.

mod module;

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use linkage_engine::Source;

use super::choose::checked;
use super::output::put;
use crate::failure::Failure;

/// Options of the command.
#[derive(Debug, Args)]
pub(super) struct Options {
    /// File with the text between the braces of `mechanism! { ... }`, or a Rust file
    file: PathBuf,
    /// Features of linkage in the crate that has the module; `alloc` is part of `std`
    #[arg(
        long,
        value_name = "LIST",
        value_delimiter = ',',
        default_value = "alloc"
    )]
    features: Vec<Feature>,
    /// A file instead of the standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// A feature that generated items depend on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Feature {
    /// Sweeps, assemblies, circuits
    Alloc,
    /// Tables of columns for reports and designs
    Report,
    /// Single calls alone
    None,
}

impl Feature {
    /// The macro that contains the items of the feature.
    fn word(self) -> Option<&'static str> {
        match self {
            Self::Alloc => Some("if_alloc"),
            Self::Report => Some("if_report"),
            Self::None => None,
        }
    }
}

/// Prints the module; nothing of it if a mechanism of the file has a mistake.
pub(super) fn run(options: &Options) -> Result<(), Failure> {
    let source = Source::read(&options.file)?;
    checked(&source)?;
    let features = options.features.iter();
    let features: Vec<&str> = features.filter_map(|feature| feature.word()).collect();
    let text = module::printed(&source, &features)?;
    put(options.output.as_deref(), &options.file, |out| {
        out.write_all(text.as_bytes())
    })
}
