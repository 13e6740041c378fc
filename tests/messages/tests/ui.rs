//! Every message of the compiler as its user sees it.
//!
//! The folders of `tests/ui` hold mistakes, one kind for each file, by the phase that finds them, with the messages beside them. All
//! are built at once. `TRYBUILD=overwrite cargo test --test ui` writes the messages anew: read the
//! difference before you commit it. `cargo test --test ui messages -- trybuild=formulate` runs the files with that word in their
//! path only.

#[test]
fn messages() {
    let tests = trybuild::TestCases::new();
    for phase in [
        "syntax",
        "model",
        "structure",
        "formulate",
        "forces",
        "functions",
        "skeleton",
    ] {
        tests.compile_fail(format!("tests/ui/{phase}/*.rs"));
    }
}
