//! The surroundings of a place: the call around it, the path before it, the part of the text.

use std::ops::Range;

use crate::document::Document;
use crate::lexer::Kind;
use crate::outline::Outline;
use crate::statements::begins_item;

/// The part of a text that contains a place.
#[derive(Clone, Debug)]
pub(crate) enum Region<'d> {
    /// Outside of all blocks.
    Outside,
    /// At the beginning of an item of a struct block.
    Item,
    /// After the word of an item, within it.
    Inside(&'d Outline, String),
    /// In an `impl` block, outside of functions.
    Implementation,
    /// Among the arguments of a function.
    Arguments(&'d Outline),
    /// Among the quantities of a function.
    Quantities(&'d Outline),
}

/// Names with dots between them.
#[derive(Clone, Debug)]
pub(crate) struct Path {
    /// `coupler.length`
    pub(crate) name: String,
    pub(crate) range: Range<usize>,
}

/// A call around a place.
#[derive(Clone, Debug)]
pub(crate) struct EnclosingCall {
    pub(crate) word: String,
    /// The number of commas between the parenthesis and the place.
    pub(crate) argument: usize,
}

/// Returns the token after another one, without blanks and comments.
pub(crate) fn next_solid(document: &Document, index: usize) -> &str {
    let mut after = document.tokens[index + 1..].iter();
    let next = after.find(|token| !token.is_trivia());
    next.map_or("", |token| token.text(&document.text))
}

/// Returns the names with dots that end with a word.
pub(crate) fn path_at(document: &Document, index: usize) -> Option<Path> {
    let last = &document.tokens[index];
    let mut start = index;
    while start >= 2
        && document.tokens[start - 1].text(&document.text) == "."
        && document.tokens[start - 2].kind == Kind::Word
    {
        start -= 2;
    }
    let range = document.tokens[start].range.start..last.range.end;
    (start < index).then(|| Path {
        name: document.text[range.clone()].to_owned(),
        range,
    })
}

/// Returns the path before a dot at a byte.
pub(crate) fn path_before(document: &Document, dot: usize) -> Option<String> {
    let index = document
        .tokens
        .partition_point(|token| token.range.end < dot);
    let token = document
        .tokens
        .get(index)
        .filter(|token| token.range.end == dot)?;
    if token.kind != Kind::Word {
        return None;
    }
    let path = path_at(document, index).map(|path| path.name);
    Some(path.unwrap_or_else(|| token.text(&document.text).to_owned()))
}

/// Returns the innermost call around a byte.
pub(crate) fn call_at(document: &Document, offset: usize) -> Option<EnclosingCall> {
    let end = document
        .tokens
        .partition_point(|token| token.range.end <= offset);
    let (mut depth, mut argument) = (0, 0);
    for index in (0..end).rev() {
        let token = &document.tokens[index];
        let text = token.text(&document.text);
        match token.kind {
            Kind::Close => depth += 1,
            Kind::Open if depth > 0 => depth -= 1,
            Kind::Open if text == "(" => {
                let before = document.tokens[..index].last();
                let word = before.filter(|token| token.kind == Kind::Word);
                match word {
                    Some(word) => {
                        let word = word.text(&document.text).to_owned();
                        return Some(EnclosingCall { word, argument });
                    }
                    // A vector: the call around it is meant.
                    None => argument = 0,
                }
            }
            Kind::Open if text == "[" => argument = 0,
            Kind::Open => return None,
            Kind::Mark if depth == 0 && text == "," => argument += 1,
            Kind::Mark if depth == 0 && text == ";" => return None,
            _ => {}
        }
    }
    None
}

/// Returns the part of the text that contains a byte.
pub(crate) fn region(document: &Document, offset: usize) -> Region<'_> {
    let within = |range: &Range<usize>| range.start <= offset && offset <= range.end;
    for outline in &document.outlines {
        if let Some(function) = outline.function_at(offset) {
            if within(&function.arguments) {
                return Region::Arguments(outline);
            }
            if within(&function.body) {
                return Region::Quantities(outline);
            }
        }
        if outline.implementations.iter().any(within) {
            // Outside of functions, only their arguments have parentheses.
            return match call_at(document, offset) {
                Some(_) => Region::Arguments(outline),
                None => Region::Implementation,
            };
        }
        if within(&outline.body) {
            return match word_of_item(document, offset, outline.body.start) {
                None => Region::Item,
                Some(word) => Region::Inside(outline, word),
            };
        }
    }
    Region::Outside
}

/// Returns the first word of the item that contains a byte; `None` at its beginning.
fn word_of_item(document: &Document, offset: usize, block: usize) -> Option<String> {
    let end = document
        .tokens
        .partition_point(|token| token.range.end < offset);
    let mut word = None;
    let before = document.tokens[..end].iter().rev();
    for token in before.filter(|token| !token.is_trivia()) {
        let text = token.text(&document.text);
        if token.range.start < block || token.kind == Kind::Mark && text == ";" {
            break;
        }
        word = Some(text.to_owned());
        // The item before may lack its `;`.
        if begins_item(&document.text, token) {
            break;
        }
    }
    word
}
