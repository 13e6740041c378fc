//! The commands and their options.

use std::io::{self, IsTerminal};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand};

mod check;
mod choose;
mod numbers;
mod output;
mod sweep;
mod table;
mod values;

/// Mechanisms from their loop equations: checked, tabulated, shown.
#[derive(Debug, Parser)]
#[command(name = "linkage", version)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Tells all mistakes, then structure, assemblies, ranges and operation counts
    Check {
        /// Files with mechanisms
        #[arg(required = true)]
        files: Vec<PathBuf>,
    },
    /// A function over a range of its input, as CSV or JSON
    Table(table::Options),
}

/// Does what the arguments of the process say: exit status 0, 1 for bad input, 2 for wrong usage.
#[must_use]
pub fn run() -> ExitCode {
    let Arguments { command } = Arguments::parse();
    let result = match &command {
        Command::Check { files } => check::run(files),
        Command::Table(options) => table::run(options),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprint!("{failure}");
            ExitCode::FAILURE
        }
    }
}

/// Whether messages are coloured.
fn is_coloured() -> bool {
    io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|word| word.is_empty())
}
