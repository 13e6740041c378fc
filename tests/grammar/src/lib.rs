//! The parser of editors and the texts that it has to read.

use std::fs;
use std::path::{Path, PathBuf};
use streaming_iterator::StreamingIterator;
use tree_sitter::{Language, Node, Parser, Query, QueryCursor, Tree};
use tree_sitter_language::LanguageFn;

// Captures of a query in a text.

/// Captures of a query in a text: their names and the texts of their nodes, in the order of the
/// text.
pub struct Captures(Vec<(String, String)>);

impl Captures {
    /// Applies a query to a text.
    ///
    /// # Panics
    ///
    /// If the query has a mistake.
    pub fn of(query: &str, text: &str) -> Self {
        let query = Query::new(&language(), query).unwrap_or_else(|error| panic!("{error}"));
        let tree = tree(text);
        let mut cursor = QueryCursor::new();
        let mut captures = cursor.captures(&query, tree.root_node(), text.as_bytes());
        let mut found = Vec::new();
        while let Some((matched, index)) = captures.next() {
            let capture = matched.captures()[*index];
            let name = query.capture_names()[capture.index as usize];
            // For conditions only.
            if name.starts_with('_') {
                continue;
            }
            let node = capture.node.utf8_text(text.as_bytes());
            found.push((
                name.to_owned(),
                node.expect("a text of whole letters").to_owned(),
            ));
        }
        Self(found)
    }

    /// Returns the last capture of a node with this text: later patterns override earlier
    /// ones.
    pub fn last_of(&self, text: &str) -> Option<&str> {
        let mut captures = self.0.iter().rev();
        let found = captures.find(|(_, node)| node == text);
        found.map(|(name, _)| name.as_str())
    }

    /// Returns the texts of all nodes with a capture of this name.
    pub fn all(&self, name: &str) -> Vec<&str> {
        let captures = self.0.iter().filter(|(own, _)| own == name);
        captures.map(|(_, node)| node.as_str()).collect()
    }
}

// Trees of the parser.

#[allow(unsafe_code, reason = "the parser is C code")]
unsafe extern "C" {
    fn tree_sitter_linkage() -> *const ();
}

/// Returns the language of the parser.
#[allow(unsafe_code, reason = "the parser is C code")]
pub fn language() -> Language {
    // SAFETY: the function is the one of that name in `parser.c`, which `build.rs` compiles.
    unsafe { LanguageFn::from_raw(tree_sitter_linkage) }.into()
}

/// Returns the tree of a text.
///
/// # Panics
///
/// If the parser and the library have different versions.
pub fn tree(text: &str) -> Tree {
    let mut parser = Parser::new();
    parser
        .set_language(&language())
        .expect("a parser of this version");
    parser.parse(text, None).expect("no limit of time is set")
}

/// Returns the lines of a text that the parser cannot read, from 1, each with its text.
pub fn faults(text: &str) -> Vec<String> {
    let tree = tree(text);
    let mut faults = Vec::new();
    collect(tree.root_node(), text, &mut faults);
    faults
}

fn collect(node: Node<'_>, text: &str, faults: &mut Vec<String>) {
    if !node.has_error() {
        return;
    }
    if node.is_error() || node.is_missing() {
        let row = node.start_position().row;
        let line = text.lines().nth(row).unwrap_or_default();
        faults.push(format!("{}: {}", row + 1, line.trim()));
        return;
    }
    for index in 0..node.child_count() {
        let child = node.child(index).expect("a child of this index");
        collect(child, text, faults);
    }
}

// Words of grammars.

/// Returns the words of the grammar that are no names of nodes.
pub fn kinds_of_words() -> Vec<String> {
    let language = language();
    let kinds = (0..language.node_kind_count() as u16)
        .filter(|kind| !language.node_kind_is_named(*kind) && language.node_kind_is_visible(*kind));
    let kinds = kinds.filter_map(|kind| language.node_kind_for_id(kind));
    let words = kinds.filter(|kind| kind.starts_with(char::is_alphabetic));
    words.map(str::to_owned).collect()
}

/// Returns all texts in quotes.
pub fn quoted(text: &str) -> Vec<&str> {
    text.split('"').skip(1).step_by(2).collect()
}

// Texts of the repository in the language: files, and calls of the macro.

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
