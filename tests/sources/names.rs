//! Names of files, types and identifiers: words of the field, which a reader can search for.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use crate::crates::{CRATES, Source, is_reported, known, sources};
use crate::lexer::Token;

mod avoided;
mod tests;

use avoided::{FILES, TYPES};

/// Types, files and functions that keep such a name: the name, the start of their paths, and the
/// reason.
const EXCEPTIONS: [(&str, &str, &str); 8] = [
    (
        "at",
        "linkage-engine/src/",
        "implements `Dispatch`, whose method generated code has",
    ),
    (
        "at",
        "linkage-rust/src/",
        "generated code has the method of `Dispatch`",
    ),
    (
        "at",
        "linkage-runtime/src/support/coupled/",
        "generated code calls `Coupled::at` and `CoupledGrid::at`",
    ),
    (
        "at",
        "linkage-runtime/src/support/dispatch.rs",
        "generated code has the method of `Dispatch`",
    ),
    (
        "at",
        "linkage-runtime/src/support/sweep/blocks.rs",
        "generated code calls `Block::at`",
    ),
    (
        "at",
        "linkage-symbolic/src/expression/any_vector.rs",
        "the index of a vector of symbols, which is short in formulas",
    ),
    (
        "of",
        "linkage-runtime/src/screw.rs",
        "generated code and programs of users call `Screw::of`",
    ),
    (
        "of",
        "linkage-runtime/src/support/coupled/initial_state.rs",
        "generated code calls `Coupled::of` and `CoupledGrid::of`",
    ),
];

/// Names of functions that a search cannot tell from other words.
const FUNCTIONS: [&str; 4] = ["at", "look", "of", "told"];

/// The identifiers that are counted, and others that are only reported.
const IDENTIFIERS: [&str; 2] = ["own", "place"];
const OTHER_IDENTIFIERS: [&str; 4] = ["all", "at", "of", "told"];

/// File names that may occur more than `MOST_REPETITIONS` times.
const REPEATED: [&str; 5] = ["error.rs", "lib.rs", "main.rs", "mod.rs", "tests.rs"];
const MOST_REPETITIONS: usize = 3;
/// The greatest number of names of files that occur more often.
const KNOWN_REPETITIONS: usize = 25;

/// The greatest numbers for each crate: files, types, functions of such a name, and the counted
/// identifiers.
const KNOWN: [(&str, [usize; COUNTS]); 24] = [
    ("linkage-analysis", [0, 0, 0, 0, 0]),
    ("linkage-c", [0, 0, 0, 0, 0]),
    ("linkage-cli", [0, 0, 0, 0, 0]),
    ("linkage-compiler", [0, 0, 0, 0, 0]),
    ("linkage-core", [0, 0, 0, 0, 0]),
    ("linkage-design", [0, 0, 0, 0, 0]),
    ("linkage-dynamics", [0, 0, 0, 0, 0]),
    ("linkage-editor", [0, 0, 0, 0, 0]),
    ("linkage-engine", [0, 0, 0, 0, 0]),
    ("linkage-export", [0, 0, 0, 0, 0]),
    ("linkage-formats", [0, 0, 0, 0, 0]),
    ("linkage-import", [0, 0, 0, 0, 0]),
    ("linkage-js", [0, 0, 0, 0, 0]),
    ("linkage-language", [0, 0, 0, 0, 0]),
    ("linkage-macros", [0, 0, 0, 0, 0]),
    ("linkage-page", [0, 0, 0, 0, 0]),
    ("linkage-playground", [0, 0, 0, 0, 0]),
    ("linkage-report", [0, 0, 0, 0, 0]),
    ("linkage-rust", [0, 0, 0, 0, 0]),
    ("linkage-runtime", [0, 0, 0, 0, 0]),
    ("linkage-st", [0, 0, 0, 0, 0]),
    ("linkage-symbolic", [0, 0, 0, 0, 0]),
    ("linkage-synthesis", [0, 0, 0, 0, 9]),
    ("src", [0, 0, 0, 0, 0]),
];
const COUNTS: usize = 5;
const WORDS: [&str; COUNTS] = [
    "files",
    "types",
    "functions",
    "identifiers `own`",
    "identifiers `place`",
];

/// Places of faults in one file.
#[derive(Default)]
struct Faults {
    /// Line and name of types, and of functions.
    types: Vec<(usize, String)>,
    functions: Vec<(usize, String)>,
    /// Lines of the counted identifiers.
    identifiers: [Vec<usize>; IDENTIFIERS.len()],
    others: BTreeMap<&'static str, usize>,
}

fn faults(source: &Source) -> Faults {
    const KEYWORDS: [&str; 5] = ["struct", "enum", "union", "trait", "type"];
    let mut faults = Faults::default();
    let tokens = &source.lexed.tokens;
    let excepted = |name: &str| is_excepted(source.path, name);
    for (index, token) in tokens
        .iter()
        .enumerate()
        .filter(|(_, token)| token.is_word())
    {
        if let Some(counted) = IDENTIFIERS.iter().position(|name| *name == token.text) {
            faults.identifiers[counted].push(token.line);
        }
        let other = OTHER_IDENTIFIERS.iter().find(|name| **name == token.text);
        if let Some(name) = other {
            *faults.others.entry(name).or_default() += 1;
        }
        let Some(before) = index.checked_sub(1).map(|before| &tokens[before]) else {
            continue;
        };
        let named = || (token.line, format!("{} {}", before.text, token.text));
        if KEYWORDS.contains(&before.text) && TYPES.contains(&token.text) {
            if !is_associated(tokens, index) && !excepted(token.text) {
                faults.types.push(named());
            }
        } else if before.is("fn") && FUNCTIONS.contains(&token.text) && !excepted(token.text) {
            faults.functions.push(named());
        }
    }
    faults
}

