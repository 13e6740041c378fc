//! The commands and their options.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{CommandFactory, Parser, Subcommand};
use linkage_compiler::shortened;
use linkage_report::Mistake;

mod arguments_given;
mod assemblies;
mod c;
mod check;
mod choose;
mod column;
mod csv_options;
mod declaration;
mod fmt;
mod gap_reason;
mod hold;
mod import;
mod js;
mod loops;
mod lsp;
mod memory;
mod new;
mod output;
mod page;
mod range;
mod replaced;
mod robot;
mod rounded;
mod run;
mod running_input;
mod rust;
mod st;
mod sweep;
mod table;
mod target_folder;
mod terminal;
mod tolerance;
mod unbounded;
mod value_names;
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
    /// Writes a commented mechanism to start from
    New(new::Options),
    /// Turns a file of another program into a mechanism, with joints and links
    Import(import::Options),
    /// Tells all mistakes, then structure, assemblies, ranges and operation counts
    Check {
        /// Files with mechanisms
        #[arg(required = true)]
        files: Vec<PathBuf>,
        #[command(flatten)]
        dimensions: values::Dimensions,
    },
    /// A function over a range of its input, as CSV or JSON
    Table(table::Options),
    /// The report of all functions: drawing, plots, tables, data
    Page(page::Options),
    /// What the tolerances do: worst case, statistics, contributions
    Tolerance(tolerance::Options),
    /// The load, the spring rate or the mass for which a result has a wanted value
    Hold(hold::Options),
    /// The motion that loads, weights and springs make, over time: as CSV, or as a page with
    /// `-o motion.html`
    Run(run::Options),
    /// Every way in which the links can be put together at one position
    Assemblies(assemblies::AtInputs),
    /// How far each assembly reaches over the range of the input
    Circuits(assemblies::Options),
    /// The loops that joints and links stand for, as a text of the language
    Loops(loops::Options),
    /// Writes files with all blanks by the rules: one item on a line, comments kept
    Fmt(fmt::Options),
    /// A language server on standard input and output, for editors
    Lsp(lsp::Options),
    /// A header and a source in C99 for controllers
    C(c::Options),
    /// A module of JavaScript for pages, and its types
    Js(js::Options),
    /// The Rust code that the macro makes of the mechanisms, as a module
    Rust(rust::Options),
    /// Structured text for programmable controllers
    St(st::Options),
    /// A robot description for ROS: bodies and joints, the passive ones as `mimic`
    Urdf(robot::UrdfOptions),
    /// A model for MuJoCo: bodies and joints, loops as constraints or as polynomials
    Mjcf(robot::MjcfOptions),
}

/// Runs the command in the arguments of the process: exit status 0, 1 for bad input, 2 for wrong
/// usage.
#[must_use]
pub fn run() -> ExitCode {
    let parsed = Arguments::try_parse();
    let Arguments { command } = parsed.unwrap_or_else(|error| brief(error).exit());
    let result = match &command {
        Command::Check { files, dimensions } => check::run(files, dimensions),
        Command::Table(options) => {
            refuse_ambiguous(options.mistake());
            table::run(options)
        }
        Command::Run(options) => {
            refuse_ambiguous(options.mistake());
            run::run(options)
        }
        Command::New(options) => new::run(options),
        Command::Import(options) => import::run(options),
        Command::Page(options) => page::run(options),
        Command::Tolerance(options) => tolerance::run(options),
        Command::Hold(options) => hold::run(options),
        Command::Assemblies(options) => assemblies::run(options),
        Command::Circuits(options) => assemblies::circuits(options),
        Command::Loops(options) => loops::run(options),
        Command::Fmt(options) => fmt::run(options),
        Command::Lsp(options) => lsp::run(options),
        Command::C(options) => c::run(options),
        Command::Js(options) => js::run(options),
        Command::Rust(options) => rust::run(options),
        Command::St(options) => st::run(options),
        Command::Urdf(options) => robot::write_urdf(options),
        Command::Mjcf(options) => robot::write_mjcf(options),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprint!("{failure}");
            ExitCode::FAILURE
        }
    }
}

/// Exits if cells of a table are ambiguous.
fn refuse_ambiguous(mistake: Option<Mistake>) {
    if let Some(mistake) = mistake {
        let mut command = Arguments::command();
        command.error(ErrorKind::ArgumentConflict, mistake).exit();
    }
}

/// Wrong usage, which repeats the arguments that are wrong.
fn brief(mut error: clap::Error) -> clap::Error {
    let given = [
        ContextKind::InvalidArg,
        ContextKind::InvalidSubcommand,
        ContextKind::InvalidValue,
    ];
    for kind in given {
        if let Some(ContextValue::String(text)) = error.get(kind) {
            let short = shortened(text).into_owned();
            // Suggestions repeat the argument.
            if short != *text {
                error.insert(ContextKind::Suggested, ContextValue::None);
            }
            error.insert(kind, ContextValue::String(short));
        }
    }
    error
}
