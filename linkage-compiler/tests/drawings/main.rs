//! Textbook mechanisms and what is drawn of them: links with their points, joints with their links and kind. `drawings.txt` was compared
//! with the books' figures link by link; `UPDATE=1` writes it anew, to be compared again.

use std::fs;
use std::path::{Path, PathBuf};

use linkage_compiler::{Checked, check};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/drawings")
}

/// Names and texts of all mechanisms, by name.
fn mechanisms() -> Vec<(String, String)> {
    let entries = fs::read_dir(folder()).expect("the folder");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let mut paths: Vec<PathBuf> = paths
        .filter(|path| path.extension().is_some_and(|ending| ending == "mech"))
        .collect();
    paths.sort();
    let read = |path: PathBuf| {
        let name = path.file_stem().expect("a name").to_string_lossy();
        (name.into_owned(), fs::read_to_string(&path).expect("text"))
    };
    paths.into_iter().map(read).collect()
}

fn drawn(name: &str, text: &str) -> String {
    let Checked {
        unit,
        messages,
        warnings,
        ..
    } = check(text.parse().expect("tokens"));
    let told: Vec<String> = messages
        .iter()
        .chain(&warnings)
        .map(|own| own.text.clone())
        .collect();
    assert!(told.is_empty(), "{name}: {told:#?}");
    let picture = unit.and_then(|unit| unit.picture).expect("a picture");
    format!("== {name}\n{picture}\n")
}

#[test]
fn drawings() {
    let all = mechanisms();
    assert!(all.len() >= 25, "{} mechanisms", all.len());
    let found: String = all.iter().map(|(name, text)| drawn(name, text)).collect();
    let path = folder().join("drawings.txt");
    if std::env::var_os("UPDATE").is_some() {
        fs::write(&path, &found).expect("the folder can be written to");
    }
    let expected = fs::read_to_string(&path).unwrap_or_default();
    let lines = found.lines().zip(expected.lines()).enumerate();
    for (number, (found, expected)) in lines {
        assert_eq!(found, expected, "line {} of drawings.txt", number + 1);
    }
    assert_eq!(found.lines().count(), expected.lines().count());
}
