//! The macro of a user's crate and the program have separate builds of the core.

use std::env;
use std::process::Command;

const CORE: &str = "linkage-core ";

/// The features of the core in a crate that uses the macro: of each place in its tree of packages.
fn features_of_the_core() -> Vec<Vec<String>> {
    let output = Command::new(env!("CARGO"))
        .current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
        .args([
            "tree",
            "--package",
            "linkage-mechanism",
            "--edges",
            "normal",
        ])
        .args([
            "--prefix",
            "none",
            "--no-dedupe",
            "--offline",
            "--format",
            "{p} {f}",
        ])
        .output()
        .expect("cargo runs");
    let messages = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{messages}");
    let tree = String::from_utf8(output.stdout).expect("a text");
    let lines = tree.lines().filter(|line| line.starts_with(CORE));
    lines
        .map(|line| {
            let features = line.rsplit(' ').next().unwrap_or_default();
            features.split(',').map(str::to_owned).collect()
        })
        .collect()
}

/// With one build for both, Cargo gives it the debug information of the program if it builds the program, and none if it
/// checks it. Core, compiler and macro were then built twice.
#[test]
fn only_the_macro_has_the_core_of_the_host() {
    let places = features_of_the_core();
    let of_the_host = |features: &Vec<String>| features.iter().any(|name| name == "host");
    let hosts = places.iter().filter(|features| of_the_host(features));
    assert!(hosts.count() > 0, "no core of the macro: {places:?}");
    let of_the_program = places.iter().find(|features| !of_the_host(features));
    assert!(of_the_program.is_some(), "one core for both: {places:?}");
}
