//! The documents of the repository: links, the order of the book, sentences, sizes and the table of crates; the size of examples.

use std::fs;
use std::path::{Path, PathBuf};

use measures::lines;

mod book;
mod crates;
mod links;
mod measures;
mod prose;

/// Documents in `docs/`, at any depth, the list of contents included.
fn documents() -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![PathBuf::from("docs")];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|end| end == "md") {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// All documents: those of the root and of each package, and the book.
fn pages() -> Vec<PathBuf> {
    let alone = [
        "README.md",
        "ARCHITECTURE.md",
        "CHANGELOG.md",
        "CONTRIBUTING.md",
        "editors/README.md",
        "editors/vscode/README.md",
    ];
    let mut pages: Vec<PathBuf> = alone.iter().map(PathBuf::from).collect();
    let entries = fs::read_dir(".").expect("the repository");
    let entries = entries.map(|entry| entry.expect("an entry").path());
    let packages =
        entries.filter(|path| path != Path::new(".") && path.join("Cargo.toml").exists());
    let texts = packages.map(|path| path.join("README.md"));
    pages.extend(texts.map(|path| path.strip_prefix("./").map_or(path.clone(), PathBuf::from)));
    pages.extend(documents());
    assert!(pages.len() > 45, "{} pages", pages.len());
    pages
}

/// Headings of a page: level and text.
fn headings(text: &str) -> Vec<(usize, &str)> {
    let prose = lines(text).filter(|(_, in_code, _)| !in_code);
    let headings = prose.filter_map(|(_, _, line)| {
        let title = line.trim_start_matches('#');
        Some((line.len() - title.len(), title.strip_prefix(' ')?.trim()))
    });
    headings.filter(|(level, _)| *level > 0).collect()
}

/// The end of a link to a heading: small letters, with hyphens between words.
fn anchor(heading: &str) -> String {
    let letters = heading.chars();
    let kept = letters.filter(|letter| letter.is_alphanumeric() || " -_".contains(*letter));
    kept.collect::<String>().to_lowercase().replace(' ', "-")
}

fn has_heading(text: &str, wanted: &str) -> bool {
    let mut all = headings(text).into_iter();
    all.any(|(_, title)| anchor(title) == wanted)
}

/// Targets of links in the lines of a page outside code: `](target)` and `[name]: target`.
fn targets(text: &str) -> Vec<String> {
    let prose: Vec<&str> = lines(text)
        .filter(|(_, in_code, _)| !in_code)
        .map(|line| line.2)
        .collect();
    let prose = prose.join("\n");
    let within = prose
        .split("](")
        .skip(1)
        .filter_map(|rest| Some(rest.split_once(')')?.0));
    let defined = prose
        .lines()
        .filter_map(|line| Some(line.strip_prefix('[')?.split_once("]: ")?.1));
    within.chain(defined).map(String::from).collect()
}
