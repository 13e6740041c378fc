//! Mechanisms that are exported: those of the golden files and of the examples.

use std::fs;
use std::path::Path;

use linkage_compiler::check;
use linkage_compiler::unit::Unit;
use proc_macro2::{TokenStream, TokenTree};

/// A mechanism with its name.
pub(crate) struct Given {
    pub(crate) name: String,
    pub(crate) unit: Unit,
}

impl Given {
    /// A mechanism from what stands between the braces of `mechanism!`.
    pub(crate) fn new(body: TokenStream) -> Self {
        let name = name(&body);
        let checked = check(body);
        let messages = checked.messages;
        let unit = checked
            .unit
            .unwrap_or_else(|| panic!("{name}: {messages:?}"));
        Self { name, unit }
    }

    /// A mechanism from its text.
    pub(crate) fn text(text: &str) -> Self {
        Self::new(text.parse().expect("brackets have partners"))
    }
}

/// The word behind `struct`.
fn name(body: &TokenStream) -> String {
    let mut words = body.clone().into_iter().map(|token| token.to_string());
    words.find(|word| word == "struct");
    words.next().expect("a mechanism has a name")
}

/// Golden mechanisms and examples.
pub(crate) fn exported() -> Vec<Given> {
    let mut all = golden();
    all.extend(examples());
    all
}

/// The mechanisms of the golden files.
pub(crate) fn golden() -> Vec<Given> {
    let texts = texts("../linkage-compiler/tests/golden", "mech");
    texts.iter().map(|text| Given::text(text)).collect()
}

/// The mechanisms of the examples.
pub(crate) fn examples() -> Vec<Given> {
    let texts = texts("../examples", "rs");
    let mut bodies = Vec::new();
    for text in texts {
        find(text.parse().expect("Rust"), &mut bodies);
    }
    bodies.into_iter().map(Given::new).collect()
}

fn texts(folder: &str, end: &str) -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let files = fs::read_dir(folder).expect("there are files");
    let mut paths: Vec<_> = files.map(|file| file.expect("a file").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|own| own == end));
    paths.sort();
    let texts = paths.iter().map(fs::read_to_string);
    texts.map(|text| text.expect("it can be read")).collect()
}

/// What stands in the braces of `mechanism!`, wherever that is called.
fn find(tokens: TokenStream, bodies: &mut Vec<TokenStream>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    for (index, token) in tokens.iter().enumerate() {
        let TokenTree::Group(group) = token else {
            continue;
        };
        let before = tokens[..index]
            .iter()
            .rev()
            .take(2)
            .map(ToString::to_string);
        match before.collect::<Vec<_>>() == ["!", "mechanism"] {
            true => bodies.push(group.stream()),
            false => find(group.stream(), bodies),
        }
    }
}
