//! Tasks of the repository: `cargo xtask playground`.

use std::env;
use std::process::ExitCode;

use xtask::playground;

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let done = match &arguments[..] {
        [task] if task == "playground" => playground().map(|built| built.page),
        _ => Err(
            "tasks: `playground` builds target/playground, a page with compiler and editor"
                .to_owned(),
        ),
    };
    match done {
        Ok(page) => {
            println!("{}", page.display());
            ExitCode::SUCCESS
        }
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}
