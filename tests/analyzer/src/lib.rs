//! rust-analyzer as a program of tests: it is asked as an editor asks it.
//!
//! Programs are described to it crate by crate, with the macro that the tests are built with: it
//! builds nothing.

mod client;
mod project;

pub use client::{Analyzer, Location};
pub use project::Project;

/// Returns true if tests should run: rust-analyzer and the sources of the standard library are
/// there.
///
/// # Panics
///
/// If they are required by `LINKAGE_RUST_ANALYZER=required` and not there.
pub fn is_there() -> bool {
    let found = project::sysroot_sources().is_some_and(|path| path.is_dir())
        && std::process::Command::new("rust-analyzer")
            .arg("--version")
            .output()
            .is_ok_and(|output| output.status.success());
    let required = std::env::var("LINKAGE_RUST_ANALYZER").is_ok_and(|value| value == "required");
    assert!(
        found || !required,
        "rustup component add rust-analyzer rust-src"
    );
    found
}
