//! Samples of pages, as mechanisms.

use std::fs;
use std::path::{Path, PathBuf};

use linkage_compiler::check;
use linkage_engine::{Mechanism, Source};

/// A page of the documents.
pub(crate) struct Page {
    pub(crate) path: PathBuf,
    text: String,
}

impl Page {
    /// Reads a page by its path below `docs`.
    pub(crate) fn read(path: &str) -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"))
            .parent()
            .expect("the repository");
        let path = root.join("docs").join(path);
        let text = fs::read_to_string(&path).expect("a page");
        Self { path, text }
    }

    /// Alternative texts and targets of the pictures that the page shows.
    pub(crate) fn images(&self) -> Vec<(&str, &str)> {
        let parts = self.text.split("![").skip(1);
        let images = parts.map(|part| {
            let (description, rest) = part.split_once("](").expect("a target");
            (description, rest.split(')').next().expect("its end"))
        });
        images.collect()
    }

    /// The text of a mechanism in the first Rust sample after a heading.
    fn sample(&self, heading: &str, name: &str) -> String {
        let start = format!("\n{heading}\n");
        let text = format!("\n{}", self.text);
        let (_, after) = text
            .split_once(&start)
            .unwrap_or_else(|| panic!("{}: no `{heading}`", self.path.display()));
        let (_, code) = after.split_once("```rust\n").expect("a sample");
        let (code, _) = code.split_once("```").expect("a sample ends");
        let source = Source::new("sample.rs", code).expect("tokens");
        let calls = source.calls().iter();
        let mut texts = calls.map(|call| {
            let call = &code[call.range.clone()];
            let (_, text) = call.split_once('{').expect("braces");
            let (text, _) = text.rsplit_once('}').expect("braces");
            text
        });
        let found = texts.find(|text| text.contains(&format!("struct {name} ")));
        let found = found.unwrap_or_else(|| panic!("{heading}: no `{name}`"));
        found.to_owned()
    }

    /// A mechanism of the first Rust sample after a heading.
    pub(crate) fn mechanism(&self, heading: &str, name: &str) -> Mechanism {
        checked(&self.sample(heading, name))
    }

    /// The same with a further function.
    pub(crate) fn with(&self, heading: &str, name: &str, function: &str) -> Mechanism {
        let text = self.sample(heading, name);
        let (text, _) = text.rsplit_once('}').expect("functions");
        checked(&format!("{text} {function} }}"))
    }
}

fn checked(text: &str) -> Mechanism {
    let checked = check(text.parse().expect("tokens"));
    let told = checked.messages.iter().chain(&checked.warnings);
    let told: Vec<&str> = told.map(|message| message.text.as_str()).collect();
    assert!(told.is_empty(), "{told:#?}");
    Mechanism::new(&checked).expect("a mechanism without a mistake")
}
