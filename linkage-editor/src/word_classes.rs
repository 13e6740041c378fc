//! The words of the language by their use, for editors that colour a text without reading it.

use linkage_language::model::{WordClass, words_of_class};
use linkage_language::syntax::unit_names;

/// The words of the language by their use. A word can have several uses.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WordClasses {
    /// They begin an item of the struct block, or a block.
    pub items: Vec<&'static str>,
    /// They are within an item.
    pub clauses: Vec<&'static str>,
    /// They name laws of motion and ends of courses.
    pub courses: Vec<&'static str>,
    /// They are before parentheses in expressions.
    pub functions: Vec<&'static str>,
    /// They are before parentheses in functions of a mechanism.
    pub quantities: Vec<&'static str>,
    /// They follow a number.
    pub units: Vec<&'static str>,
    /// They follow a link and a dot.
    pub members: Vec<&'static str>,
}

/// Returns all words of the language, each once in a class.
#[must_use]
pub fn word_classes() -> WordClasses {
    let words = |class| words_of_class(class).into_iter().map(|(word, _)| word);
    let blocks = ["pub", "struct", "impl", "fn"];
    WordClasses {
        items: blocks.into_iter().chain(words(WordClass::Item)).collect(),
        clauses: words(WordClass::Clause).collect(),
        courses: words(WordClass::Course).collect(),
        functions: words(WordClass::Function).collect(),
        quantities: words(WordClass::Quantity).collect(),
        units: unit_names().collect(),
        members: words(WordClass::Member).collect(),
    }
}
