//! The program.

use std::process::ExitCode;

fn main() -> ExitCode {
    linkage_cli::run()
}
