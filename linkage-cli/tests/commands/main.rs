//! The program as its user meets it: what it prints, which files it leaves, its exit status.

mod arguments;
mod assemblies;
mod bad_input;
mod c;
mod couplings;
mod drawings;
mod drawn;
mod files;
mod fmt;
mod hold;
mod import;
mod js;
mod kept;
mod loops;
mod machines;
mod memory;
mod names;
mod numbers;
mod pages;
mod quoted;
mod ranges;
mod robot;
mod run;
mod rust;
mod st;
mod start;
mod tables;
mod templates;
mod time;
mod unbounded;
mod watched;
mod wheels;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A folder of its own for each test, empty.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder can be made");
    folder
}

/// A folder with the first template, a slider-crank, in the file `own.mech`.
fn slider(name: &str) -> PathBuf {
    let folder = folder(name);
    printed(&folder, &["new", "own.mech"]);
    folder
}

/// Three positions over half a turn of the slider-crank, in line with its guide.
const IN_LINE: [&str; 8] = [
    "--set",
    "offset=0mm",
    "--from",
    "0deg",
    "--to",
    "180deg",
    "--steps",
    "3",
];

fn linkage(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
    command.current_dir(folder).args(arguments);
    command.output().expect("it runs")
}

/// What it prints, if it ends with success and says nothing else.
fn printed(folder: &Path, arguments: &[&str]) -> String {
    let output = linkage(folder, arguments);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && said.is_empty(), "{said}");
    String::from_utf8(output.stdout).expect("text")
}

/// What it says where it ends with this status and prints nothing.
fn refused(folder: &Path, arguments: &[&str], status: i32) -> String {
    let output = linkage(folder, arguments);
    let said = String::from_utf8(output.stderr).expect("text");
    assert_eq!(output.status.code(), Some(status), "{arguments:?}: {said}");
    assert!(output.stdout.is_empty(), "{arguments:?}");
    said
}

fn favorit() -> &'static str {
    concat!(env!("CARGO_MANIFEST_DIR"), "/../mechanisms/favorit.rs")
}
