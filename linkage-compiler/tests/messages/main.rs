//! Messages of the compiler as its user sees them: cases in one file for each phase that reports
//! them, next to this file.
//!
//! A case is a name, the text of a mechanism, and all messages about it. Lines and columns count
//! from the first line of the text, comments included:
//!
//! ```text
//! === NAME
//! // The reason for the case.
//! struct M { ... }
//! ---
//! error: unknown name `crnak`
//!        help: did you mean `crank`?
//!  --> NAME:2:21
//! ```
//!
//! A case without a message is valid text that is close to a mistake. Texts before the first case
//! describe a file. `UPDATE=1 cargo test -p linkage-compiler --test messages` writes all messages:
//! read the difference before you commit it. A name of a phase at the end selects one file.
//!
//! A second test, in the package `linkage-messages`, compares the output of rustc with all cases.
//! That package also has the programs whose messages need rustc. A message has no position in the
//! first line of a text, because that test writes something before it.

mod case_file;
mod difference;
mod rendering;

use std::fs;
use std::path::{Path, PathBuf};

use case_file::{Case, CaseFile};
use difference::difference;
use rendering::rendered;

const PHASES: [&str; 7] = [
    "syntax",
    "links",
    "model",
    "structure",
    "formulate",
    "forces",
    "functions",
];

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/messages")
}

fn read(path: &Path) -> CaseFile {
    let text = fs::read_to_string(path).expect("the cases can be read");
    let cases =
        CaseFile::parsed(&text).unwrap_or_else(|fault| panic!("{}: {fault}", path.display()));
    assert_eq!(
        cases.to_string(),
        text,
        "{} has another form",
        path.display()
    );
    cases
}

/// Compares the messages of all cases of a phase, or writes them if `UPDATE` is set.
fn check(phase: &str) {
    let path = folder().join(format!("{phase}.txt"));
    let mut file = read(&path);
    let mut differences = String::new();
    for Case {
        name,
        mechanism,
        messages: expected,
    } in &mut file.cases
    {
        let messages = rendered(name, mechanism);
        if messages != *expected {
            differences += &format!("=== {name}\n{}\n", difference(expected, &messages));
            *expected = messages;
        }
    }
    if std::env::var_os("UPDATE").is_some() {
        fs::write(&path, file.to_string()).expect("the cases can be written");
        return;
    }
    assert!(
        differences.is_empty(),
        "messages differ from {} in lines with `-` (expected) and `+` (found); UPDATE=1 accepts \
         them\n\n{differences}",
        path.display()
    );
}

#[test]
fn syntax() {
    check("syntax");
}

#[test]
fn links() {
    check("links");
}

#[test]
fn model() {
    check("model");
}

#[test]
fn structure() {
    check("structure");
}

#[test]
fn formulate() {
    check("formulate");
}

#[test]
fn forces() {
    check("forces");
}

#[test]
fn functions() {
    check("functions");
}

#[test]
fn every_file_is_compared() {
    let files = fs::read_dir(folder()).expect("the folder can be read");
    let paths = files.map(|file| file.expect("a file").path());
    let texts = paths.filter(|path| path.extension().is_some_and(|ending| ending == "txt"));
    for path in texts {
        let name = path.file_stem().and_then(|name| name.to_str());
        assert!(
            name.is_some_and(|name| PHASES.contains(&name)),
            "{} is not compared",
            path.display()
        );
    }
}
