//! Folders of the repository that programs write into.

#![allow(dead_code, reason = "not every program needs each of them")]

use std::fs;
use std::path::PathBuf;

/// Returns a path below `target`, where pages and pictures are written, and creates that folder.
///
/// # Panics
/// If it cannot be created.
pub(crate) fn target(name: &str) -> PathBuf {
    let folder = root().join("target");
    fs::create_dir_all(&folder).expect("a folder that can be written");
    folder.join(name)
}

/// Returns a path below `docs`.
pub(crate) fn docs(name: &str) -> PathBuf {
    root().join("docs").join(name)
}

/// True if stored pictures are to be written and not compared.
pub(crate) fn is_update() -> bool {
    std::env::var_os("UPDATE").is_some()
}

fn root() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}
