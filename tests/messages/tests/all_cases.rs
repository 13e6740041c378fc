//! rustc prints the messages of all cases of the compiler, and nothing else: spans of messages lead
//! to the same words, and the skeleton of each faulty mechanism has no error.
//!
//! The cases of a phase are the modules of one program, so that all are built in a few seconds. The
//! test of the compiler, `linkage-compiler/tests/messages`, finds a changed message faster, and
//! prints the difference better.

#[path = "../../../linkage-compiler/tests/messages/case_file.rs"]
mod case_file;

use std::fs;
use std::path::{Path, PathBuf};

use case_file::{Case, CaseFile};

/// Writes a program with the cases of a file, and the expected output next to it. Returns the path
/// of the program.
fn program(cases: &Path) -> PathBuf {
    let text = fs::read_to_string(cases).expect("the cases can be read");
    let cases_of_phase = CaseFile::parsed(&text).expect("the form of cases").cases;
    let phase = cases.file_stem().expect("a name");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("cases")
        .join(phase);
    fs::create_dir_all(&folder).expect("the folder can be made");
    let write = |name: &str, text: &str| {
        let path = folder.join(name);
        fs::write(&path, text).expect("the folder can be written to");
        path
    };
    // Warnings have other words here, and are in `tests/ui`.
    let mut modules = String::from("#![allow(deprecated)]\n\nfn main() {}\n");
    let mut messages = Vec::new();
    for case in &cases_of_phase {
        let Case {
            name, mechanism, ..
        } = case;
        // Lines have the same numbers as in the case.
        write(
            &format!("{name}.rs"),
            &format!("linkage::mechanism! {{ {mechanism}}}\n"),
        );
        let module = name.replace('.', "_");
        modules += &format!("#[path = \"{name}.rs\"]\nmod {module};\n");
        if case.messages.starts_with("error") {
            let position = format!("--> {name}:");
            let position_in_file = format!("--> $DIR/{name}.rs:");
            messages.push(case.messages.replace(&position, &position_in_file));
        }
    }
    write("program.stderr", &messages.join("\n"));
    write("program.rs", &modules)
}

#[test]
fn messages_are_those_of_the_cases() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = folder.join("../../linkage-compiler/tests/messages");
    let files = fs::read_dir(folder).expect("the folder can be read");
    let mut paths: Vec<PathBuf> = files.map(|file| file.expect("a file").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "txt"));
    paths.sort();
    assert!(paths.len() >= 6, "{} files", paths.len());
    let programs = trybuild::TestCases::new();
    for path in paths {
        programs.compile_fail(program(&path));
    }
}
