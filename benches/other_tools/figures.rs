//! The page `docs/other_tools.md` has the figures that `benches/other_tools` measured last.

use std::fs;

use serde_json::Value;

/// Names of the scripts, and names of the page.
const TOOLS: [(&str, &str); 10] = [
    ("linkage", "linkage"),
    ("pylinkage", "pylinkage"),
    ("casadi", "CasADi"),
    ("py_slvs", "py-slvs"),
    ("exudyn", "Exudyn"),
    ("drake", "Drake"),
    ("dartpy", "DART"),
    ("mujoco", "MuJoCo"),
    ("pybullet", "pybullet"),
    ("pinocchio", "Pinocchio"),
];

fn read(path: &str) -> String {
    let path = format!("{}/../{path}", env!("CARGO_MANIFEST_DIR"));
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn results() -> Value {
    let text = read("benches/other_tools/results.json");
    serde_json::from_str(&text).expect("JSON of the scripts")
}

/// Returns the cells of the row that starts with this name and version.
fn row(page: &str, start: &str) -> Vec<String> {
    let line = page
        .lines()
        .find(|line| line.starts_with(&format!("| {start}")));
    let line = line.unwrap_or_else(|| panic!("no row `{start}`"));
    line.split('|')
        .skip(1)
        .map(|cell| cell.trim().to_string())
        .collect()
}

/// The first number of a cell.
fn number(cell: &str) -> f64 {
    let text = cell.split([' ', ';']).next().unwrap_or(cell);
    text.parse()
        .unwrap_or_else(|_| panic!("`{cell}` starts with no number"))
}

#[test]
fn the_table_has_what_was_measured() {
    let page = read("docs/other_tools.md");
    let results = results();
    for (script, name) in TOOLS {
        let result = &results[script];
        let version = result["version"].as_str().expect("a version");
        let cells = row(&page, &format!("{name} {version}"));
        let gap = result["gap"].as_f64().expect("a gap");
        let stated = number(&cells[1]);
        assert!(
            (stated / gap - 1.0).abs() < 0.05,
            "{name}: gap {gap}, stated {stated}"
        );
        let word = match result["changes"].as_u64() {
            Some(0) => "stays",
            Some(20) => "goes over",
            other => panic!("{name}: {other:?} changes"),
        };
        assert!(
            cells[2].starts_with(word),
            "{name}: `{}`, not `{word}`",
            cells[2]
        );
    }
}

/// Every version that was measured is the one that the environments pin.
#[test]
fn versions_are_pinned() {
    let pinned = ["3.11", "3.12"]
        .map(|python| read(&format!("benches/other_tools/requirements-{python}.txt")))
        .concat();
    let results = results();
    let all = results.as_object().expect("one entry a tool");
    assert_eq!(
        all.len(),
        TOOLS.len() + 1,
        "codac, which has no row, and those with one"
    );
    for (script, result) in all.iter().filter(|(script, _)| *script != "linkage") {
        let [package, version] =
            ["package", "version"].map(|key| result[key].as_str().expect("a text"));
        let line = format!("{package}=={version}");
        assert!(
            pinned.lines().any(|own| own == line),
            "{script}: no line `{line}`"
        );
    }
}
