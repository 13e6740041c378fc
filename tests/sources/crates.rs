//! The sources of all crates, read once for all tests of this program.

use std::env;
use std::fs;
use std::path::Path;
use std::sync::OnceLock;
use std::thread;

use crate::lexer::{Lexed, lexed};

/// Crates by their folders; the facade has its sources in `src`.
pub(crate) const CRATES: [&str; 24] = [
    "linkage-analysis",
    "linkage-c",
    "linkage-cli",
    "linkage-compiler",
    "linkage-core",
    "linkage-design",
    "linkage-dynamics",
    "linkage-editor",
    "linkage-formats",
    "linkage-engine",
    "linkage-export",
    "linkage-import",
    "linkage-js",
    "linkage-language",
    "linkage-macros",
    "linkage-page",
    "linkage-playground",
    "linkage-report",
    "linkage-rust",
    "linkage-runtime",
    "linkage-st",
    "linkage-symbolic",
    "linkage-synthesis",
    "src",
];

/// A file of a crate.
pub(crate) struct Source<'t> {
    /// The index in `CRATES`.
    pub(crate) home: usize,
    /// From the root of the repository.
    pub(crate) path: &'t str,
    pub(crate) lexed: Lexed<'t>,
}

impl Source<'_> {
    /// The path below the folder `src` of its crate.
    pub(crate) fn below(&self) -> &str {
        let parts = self.path.split_once("src/");
        parts.map_or(self.path, |parts| parts.1)
    }

    /// True in `tests.rs` and below `tests/`.
    pub(crate) fn is_test(&self) -> bool {
        let mut parts = self.below().split('/');
        parts.any(|part| part == "tests" || part == "tests.rs")
    }
}

/// The figure of a crate in a table that has all crates.
pub(crate) fn known<T: Copy>(table: &[(&str, T)], name: &str) -> T {
    let row = table.iter().find(|row| row.0 == name);
    row.unwrap_or_else(|| panic!("`{name}` is not in the table"))
        .1
}

/// All sources of the crates, tests included, in the order of their paths.
pub(crate) fn sources() -> &'static [Source<'static>] {
    static TEXTS: OnceLock<Vec<(usize, String, String)>> = OnceLock::new();
    static SOURCES: OnceLock<Vec<Source>> = OnceLock::new();
    SOURCES.get_or_init(|| {
        let texts = TEXTS.get_or_init(|| {
            let mut texts = Vec::new();
            for (home, name) in CRATES.iter().enumerate() {
                let folder = Path::new(name);
                let folder = if *name == "src" {
                    folder.to_owned()
                } else {
                    folder.join("src")
                };
                read_all(&folder, home, &mut texts);
            }
            assert!(texts.len() > 500, "{} files", texts.len());
            texts
        });
        // In two halves of equal sizes, since most of the time goes into this.
        let total: usize = texts.iter().map(|text| text.2.len()).sum();
        let mut size = 0;
        let middle = texts.iter().position(|text| {
            size += text.2.len();
            size > total / 2
        });
        let (first, second) = texts.split_at(middle.unwrap_or_default());
        thread::scope(|scope| {
            let second = scope.spawn(|| read(second));
            let mut sources = read(first);
            sources.extend(second.join().expect("sources that can be read"));
            sources
        })
    })
}

fn read(texts: &[(usize, String, String)]) -> Vec<Source<'_>> {
    let sources = texts.iter().map(|(home, path, text)| Source {
        home: *home,
        path,
        lexed: lexed(text),
    });
    sources.collect()
}

fn read_all(folder: &Path, home: usize, texts: &mut Vec<(usize, String, String)>) {
    let entries = fs::read_dir(folder).expect("a folder of the repository");
    let mut paths: Vec<_> = entries
        .map(|entry| entry.expect("an entry").path())
        .collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            read_all(&path, home, texts);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let text = fs::read_to_string(&path).expect("a file that can be read");
            let path = path.to_string_lossy().replace('\\', "/");
            texts.push((home, path, text));
        }
    }
}

/// True if the variable `SOURCES_UNDER` restricts reports to a folder or a file.
pub(crate) fn is_restricted() -> bool {
    env::var("SOURCES_UNDER").is_ok_and(|under| !under.is_empty())
}

/// True for paths below `SOURCES_UNDER`, or for all without it.
pub(crate) fn is_reported(path: &str) -> bool {
    env::var("SOURCES_UNDER").map_or(true, |under| path.starts_with(&under))
}

/// Sources from texts, as tests of the checks use them.
pub(crate) fn from_texts<'t>(texts: &[(&'t str, &'t str)]) -> Vec<Source<'t>> {
    let sources = texts.iter().map(|(path, text)| Source {
        home: CRATES
            .iter()
            .position(|name| path.starts_with(name))
            .expect("a path of a crate"),
        path,
        lexed: lexed(text),
    });
    sources.collect()
}
