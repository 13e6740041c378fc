//! Changes that the compiler suggests, as replacements of bytes.

use std::ops::Range;

use linkage_compiler::{EditLocation, SourceSpan, Suggestion};

use crate::diagnostics::{Edit, Fix};
use crate::insertion::{insertion, item_at};
use crate::lexer::tokens;
use crate::outline::outlines;

/// Returns a suggested change of a text; `None` if a part of it has no location in the text. `bytes`
/// are those of the words of a span.
pub(crate) fn suggested(
    text: &str,
    suggestion: &Suggestion,
    bytes: impl Fn(SourceSpan) -> Range<usize>,
) -> Option<Fix> {
    let edits = suggestion.edits.iter().map(|edit| {
        let range = bytes(edit.span);
        match edit.location {
            EditLocation::Instead => Some(Edit {
                range,
                text: edit.text.clone(),
            }),
            EditLocation::After => Some(Edit {
                range: range.end..range.end,
                text: edit.text.clone(),
            }),
            EditLocation::BeforeItem => before_item(text, range.start, &edit.text),
        }
    });
    Some(Fix {
        title: suggestion.title.clone(),
        edits: edits.collect::<Option<_>>()?,
    })
}

/// Writes an item before the one that contains a byte.
fn before_item(text: &str, offset: usize, item: &str) -> Option<Edit> {
    let words = tokens(text);
    let outlines = outlines(text, &words);
    let outline = outlines
        .iter()
        .find(|outline| outline.body.contains(&offset))?;
    let location = item_at(text, &words, outline, offset)?;
    Some(insertion(text, location, item))
}
