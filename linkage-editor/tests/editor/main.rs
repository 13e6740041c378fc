//! Answers about the templates of the command, whole and while they are being written.

mod actions;
mod completion;
mod hover;
mod navigation;
mod two_stages;
mod written;

use linkage_editor::Document;

/// A template of `linkage new`.
fn template(name: &str) -> Document {
    Document::new(&format!("{name}.mech"), &text(name))
}

/// The names of all templates.
fn templates() -> Vec<String> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../linkage-cli/src/templates");
    let files = std::fs::read_dir(folder).expect("the folder of templates");
    let paths = files.map(|file| file.expect("a file").path());
    let names = paths.map(|path| path.file_stem().expect("a name").display().to_string());
    names.collect()
}

/// The text of a template.
fn text(name: &str) -> String {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../linkage-cli/src/templates");
    std::fs::read_to_string(format!("{folder}/{name}.mech")).expect("a template")
}

/// The byte after a piece of a text, which is in it once or whose first place is meant.
fn after(document: &Document, piece: &str) -> usize {
    let start = document.text().find(piece);
    start.unwrap_or_else(|| panic!("`{piece}`")) + piece.len()
}
