//! Crates and examples: each crate depends on those of its row in ARCHITECTURE alone, examples are few and short.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

// The crates of ARCHITECTURE against their manifests: each depends on the crates of its row alone.

/// Names of crates begin with it, except in the last column of the table.
const START: &str = "linkage-";

/// Crates of the workspace that a manifest depends on, tests excepted.
fn dependencies(manifest: &str) -> BTreeSet<String> {
    let (_, rest) = manifest
        .split_once("\n[dependencies]\n")
        .unwrap_or_default();
    let section = rest.split("\n[").next().unwrap_or_default();
    let names = section.lines().filter_map(|line| line.strip_prefix(START));
    let names = names.filter_map(|line| line.split(['.', ' ', '=']).next());
    names.map(String::from).collect()
}

/// Crates in the last column of a row: `runtime, core; formats for files`.
fn listed(column: &str, crates: &BTreeSet<String>) -> BTreeSet<String> {
    let words = column.split(|letter: char| !letter.is_alphanumeric());
    let names = words.filter(|word| crates.contains(*word));
    names.map(String::from).collect()
}

#[test]
fn crates_depend_on_those_of_their_row() {
    let entries = fs::read_dir(".").expect("the repository");
    let folders = entries.filter_map(|entry| entry.ok()?.file_name().into_string().ok());
    let crates: BTreeSet<String> = folders
        .filter(|folder| Path::new(folder).join("Cargo.toml").exists())
        .filter_map(|folder| folder.strip_prefix(START).map(String::from))
        .collect();
    let text = fs::read_to_string("ARCHITECTURE.md").expect("a document");
    let mut rows = BTreeSet::new();
    for line in text.lines().filter(|line| line.starts_with("| `linkage-")) {
        let cells: Vec<&str> = line.trim_end_matches('|').split('|').collect();
        let [_, name, _, column] = cells[..] else {
            panic!("a row has three cells: {line}");
        };
        let name = name.split('`').nth(1).expect("a name in back-ticks");
        let name = name.strip_prefix(START).expect("the name of a crate");
        let manifest = match name {
            "mechanism" => "Cargo.toml".to_owned(),
            _ => format!("{START}{name}/Cargo.toml"),
        };
        let manifest = fs::read_to_string(manifest).expect("a manifest");
        assert_eq!(dependencies(&manifest), listed(column, &crates), "{name}");
        rows.insert(name.to_owned());
    }
    assert!(rows.remove("mechanism"), "a row of the facade");
    assert_eq!(rows, crates);
}

// Examples are few and short, and they are built without dependencies of tests.

/// Examples that a newcomer can read in order.
const MOST: usize = 15;
/// Lines of each of them.
const LINES: usize = 100;

#[test]
fn examples_are_few_and_short() {
    let page = fs::read_to_string("docs/examples.md").expect("the page about examples");
    let manifest = fs::read_to_string("Cargo.toml").expect("the manifest");
    let entries = fs::read_dir("examples").expect("the folder");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let mut count = 0;
    for path in paths.filter(|path| path.is_file()) {
        let name = path.file_stem().expect("a name").to_string_lossy();
        let text = fs::read_to_string(&path).expect("an example");
        let lines = text.lines().count();
        assert!(lines <= LINES, "{}: {lines} lines", path.display());
        assert!(
            page.contains(&format!("\n| `{name}` | ")),
            "docs/examples.md: no row for `{name}`"
        );
        let tested = format!("[[example]]\nname = \"{name}\"\ntest = true\n");
        assert!(
            manifest.contains(&tested),
            "Cargo.toml: no test of `{name}`"
        );
        count += 1;
    }
    assert!(0 < count && count <= MOST, "{count} examples");
}

/// All examples are built with what any of them needs.
#[test]
fn examples_need_no_dependencies_of_tests() {
    let manifest = fs::read_to_string("Cargo.toml").expect("the manifest");
    assert!(!manifest.contains("\n[dev-dependencies"));
}
