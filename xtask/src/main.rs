//! Tasks of the repository: `cargo xtask playground`.

use std::env;
use std::process::ExitCode;

mod playground;

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let done = match &arguments[..] {
        [task] if task == "playground" => playground::build(),
        _ => Err(
            "tasks: `playground` builds target/playground, a page with compiler and editor"
                .to_owned(),
        ),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}