/// True for `type Name` without a visibility: nearly always a type whose name its trait gives.
fn is_associated(tokens: &[Token], index: usize) -> bool {
    let is_type = tokens[index - 1].is("type");
    let is_public = index
        .checked_sub(2)
        .is_some_and(|before| tokens[before].is("pub") || tokens[before].is(")"));
    is_type && !is_public
}

fn is_excepted(path: &str, name: &str) -> bool {
    let mut exceptions = EXCEPTIONS.iter();
    exceptions.any(|exception| exception.0 == name && path.starts_with(exception.1))
}

/// Files and folders with a name that none has.
fn named_files<'t>(paths: impl Iterator<Item = &'t str>) -> BTreeSet<&'t str> {
    let mut found = BTreeSet::new();
    for path in paths {
        let start = path.find("src/").map_or(0, |start| start + 4);
        for (end, _) in path.match_indices(['/', '.']) {
            let Some(part) = path.get(start..end) else {
                continue;
            };
            let name = part.rsplit('/').next().unwrap_or_default();
            let is_wrong = FILES
                .iter()
                .any(|(wrong, under)| *wrong == name && path[..end].contains(under));
            if is_wrong && !is_excepted(path, name) {
                found.insert(&path[..end]);
            }
        }
    }
    found
}

/// Names of files that occur too often, with their numbers.
fn repeated<'t>(paths: impl Iterator<Item = &'t str>) -> Vec<(&'t str, usize)> {
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for path in paths {
        let name = path.rsplit('/').next().unwrap_or_default();
        *counts.entry(name).or_default() += 1;
    }
    let counts = counts.into_iter();
    let mut counts: Vec<_> = counts
        .filter(|(name, count)| *count > MOST_REPETITIONS && !REPEATED.contains(name))
        .collect();
    counts.sort_by_key(|count| std::cmp::Reverse(count.1));
    counts
}

fn paths() -> impl Iterator<Item = &'static str> {
    let sources = sources().iter().filter(|source| !source.is_test());
    sources.map(|source| source.path)
}

/// A crate with the numbers of its faults, and the list of those that are reported.
fn of_crate(home: usize, is_wanted: impl Fn(&str) -> bool) -> ([usize; COUNTS], String) {
    let mut text = String::new();
    let start = format!("{}/", CRATES[home]);
    let files = named_files(paths().filter(|path| path.starts_with(&start)));
    for path in files.iter().filter(|path| is_wanted(path)) {
        let _ = writeln!(text, "  {path}: name of a file");
    }
    let mut counts = [files.len(), 0, 0, 0, 0];
    for source in sources().iter().filter(|source| source.home == home) {
        let faults = faults(source);
        counts[1] += faults.types.len();
        counts[2] += faults.functions.len();
        for (count, lines) in counts[3..].iter_mut().zip(&faults.identifiers) {
            *count += lines.len();
        }
        if !is_wanted(source.path) {
            continue;
        }
        let mut named = [faults.types, faults.functions].concat();
        named.sort();
        for (line, name) in named {
            let _ = writeln!(text, "  {}:{line} {name}", source.path);
        }
        let mut words = Vec::new();
        let counted = IDENTIFIERS.iter().zip(&faults.identifiers);
        for (name, lines) in counted.filter(|(_, lines)| !lines.is_empty()) {
            let count = lines.len();
            let lines: BTreeSet<_> = lines.iter().collect();
            let lines: Vec<String> = lines.iter().map(|line| line.to_string()).collect();
            words.push(format!("`{name}` {count} (lines {})", lines.join(" ")));
        }
        let others = faults.others.iter();
        words.extend(others.map(|(name, count)| format!("`{name}` {count}")));
        if !words.is_empty() {
            let _ = writeln!(text, "  {}: identifiers {}", source.path, words.join(", "));
        }
    }
    (counts, text)
}

#[test]
fn names_are_those_of_the_field() {
    let mut failures = String::new();
    for (home, name) in CRATES.iter().enumerate() {
        let (counts, list) = of_crate(home, |_| true);
        let most = known(&KNOWN, name);
        let mut is_worse = false;
        for (index, word) in WORDS.iter().enumerate() {
            if counts[index] > most[index] {
                is_worse = true;
                let (count, most) = (counts[index], most[index]);
                let _ = writeln!(failures, "{name}: {count} {word}, at most {most}");
            }
        }
        if is_worse {
            failures += &list;
        }
    }
    assert!(failures.is_empty(), "\n{failures}");
}

#[test]
fn names_of_files_are_seldom_repeated() {
    let repeated = repeated(paths());
    assert!(
        repeated.len() <= KNOWN_REPETITIONS,
        "names of more than {MOST_REPETITIONS} files: {repeated:?}"
    );
}

pub(crate) fn report() -> String {
    let mut text = String::new();
    for (home, name) in CRATES.iter().enumerate() {
        let (counts, list) = of_crate(home, is_reported);
        let counts = WORDS.iter().zip(counts);
        let counts = counts.map(|(word, count)| format!("{count} {word}"));
        let _ = writeln!(text, "{name}: {}", counts.collect::<Vec<_>>().join(", "));
        if crate::crates::is_restricted() {
            text += &list;
        } else {
            // Without a folder, names of files, types and functions only.
            let lines = list.lines().filter(|line| !line.contains(": identifiers "));
            lines.for_each(|line| {
                let _ = writeln!(text, "{line}");
            });
        }
    }
    for (name, count) in repeated(paths()) {
        let all = || paths().filter(|path| path.ends_with(&format!("/{name}")));
        if all().any(is_reported) {
            let all = all().collect::<Vec<_>>().join(" ");
            let _ = writeln!(text, "{name} {count} times: {all}");
        }
    }
    text
}
