//! A message and the changes that it proposes.

use super::origin::SourceSpan;
use super::text;

/// A mistake and its place.
#[derive(Clone, Debug)]
pub struct Message {
    /// The words at fault.
    pub span: SourceSpan,
    /// The fact, in lower case, names in back-ticks. If possible, a second line `help: ...` names
    /// the text to write.
    pub text: String,
    /// Changes of the source that editors offer.
    pub suggestions: Vec<Suggestion>,
    /// True for another place of the mistake that the message before it reports.
    pub is_related: bool,
}

/// A change of the source that follows the advice of a message.
#[derive(Clone, Debug)]
pub struct Suggestion {
    /// The change in a few words, as in a menu.
    pub title: String,
    /// Its parts, which do not overlap.
    pub edits: Vec<SourceEdit>,
}

/// A text that the source is given.
#[derive(Clone, Debug)]
pub struct SourceEdit {
    /// Words of the source.
    pub span: SourceSpan,
    /// The location of the text, relative to these words.
    pub location: EditLocation,
    /// The text.
    pub text: String,
}

/// The location of a text, relative to words of the source.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EditLocation {
    /// Instead of the words.
    Instead,
    /// Directly after the words.
    After,
    /// Before the item that contains the words: the text is an item, too.
    BeforeItem,
}

impl Message {
    /// A message without a suggestion.
    pub fn new(span: SourceSpan, text: &str) -> Self {
        Self {
            span,
            text: text::short_words(text),
            suggestions: Vec::new(),
            is_related: false,
        }
    }

    /// Adds a change that follows the advice.
    pub fn suggest(
        &mut self,
        title: impl Into<String>,
        span: SourceSpan,
        replacement: impl Into<String>,
    ) {
        self.suggest_all(title, vec![(span, replacement.into())]);
    }

    /// Adds a change in several places, which do not overlap.
    pub fn suggest_all(&mut self, title: impl Into<String>, edits: Vec<(SourceSpan, String)>) {
        let edits = edits.into_iter().map(|(span, text)| SourceEdit {
            span,
            location: EditLocation::Instead,
            text,
        });
        self.suggestions.push(Suggestion {
            title: title.into(),
            edits: edits.collect(),
        });
    }

    /// Adds a change that writes a text at a location.
    pub fn suggest_text(
        &mut self,
        title: impl Into<String>,
        span: SourceSpan,
        location: EditLocation,
        text: impl Into<String>,
    ) {
        self.suggestions.push(Suggestion {
            title: title.into(),
            edits: vec![SourceEdit {
                span,
                location,
                text: text.into(),
            }],
        });
    }
}
