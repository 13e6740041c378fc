//! Examples are few and short, and they are built without dependencies of tests.

use std::fs;

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
