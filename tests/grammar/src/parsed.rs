//! Trees of the parser.

use tree_sitter::{Language, Node, Parser, Tree};
use tree_sitter_language::LanguageFn;

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
