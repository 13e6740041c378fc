//! Words that can be written, collected for a place.

use std::ops::Range;

use linkage_language::syntax::Word;

use crate::declaration::NameKind;

/// A word that can be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Completion {
    /// The word, as it is listed.
    pub label: String,
    /// Its kind.
    pub kind: CompletionKind,
    /// Its type, form or value, on a line.
    pub detail: String,
    /// Its meaning, in Markdown; may be empty.
    pub documentation: String,
    /// The bytes that it replaces.
    pub range: Range<usize>,
    /// The text instead of them.
    pub text: String,
}

/// The kind of a word that can be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CompletionKind {
    /// A declared name.
    Name(NameKind),
    /// A part of a vector or frame, or a quantity of a link.
    Member,
    /// A function of expressions.
    Function,
    /// A quantity of functions.
    Quantity,
    /// A unit.
    Unit,
    /// A law of motion, or another word of a course.
    Law,
    /// A word of the language.
    Keyword,
}

/// The words that have been found.
pub(crate) struct CompletionList {
    pub(crate) range: Range<usize>,
    pub(crate) words: Vec<Completion>,
}

impl CompletionList {
    pub(crate) fn add(
        &mut self,
        label: &str,
        kind: CompletionKind,
        detail: String,
        documentation: &str,
    ) {
        let text = label.to_owned();
        self.add_as(label, kind, detail, documentation, text);
    }

    pub(crate) fn add_as(
        &mut self,
        label: &str,
        kind: CompletionKind,
        detail: String,
        documentation: &str,
        text: String,
    ) {
        self.words.push(Completion {
            label: label.to_owned(),
            kind,
            detail,
            documentation: documentation.to_owned(),
            range: self.range.clone(),
            text,
        });
    }

    pub(crate) fn add_words<W: Word>(
        &mut self,
        words: impl Iterator<Item = W>,
        kind: CompletionKind,
    ) {
        for word in words {
            self.add(word.word(), kind, String::new(), word.description());
        }
    }
}
