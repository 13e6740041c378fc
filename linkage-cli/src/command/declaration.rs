//! The text of a mechanism, for pages that save it with other dimensions.

use std::path::Path;

use linkage_engine::{MechanismCall, Source};

/// Returns the text with a mechanism and all others of its call; `None` if it cannot be read.
pub(super) fn declaration(file: &Path, mechanism: &str) -> Option<String> {
    let source = Source::read(file).ok()?;
    let calls = source.calls();
    // A file that is not Rust has one call, with the comments before its first token.
    if file.extension().is_none_or(|ending| ending != "rs") {
        return Some(source.text().to_owned());
    }
    let texts = calls.iter().filter_map(|call| text_of(&source, call));
    let is_declared = |text: &&str| {
        let mut words = text.split(|c: char| !(c.is_alphanumeric() || c == '_'));
        words.any(|word| word == mechanism)
    };
    texts.into_iter().find(is_declared).map(ToOwned::to_owned)
}

fn text_of<'a>(source: &'a Source, call: &MechanismCall) -> Option<&'a str> {
    let mut tokens = call.tokens.clone().into_iter();
    let first = tokens.next()?.span().byte_range();
    let last = tokens.last()?.span().byte_range();
    source.text().get(first.start..last.end)
}
