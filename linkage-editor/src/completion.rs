//! Words that can be written at a place.

use std::ops::Range;

use linkage_language::model::QuantityWord;
use linkage_language::syntax::{ItemWord, Word, unit_description, unit_names};

use crate::completion_list::{Completion, CompletionKind, CompletionList};
use crate::completion_words::{add_functions, add_inside, add_members, add_names, is_argument};
use crate::context::{Region, region};
use crate::document::Document;
use crate::lexer::Kind;
use crate::signature::call_of_quantity;

/// Returns the words that can be written before a byte, whatever has been written of them.
/// Editors choose those that fit.
pub(crate) fn completions(document: &Document, offset: usize) -> Vec<Completion> {
    let offset = offset.min(document.text.len());
    let Some(range) = begun(document, offset) else {
        return units_after_number(document, offset);
    };
    let mut found = CompletionList {
        range: range.clone(),
        words: Vec::new(),
    };
    if document.text[..range.start].ends_with('.') {
        add_members(document, &mut found, range.start - 1);
        return found.words;
    }
    match region(document, range.start) {
        Region::Outside => {
            found.add(
                "pub struct",
                CompletionKind::Keyword,
                String::new(),
                "A mechanism.",
            );
            found.add(
                "impl",
                CompletionKind::Keyword,
                String::new(),
                "Functions of a mechanism.",
            );
        }
        Region::Implementation => {
            found.add(
                "pub fn",
                CompletionKind::Keyword,
                String::new(),
                "A function of inputs.",
            );
        }
        Region::Item => found.add_words(ItemWord::all(), CompletionKind::Keyword),
        Region::Arguments(outline) => add_names(document, &mut found, outline, is_argument),
        Region::Inside(outline, word) => {
            add_inside(document, &mut found, outline, &word, range.start)
        }
        Region::Quantities(outline) => {
            add_names(document, &mut found, outline, |_| true);
            for word in QuantityWord::all() {
                let call = call_of_quantity(word);
                let text = format!("{}(", word.word());
                found.add_as(
                    word.word(),
                    CompletionKind::Quantity,
                    call,
                    word.description(),
                    text,
                );
            }
            add_functions(document, &mut found, range.start);
        }
    }
    found.words
}

/// Returns the bytes of the word that ends at a byte, empty ones if there is none; `None` after
/// a number or within a comment.
fn begun(document: &Document, offset: usize) -> Option<Range<usize>> {
    let index = document
        .tokens
        .partition_point(|token| token.range.end < offset);
    let Some(token) = document
        .tokens
        .get(index)
        .filter(|token| token.range.start < offset)
    else {
        return Some(offset..offset);
    };
    match token.kind {
        Kind::Word => Some(token.range.start..offset),
        Kind::Blank | Kind::Open | Kind::Close | Kind::Mark => Some(offset..offset),
        Kind::Number | Kind::Comment | Kind::Documentation | Kind::Text | Kind::Unknown => None,
    }
}

/// Returns the units that a number can have.
fn units_after_number(document: &Document, offset: usize) -> Vec<Completion> {
    let index = document
        .tokens
        .partition_point(|token| token.range.end < offset);
    let number = document
        .tokens
        .get(index)
        .filter(|token| token.kind == Kind::Number);
    let Some(number) = number else {
        return Vec::new();
    };
    let written = &document.text[number.range.start..offset];
    let digits = written
        .trim_end_matches(|c: char| c.is_alphabetic() || c == '\u{b5}')
        .len();
    let mut found = CompletionList {
        range: number.range.start + digits..offset,
        words: Vec::new(),
    };
    for unit in unit_names() {
        let description = unit_description(unit).unwrap_or_default();
        found.add(unit, CompletionKind::Unit, description.to_owned(), "");
    }
    found.words
}
