//! Texts of the repository in the language: files, and calls of the macro.

use std::fs;
use std::path::{Path, PathBuf};

/// Folders with files that were built, or that belong to other programs.
const LEFT_OUT: [&str; 4] = [".git", "node_modules", "shared", "target"];

/// A text in the language.
pub struct Text {
    /// The file of the text, from the root of the repository; with a line for a part of the file.
    pub name: String,
    /// The text itself.
    pub text: String,
}

/// Returns the root of the repository.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Returns the text of a file of the repository.
///
/// # Panics
///
/// If there is no such file.
pub fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// Returns all text files of the repository with mechanisms.
pub fn mechanism_files() -> Vec<Text> {
    files(Path::new("."), "mech")
}

/// Returns all calls of the macro in the Rust files of a folder.
pub fn rust_macros(folder: &str) -> Vec<Text> {
    let files = files(Path::new(folder), "rs");
    files.iter().flat_map(calls).collect()
}

/// Returns all calls of the macro in the samples of the documents of a folder.
pub fn samples(folder: &str) -> Vec<Text> {
    let code = |document: Text| Text {
        text: code(&document.text),
        ..document
    };
    let files = files(Path::new(folder), "md").into_iter().map(code);
    files.flat_map(|file| calls(&file)).collect()
}

/// Returns the lines of a document between fences; the others are empty.
fn code(document: &str) -> String {
    let mut in_code = false;
    let lines = document.lines().map(|line| {
        in_code ^= line.starts_with("```");
        // Hidden lines of a sample begin with this sign.
        let shown = line.strip_prefix("# ").unwrap_or(line);
        if in_code { shown } else { "" }
    });
    lines.collect::<Vec<_>>().join("\n")
}

fn files(folder: &Path, ending: &str) -> Vec<Text> {
    let mut found = Vec::new();
    let entries = fs::read_dir(root().join(folder)).expect("a folder of the repository");
    for entry in entries {
        let name = entry.expect("an entry").file_name();
        let path = folder.join(&name);
        if root().join(&path).is_dir() {
            if !LEFT_OUT.iter().any(|left_out| name == *left_out) {
                found.extend(files(&path, ending));
            }
        } else if path.extension().is_some_and(|end| end == ending) {
            let name = path.display().to_string();
            let text = read(&name);
            found.push(Text { name, text });
        }
    }
    found.sort_by(|a, b| a.name.cmp(&b.name));
    found
}

/// Returns the braces of each call of the macro.
fn calls(file: &Text) -> Vec<Text> {
    let starts = file.text.match_indices("mechanism! {");
    let call = |(start, found): (usize, &str)| {
        let text = braces(&file.text[start + found.len() - 1..])?;
        let line = file.text[..start].lines().count();
        let name = format!("{}:{line}", file.name);
        Some(Text { name, text })
    };
    starts.filter_map(call).collect()
}

/// Returns the text from an opening brace to the closing one. Braces in line comments do not count.
fn braces(text: &str) -> Option<String> {
    let mut depth = 0;
    let mut kept = String::new();
    for line in text.lines() {
        let code = line.find("//").map_or(line, |start| &line[..start]);
        for (index, letter) in code.char_indices() {
            match letter {
                '{' => depth += 1,
                '}' => depth -= 1,
                _ => {}
            }
            if depth == 0 {
                kept.push_str(&line[..=index]);
                return Some(kept);
            }
        }
        kept.push_str(line);
        kept.push('\n');
    }
    None
}
