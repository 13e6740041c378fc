//! Messages as rustc prints them.

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use linkage_compiler::{Message, check_all};
use proc_macro2::TokenStream;

/// Returns all messages about the mechanisms of a text. Warnings are printed if there is no
/// mistake.
pub(crate) fn rendered(name: &str, text: &str) -> String {
    let tokens: TokenStream = text.parse().expect("a text of tokens");
    let mut blocks = Vec::new();
    for checked in check_all(tokens) {
        let (level, messages) = if checked.messages.is_empty() {
            (Level::WARNING, &checked.warnings)
        } else {
            (Level::ERROR, &checked.messages)
        };
        blocks.extend(
            messages
                .iter()
                .map(|message| block(name, text, &level, message)),
        );
    }
    blocks.join("\n")
}

/// A message with the source below it, with a line end.
fn block(name: &str, text: &str, level: &Level<'_>, message: &Message) -> String {
    let [first, last] = [message.span.first, message.span.last].map(|span| span.byte_range());
    // A span that the compiler made itself, without a token of the text, is empty.
    assert!(
        first.start < last.end,
        "{name}: no position of `{}`",
        message.text
    );
    let snippet = Snippet::source(text)
        .path(name)
        .annotation(AnnotationKind::Primary.span(first.start..last.end));
    let title = level.clone().primary_title(&message.text);
    Renderer::plain().render(&[title.element(snippet)]) + "\n"
}
