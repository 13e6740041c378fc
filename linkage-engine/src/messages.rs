//! Messages of the compiler with the source under them, as rustc prints them.

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use linkage_compiler::{Checked, Message};

use crate::source::{MechanismCall, Source};

/// All messages about a mechanism, one after the other, a blank line behind each; with colours for
/// a terminal. Warnings are printed if there is no mistake.
#[must_use]
pub fn rendered(
    source: &Source,
    found: &MechanismCall,
    checked: &Checked,
    coloured: bool,
) -> String {
    let (level, messages) = match checked.messages.is_empty() {
        true => (Level::WARNING, &checked.warnings),
        false => (Level::ERROR, &checked.messages),
    };
    let one = |message: &Message| drawn(&level, source, found, message, coloured);
    messages.iter().map(one).collect()
}

/// A warning about a mechanism with the source under it, and a blank line.
#[must_use]
pub fn rendered_warning(
    source: &Source,
    found: &MechanismCall,
    message: &Message,
    coloured: bool,
) -> String {
    drawn(&Level::WARNING, source, found, message, coloured)
}

/// A message with the source under it, and a blank line.
fn drawn(
    level: &Level<'_>,
    source: &Source,
    found: &MechanismCall,
    message: &Message,
    coloured: bool,
) -> String {
    let renderer = match coloured {
        true => Renderer::styled(),
        false => Renderer::plain(),
    };
    let [first, last] = [message.span.first, message.span.last].map(|span| span.byte_range());
    // Only text that was made up by the compiler begins and ends with the text.
    let span = match (first.start, last.end) {
        (0, 0) => found.range.clone(),
        (start, end) => start..end,
    };
    let snippet = Snippet::source(source.text())
        .path(source.name())
        .annotation(AnnotationKind::Primary.span(span));
    let title = level.clone().primary_title(&message.text);
    renderer.render(&[title.element(snippet)]) + "\n\n"
}
