//! The drive of the hook needle in a C program, against the published tables.

use std::fs;
use std::path::Path;
use std::process::Command;

use linkage_c::{Real, sources};

use crate::machine::{self, Compiler, WARNINGS};
use linkage_corpus::given::examples;

const PROGRAM: &str = include_str!("favorit_table.c");

/// Runs the program; what it prints. `slack` is what numbers may be off by beyond the rounding of the tables.
fn published(name: &str, real: Real, slack: &str) -> Option<(bool, String)> {
    let compiler = Compiler::find()?;
    let given = examples().into_iter().find(|own| own.name == "Favorit");
    let own = given.expect("the example is there");
    let folder = machine::folder(&format!("favorit_{name}"));
    machine::write(
        &folder,
        &sources(&own.name, &own.unit, real).expect("it can be exported"),
    );
    fs::write(folder.join("table.c"), PROGRAM).expect("C can be written");
    let defined = [
        format!("-DREAL={}", real.name()),
        format!("-DSLACK={slack}"),
    ];
    let mut arguments = vec![
        "-std=c99",
        "-O2",
        "table.c",
        "favorit.c",
        "-o",
        "table",
        "-lm",
    ];
    arguments.extend(defined.iter().map(String::as_str));
    if real == Real::Double {
        arguments.extend(WARNINGS);
    }
    compiler.run(&folder, &arguments);
    let tables = Path::new(env!("CARGO_MANIFEST_DIR")).join("../mechanisms/favorit/tables.csv");
    let output = Command::new(folder.join("table")).arg(tables).output();
    let output = output.expect("the program runs");
    let text = String::from_utf8(output.stdout).expect("a text");
    Some((output.status.success(), text))
}

#[test]
fn doubles_meet_the_published_tables() {
    assert!(PROGRAM.lines().count() <= 60, "a program of 60 lines");
    if let Some((met, text)) = published("double", Real::Double, "0") {
        assert!(met, "{text}");
        assert_eq!(text, "63 columns, 0 numbers wrong\n");
    }
}

#[test]
fn singles_meet_the_published_tables() {
    if let Some((met, text)) = published("single", Real::Single, "0.002") {
        assert!(met, "{text}");
    }
}

#[test]
fn a_wrong_number_is_seen() {
    if let Some((met, text)) = published("wrong", Real::Double, "-0.0045") {
        assert!(!met, "{text}");
    }
}
