//! Pages that the program `gallery` has written.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};

use crate::chromium;

/// A report of the gallery.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Its folder's name.
    pub name: String,
    /// Its page.
    pub page: PathBuf,
}

/// The gallery's folder: what `LINKAGE_GALLERY` names, otherwise `target/gallery` of the workspace.
#[must_use]
pub fn folder() -> PathBuf {
    match env::var_os("LINKAGE_GALLERY") {
        Some(named) => PathBuf::from(named),
        None => Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/gallery"),
    }
}

/// A sixth of the reports in the gallery, all of them in long runs: each takes seconds, and they are made of the same parts.
#[must_use]
pub fn some() -> Vec<Entry> {
    linkage_random::one_in(6, entries()).collect()
}

/// The reports in the gallery, by name. Without a gallery none, which is printed.
///
/// # Panics
/// If there is none and a browser is [required](chromium::required).
#[must_use]
pub fn entries() -> Vec<Entry> {
    let folder = folder();
    let mut entries: Vec<Entry> = fs::read_dir(&folder)
        .into_iter()
        .flatten()
        .flatten()
        .map(|item| Entry {
            name: item.file_name().to_string_lossy().into_owned(),
            page: item.path().join("index.html"),
        })
        .filter(|entry| entry.page.is_file())
        .collect();
    entries.sort_by(|a, b| a.name.cmp(&b.name));
    if entries.is_empty() {
        let advice = format!(
            "no report in {}: `cargo test --release -p linkage-tests --test gallery` writes them",
            folder.display()
        );
        assert!(!chromium::required(), "{advice}");
        eprintln!("skipped: {advice}");
    }
    entries
}
