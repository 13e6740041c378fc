//! The drawings of this test: files in the formats of the tools, with the facts behind them.

use std::fs;
use std::path::{Path, PathBuf};

use linkage_import::{Import, Options, import};

/// The folder of this test.
pub(crate) fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/import")
}

/// Returns all files, in the order of their names.
pub(crate) fn all() -> Vec<PathBuf> {
    let entries = fs::read_dir(folder().join("files")).expect("the folder of files");
    let mut files: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry").path())
        .collect();
    files.sort();
    assert!(files.len() >= 14 + 25, "{} files", files.len());
    files
}

/// Returns the name of a drawing: that of its file without the extension.
pub(crate) fn name(file: &Path) -> String {
    let stem = file.file_stem().expect("a name");
    stem.to_string_lossy().into_owned()
}

/// Imports a file.
pub(crate) fn imported(file: &Path, options: &Options) -> Import {
    let content = fs::read(file).expect("a file");
    let name = file.file_name().expect("a name").to_string_lossy();
    let imported = import(&content, &name, options);
    imported.unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Imports a text.
pub(crate) fn of_text(text: &str, name: &str) -> Import {
    let imported = import(text.as_bytes(), name, &Options::default());
    imported.unwrap_or_else(|error| panic!("{name}: {error}"))
}
