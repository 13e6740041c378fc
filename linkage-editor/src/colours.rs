//! The words of a text by their meaning, for colours.

use std::ops::Range;

use linkage_language::model::{CalledWord, WordClass, plain_word, words_of_class};
use linkage_language::syntax::Word;

use crate::context::next_solid;
use crate::declaration::NameKind;
use crate::document::Document;
use crate::lexer::Kind;

/// A word with its meaning.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ColouredWord {
    /// The word.
    pub range: Range<usize>,
    /// Its meaning.
    pub colour: Colour,
}

/// The meaning of a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Colour {
    /// A word of the language.
    Keyword,
    /// A comment.
    Comment,
    /// A number without its unit.
    Number,
    /// A unit.
    Unit,
    /// A function or quantity.
    Function,
    /// A declared name.
    Name(NameKind),
}

/// Returns the words of a text with their meanings, in order. Marks, brackets and unknown words
/// are left out.
pub(crate) fn words(document: &Document) -> Vec<ColouredWord> {
    let mut found = Vec::new();
    let mut add = |range: Range<usize>, colour| {
        if !range.is_empty() {
            found.push(ColouredWord { range, colour });
        }
    };
    let mut uses = document.uses.iter().peekable();
    for (index, token) in document.tokens.iter().enumerate() {
        let text = token.text(&document.text);
        match token.kind {
            Kind::Comment | Kind::Documentation => add(token.range.clone(), Colour::Comment),
            Kind::Number => {
                let unit = text.trim_end_matches(char::is_alphabetic).len();
                let middle = token.range.start + unit;
                add(token.range.start..middle, Colour::Number);
                add(middle..token.range.end, Colour::Unit);
            }
            Kind::Word => {
                while uses
                    .next_if(|found| found.range.start < token.range.start)
                    .is_some()
                {}
                let declared = uses.peek().filter(|found| found.range == token.range);
                let colour = match declared {
                    Some(found) => Some(Colour::Name(document.named(found.symbol).2)),
                    None => colour(text, next_solid(document, index) == "("),
                };
                if let Some(colour) = colour {
                    add(token.range.clone(), colour);
                }
            }
            Kind::Blank | Kind::Text | Kind::Open | Kind::Close | Kind::Mark | Kind::Unknown => {}
        }
    }
    found
}

/// Words that begin a block and are part of no list with meanings.
const BLOCKS: [&str; 4] = ["pub", "struct", "impl", "fn"];

/// Returns the words of the language with their colours. A function is one only before an opening
/// parenthesis, and may be a keyword elsewhere.
#[must_use]
pub fn language_words() -> Vec<(&'static str, Colour)> {
    let plain = [WordClass::Item, WordClass::Clause, WordClass::Course];
    let plain = plain.into_iter().flat_map(words_of_class);
    let keywords = BLOCKS.into_iter().chain(plain.map(|(word, _)| word));
    let keywords = keywords.map(|word| (word, Colour::Keyword));
    let functions = CalledWord::all().map(|word| (word.word(), Colour::Function));
    keywords.chain(functions).collect()
}

/// Returns the meaning of a word that is no declared name.
fn colour(word: &str, is_called: bool) -> Option<Colour> {
    if is_called && CalledWord::from_word(word).is_some() {
        return Some(Colour::Function);
    }
    let is_keyword = BLOCKS.contains(&word) || plain_word(word, None).is_some();
    is_keyword.then_some(Colour::Keyword)
}
