//! The language server as editors meet it: messages on standard input and output.

mod broken;
mod client;
mod editors;
mod real_editors;
mod session;

use std::path::Path;

/// The text of a template of `linkage new`.
fn template(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/templates");
    std::fs::read_to_string(folder.join(format!("{name}.mech"))).expect("a template")
}
