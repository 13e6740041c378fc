//! The table of docs/where-to-add.md with the files that have to know every kind of a thing, compared with the files that name every kind.
//!
//! A `match` without `_` names all variants of its enum, so the files that name all of them are those that rustc demands when one is
//! added. A trait has the files that implement it. A row that lacks such a file, or has one that no longer asks, fails here.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

const HEADING: &str = "## Files that rustc demands";

#[test]
fn the_table_lists_all_files_that_know_every_kind() {
    let sources = sources();
    let mut wrong = Vec::new();
    for Row { name, files } in rows() {
        let definition = sources
            .get(&files[0])
            .unwrap_or_else(|| panic!("`{name}` is defined in `{}`, which is no file", files[0]));
        let is_demanded: Box<dyn Fn(&str) -> bool> =
            if definition.contains(&format!("trait {name}")) {
                let implementation = format!(" {name} for ");
                Box::new(move |text| text.contains(&implementation))
            } else {
                let variants = variants(definition, &name);
                let name = name.clone();
                Box::new(move |text| names_all(text, &name, &variants))
            };
        let found: BTreeSet<&String> = sources
            .iter()
            .filter(|(path, text)| **path == files[0] || is_demanded(text))
            .map(|(path, _)| path)
            .collect();
        let listed: BTreeSet<&String> = files.iter().collect();
        if found != listed {
            wrong.push(format!(
                "`{name}`: found in {found:?}, listed are {listed:?}"
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Kinds that no code may compare with, nor match with `_`: each question about them is one `match` that names them all.
const ASKED_COMPLETELY: [&str; 2] = ["JointKind", "ElementKind"];

/// Where that holds.
const FOLDERS: [&str; 10] = [
    "algebra/",
    "assembly/",
    "forces/",
    "linkage-language/",
    "linkage-rust/",
    "lower/",
    "outputs/",
    "picture/",
    "solve/",
    "structure/",
];

#[test]
fn kinds_are_asked_completely() {
    let mut found = Vec::new();
    for (path, text) in sources() {
        if !FOLDERS.iter().any(|folder| path.starts_with(folder)) {
            continue;
        }
        for name in ASKED_COMPLETELY {
            let compared = ["==", "!="].map(|sign| format!("{sign} {name}::"));
            if compared.iter().any(|text_of| text.contains(text_of)) {
                found.push(format!("{path} compares with a `{name}`"));
            }
            if blocks(&text, "matches!", '(').any(|block| block.contains(&format!("{name}::"))) {
                found.push(format!("{path} has `matches!` with a `{name}`"));
            }
            if blocks(&text, "match ", '{').any(|block| has_silent_arm(block, name)) {
                found.push(format!("{path} matches a `{name}` with `_`"));
            }
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// What stands between the first bracket of a kind and its partner, for each place where a word stands.
fn blocks<'t>(text: &'t str, word: &str, open: char) -> impl Iterator<Item = &'t str> {
    text.match_indices(word).filter_map(move |(start, _)| {
        let start = start + text[start..].find(open)? + 1;
        let mut depth = 0;
        let end = text[start..].find(|letter| {
            depth += bracket(letter);
            depth < 0
        })?;
        Some(&text[start..start + end])
    })
}

fn bracket(letter: char) -> i32 {
    match letter {
        '(' | '[' | '{' => 1,
        ')' | ']' | '}' => -1,
        _ => 0,
    }
}

/// Whether arms of a `match` name an enum's variants, and another takes the rest.
fn has_silent_arm(block: &str, name: &str) -> bool {
    let (mut depth, mut start) = (0, 0);
    let mut patterns = Vec::new();
    for (index, letter) in block.char_indices() {
        depth += bracket(letter);
        match letter {
            '=' if depth == 0 && block[index..].starts_with("=>") => {
                patterns.push(block[start..index].trim());
            }
            ',' | '}' if depth == 0 => start = index + 1,
            _ => {}
        }
    }
    let prefix = format!("{name}::");
    patterns.contains(&"_") && patterns.iter().any(|pattern| pattern.contains(&prefix))
}

/// An enum and the files that name all its variants, or a trait and the files that implement it; the one that defines it first.
struct Row {
    name: String,
    files: Vec<String>,
}

/// The rows of the table: what to add, the enum in back-ticks, the files in back-ticks.
fn rows() -> Vec<Row> {
    let text = read(&root().join("../docs/where-to-add.md"));
    let section = text.split(HEADING).nth(1).expect("the section is there");
    let section = section.split("\n## ").next().unwrap_or_default();
    let lines = section
        .lines()
        .filter(|line| line.starts_with("| "))
        .skip(1);
    let rows: Vec<Row> = lines
        .map(|line| {
            let cells: Vec<&str> = line.split('|').map(str::trim).collect();
            let [_, _, name, files, ..] = cells[..] else {
                panic!("a row with too few cells: {line}");
            };
            Row {
                name: quoted(name).next().expect("the name of an enum"),
                files: quoted(files).collect(),
            }
        })
        .collect();
    assert!(!rows.is_empty());
    rows
}

/// What stands in back-ticks.
fn quoted(cell: &str) -> impl Iterator<Item = String> {
    cell.split('`').skip(1).step_by(2).map(str::to_owned)
}

/// Other crates than the compiler: their sources begin with the name of the crate.
const OTHER_CRATES: [&str; 9] = [
    "linkage-symbolic",
    "linkage-core",
    "linkage-c",
    "linkage-engine",
    "linkage-export",
    "linkage-js",
    "linkage-language",
    "linkage-rust",
    "linkage-st",
];

/// All sources of the compiler by their paths below `src`, and those of other crates by the name of the crate and the rest, without
/// comments and tests.
fn sources() -> BTreeMap<String, String> {
    let mut all = BTreeMap::new();
    let others =
        OTHER_CRATES.map(|name| (root().join(format!("../{name}/src")), format!("{name}/")));
    let own = (root().join("src"), String::new());
    for (folder, prefix) in std::iter::once(own).chain(others) {
        for path in rust_files(&folder) {
            let below = path.strip_prefix(&folder).expect("a path below the folder");
            let parts: Vec<_> = below.iter().map(|part| part.to_string_lossy()).collect();
            if !parts.iter().any(|part| part.starts_with("tests")) {
                all.insert(format!("{prefix}{}", parts.join("/")), code(&read(&path)));
            }
        }
    }
    all
}

fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    paths
        .flat_map(|path| match path.is_dir() {
            true => rust_files(&path),
            false => vec![path],
        })
        .filter(|path| path.extension().is_some_and(|extension| extension == "rs"))
        .collect()
}

/// The text without comments and without the tests at its end.
fn code(text: &str) -> String {
    let text = text.split("#[cfg(test)]\nmod tests {").next();
    let lines = text.unwrap_or_default().lines();
    let lines = lines.map(|line| line.split("//").next().unwrap_or_default());
    lines.collect::<Vec<_>>().join("\n")
}

/// Whether a file mentions an enum and all its variants behind `::`, or has them all imported.
fn names_all(text: &str, name: &str, variants: &BTreeSet<&str>) -> bool {
    let imported = text.contains(&format!("{name}::*"));
    let names = |variant: &str| {
        let pattern = format!("::{variant}");
        let mut ends = text
            .match_indices(&pattern)
            .map(|(start, own)| start + own.len());
        ends.any(|end| !text[end..].starts_with(|c: char| c.is_alphanumeric() || c == '_'))
    };
    is_named(text, name) && (imported || variants.iter().all(|variant| names(variant)))
}

/// Whether a name stands there as a word, and not as a variant of another enum.
fn is_named(text: &str, name: &str) -> bool {
    let of_word = |c: char| c.is_alphanumeric() || c == '_';
    text.match_indices(name).any(|(start, _)| {
        let (before, after) = (&text[..start], &text[start + name.len()..]);
        !before.ends_with("::") && !before.ends_with(of_word) && !after.starts_with(of_word)
    })
}

/// The variants of an enum: the first words after its brace and after each comma at that depth.
fn variants<'t>(text: &'t str, name: &str) -> BTreeSet<&'t str> {
    // Braces, parameters before them, or how many operands an operation has.
    let heads = [" {", "<", ":"].map(|next| format!("enum {name}{next}"));
    let start = heads.iter().find_map(|head| text.find(head));
    let start = start.unwrap_or_else(|| panic!("`enum {name}` is not where the table says"));
    let open = text[start..].find('{').expect("an enum has braces");
    let body = &text[start + open + 1..];
    let (mut depth, mut awaited) = (0, true);
    let mut variants = BTreeSet::new();
    for (index, letter) in body.char_indices() {
        match letter {
            '{' | '(' | '[' => depth += 1,
            '}' if depth == 0 => break,
            '}' | ')' | ']' => depth -= 1,
            ',' if depth == 0 => awaited = true,
            _ if awaited && depth == 0 && letter.is_alphabetic() => {
                let rest = &body[index..];
                let end = rest
                    .find(|c: char| !c.is_alphanumeric())
                    .unwrap_or(rest.len());
                variants.insert(&rest[..end]);
                awaited = false;
            }
            _ => {}
        }
    }
    variants
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}
