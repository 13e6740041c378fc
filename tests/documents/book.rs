//! The book: `docs/SUMMARY.md` has every document of `docs/` once, headings have an order, and samples are tested.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::{anchor, documents, headings, lines};

const SUMMARY: &str = "docs/SUMMARY.md";

/// Titles and pages of the list of contents, in order.
fn contents(summary: &str) -> Vec<(&str, PathBuf)> {
    let links = summary.lines().filter_map(|line| {
        let (title, rest) = line.split_once('[')?.1.split_once("](")?;
        Some((title, Path::new("docs").join(rest.strip_suffix(')')?)))
    });
    links.collect()
}

/// Values that occur a second time.
fn repeated<T: Ord + Clone>(values: impl IntoIterator<Item = T>) -> Vec<T> {
    let mut seen = BTreeSet::new();
    let values = values.into_iter();
    values.filter(|value| !seen.insert(value.clone())).collect()
}

#[test]
fn the_summary_has_every_page_once() {
    let summary = fs::read_to_string(SUMMARY).expect("the list of contents");
    let contents = contents(&summary);
    let titles = repeated(contents.iter().map(|(title, _)| *title));
    assert!(titles.is_empty(), "titles that occur twice: {titles:?}");
    let listed = contents.into_iter().map(|(_, page)| page);
    let listed: Vec<PathBuf> = listed.collect();
    let twice = repeated(listed.clone());
    assert!(twice.is_empty(), "pages that occur twice: {twice:?}");
    let listed: BTreeSet<PathBuf> = listed.into_iter().collect();
    let there = documents().into_iter();
    let there: BTreeSet<PathBuf> = there.filter(|page| page != Path::new(SUMMARY)).collect();
    let absent: Vec<_> = there.difference(&listed).collect();
    assert!(absent.is_empty(), "not in {SUMMARY}: {absent:?}");
    let missing: Vec<_> = listed.difference(&there).collect();
    assert!(missing.is_empty(), "no such page: {missing:?}");
}

/// Every part of the list has a page, and entries are at most one level deeper than the entry before.
#[test]
fn the_summary_has_an_order() {
    let summary = fs::read_to_string(SUMMARY).expect("the list of contents");
    let parts: Vec<&str> = summary.split("\n# ").skip(1).collect();
    let titles: Vec<&str> = parts
        .iter()
        .filter_map(|part| part.lines().next())
        .collect();
    let expected = [
        "First steps",
        "Language",
        "Cookbook",
        "Analysis",
        "Design",
        "Reports",
        "Export",
        "Command",
    ];
    assert!(titles.starts_with(&expected), "{titles:?}");
    for part in parts {
        let mut deepest = 0;
        let mut count = 0;
        for line in part
            .lines()
            .filter(|line| line.trim_start().starts_with("- "))
        {
            let depth = line.len() - line.trim_start().len();
            assert!(depth <= deepest, "{SUMMARY}: `{line}` is too deep");
            deepest = depth + 2;
            count += 1;
        }
        assert!(count > 0, "{SUMMARY}: no page in `{part}`");
    }
}

#[test]
fn the_book_is_made_of_the_documents() {
    let settings = fs::read_to_string("book.toml").expect("the settings of the book");
    assert!(settings.lines().any(|line| line == "src = \"docs\""));
    // A page that is missing is an error of mdBook, too.
    assert!(
        settings
            .lines()
            .any(|line| line == "create-missing = false")
    );
}

/// Faults in the headings of a page: a level that is left out, or two headings with one address.
fn faults_of_headings(text: &str) -> Vec<String> {
    let headings = headings(text);
    let mut faults = Vec::new();
    let mut before = headings.first().map_or(1, |(level, _)| *level);
    if before > 2 {
        faults.push(format!("begins with a heading of level {before}"));
    }
    for (level, title) in &headings {
        if *level > before + 1 {
            faults.push(format!(
                "`{title}` is of level {level} after level {before}"
            ));
        }
        before = *level;
    }
    let addresses = repeated(headings.iter().map(|(_, title)| anchor(title)));
    faults.extend(
        addresses
            .into_iter()
            .map(|own| format!("`#{own}` is there twice")),
    );
    faults
}

#[test]
fn headings_have_an_order_and_one_address_each() {
    for page in documents() {
        let text = fs::read_to_string(&page).expect("a page");
        let faults = faults_of_headings(&text);
        assert!(faults.is_empty(), "{}: {faults:?}", page.display());
    }
    assert_eq!(faults_of_headings("# A\n\n### B\n").len(), 1);
    assert_eq!(faults_of_headings("# A\n\n## A\n").len(), 1);
    assert!(faults_of_headings("# A\n\n```text\n### B\n```\n\n## C\n\n# D\n").is_empty());
}

/// Whether the documentation tests take a block with this first line as Rust.
fn is_program(fence: &str) -> bool {
    let language = fence.trim().trim_start_matches('`');
    let language = language.split([',', ' ']).next().unwrap_or_default();
    let rust = ["", "rust", "no_run", "compile_fail", "should_panic"];
    rust.contains(&language)
}

fn has_program(text: &str) -> bool {
    let fences = lines(text).filter(|(_, _, line)| line.trim_start().starts_with("```"));
    fences.step_by(2).any(|(_, _, fence)| is_program(fence))
}

/// A program of a page is a test only if a crate includes the page: the facade, or the engine its own.
#[test]
fn pages_with_programs_are_tested() {
    let source = |path| fs::read_to_string(path).expect("the crate");
    let engine = source("linkage-engine/src/lib.rs").replace("../../docs/", "../docs/");
    let source =
        source("src/lib.rs") + &engine.replace("../README.md", "../linkage-engine/README.md");
    let mut count = 0;
    for page in documents() {
        let text = fs::read_to_string(&page).expect("a page");
        if has_program(&text) {
            let included = format!("include_str!(\"../{}\")", page.display());
            assert!(
                source.contains(&included),
                "{} is in no src/lib.rs",
                page.display()
            );
            count += 1;
        }
    }
    assert!(count > 20, "{count} pages");
    assert!(has_program("```rust,no_run\n1\n```\n"));
    assert!(has_program("```text\n1\n```\n\n```\n1\n```\n"));
    assert!(!has_program("```text\n1\n```\n\n```toml\n1\n```\n"));
}
