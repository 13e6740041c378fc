//! The package compiled for another processor.

use std::path::{Path, PathBuf};
use std::process::Command;

/// The library for a target, or nothing if its standard library is not installed.
///
/// # Panics
///
/// If `LINKAGE_TARGETS` has its name: then it must be.
pub(crate) fn library(target: &str) -> Option<PathBuf> {
    if !is_installed(target) {
        let required = std::env::var("LINKAGE_TARGETS").unwrap_or_default();
        let required = required.split_whitespace().any(|name| name == target);
        assert!(
            !required,
            "{target} is not installed: rustup target add {target}"
        );
        println!("{target} is not installed: skipped (rustup target add {target})");
        return None;
    }
    // Where this test was built: what runs on this machine, the macro among it, is there already.
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).parent()?;
    let built = Command::new(env!("CARGO"))
        .args([
            "build",
            "--quiet",
            "--lib",
            "--package",
            "linkage-controllers",
        ])
        .args(["--target", target, "--target-dir"])
        .arg(directory)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        // Flags for this machine are none for others.
        .env_remove("RUSTFLAGS")
        .env_remove("CARGO_ENCODED_RUSTFLAGS")
        .status()
        .expect("cargo runs");
    assert!(built.success(), "the package compiles for {target}");
    Some(
        directory
            .join(target)
            .join("debug/liblinkage_controllers.rlib"),
    )
}

fn is_installed(target: &str) -> bool {
    let rustc = std::env::var_os("RUSTC").unwrap_or("rustc".into());
    let output = Command::new(rustc)
        .args(["--print", "target-libdir", "--target", target])
        .output()
        .expect("rustc runs");
    let path = String::from_utf8_lossy(&output.stdout);
    output.status.success() && Path::new(path.trim()).is_dir()
}
