//! All words of the language by their vocabulary: one list for hovers, completions, colours and the
//! items of rust-analyzer.
//!
//! A vocabulary without a row here does not compile: `vocabulary!` needs its name in [`Vocabulary`],
//! and the functions of it match all names.

use super::generated::Sweep;
use super::types::{
    Degree, ElementKind, Ends, Function, Law, LengthUnit, MechanicsWord, MotionLawWord, MotionWord,
    Repeating,
};
use crate::syntax::{
    ClauseWord, DeclarationWord, ItemWord, JointKind, LinkClause, LinkQuantity, LinkedWord,
    LoadWord, MarkWord, SliderWord, Vocabulary, WheelsWord, Word,
};

/// The use of the words of a vocabulary.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WordClass {
    /// They begin an item of the struct block.
    Item,
    /// They are within an item, before a value or a name, or alone.
    Clause,
    /// They name a law of motion, or the ends of a course.
    Course,
    /// They are before parentheses, in any expression.
    Function,
    /// They are before parentheses, in functions of the `impl` block.
    Quantity,
    /// They are units.
    Unit,
    /// They follow a link and a dot.
    Member,
    /// They are in no text, or another vocabulary has the same words.
    Hidden,
}

/// A word and its meaning in a line of Markdown.
pub type WordRow = (&'static str, &'static str);

impl Vocabulary {
    /// Returns the use of its words.
    #[must_use]
    pub fn class(self) -> WordClass {
        match self {
            Vocabulary::DeclarationWord
            | Vocabulary::LoadWord
            | Vocabulary::LinkedWord
            | Vocabulary::JointKind => WordClass::Item,
            Vocabulary::ClauseWord
            | Vocabulary::LinkClause
            | Vocabulary::SliderWord
            | Vocabulary::WheelsWord
            | Vocabulary::MarkWord => WordClass::Clause,
            Vocabulary::Law | Vocabulary::Ends | Vocabulary::Degree | Vocabulary::Repeating => {
                WordClass::Course
            }
            Vocabulary::Function | Vocabulary::MotionLawWord => WordClass::Function,
            Vocabulary::MotionWord | Vocabulary::MechanicsWord => WordClass::Quantity,
            Vocabulary::LengthUnit => WordClass::Unit,
            Vocabulary::LinkQuantity => WordClass::Member,
            Vocabulary::ElementKind | Vocabulary::Sweep => WordClass::Hidden,
        }
    }

    /// Returns its words with their meanings, in the order in which messages list them.
    #[must_use]
    pub fn rows(self) -> Vec<WordRow> {
        match self {
            Vocabulary::DeclarationWord => rows::<DeclarationWord>(),
            Vocabulary::LoadWord => rows::<LoadWord>(),
            Vocabulary::LinkedWord => rows::<LinkedWord>(),
            Vocabulary::JointKind => rows::<JointKind>(),
            Vocabulary::ClauseWord => rows::<ClauseWord>(),
            Vocabulary::LinkClause => rows::<LinkClause>(),
            Vocabulary::SliderWord => rows::<SliderWord>(),
            Vocabulary::WheelsWord => rows::<WheelsWord>(),
            Vocabulary::MarkWord => rows::<MarkWord>(),
            Vocabulary::Law => rows::<Law>(),
            Vocabulary::Ends => rows::<Ends>(),
            Vocabulary::Degree => rows::<Degree>(),
            Vocabulary::Repeating => rows::<Repeating>(),
            Vocabulary::Function => rows::<Function>(),
            Vocabulary::MotionLawWord => rows::<MotionLawWord>(),
            Vocabulary::MotionWord => rows::<MotionWord>(),
            Vocabulary::MechanicsWord => rows::<MechanicsWord>(),
            Vocabulary::LengthUnit => rows::<LengthUnit>(),
            Vocabulary::LinkQuantity => rows::<LinkQuantity>(),
            Vocabulary::ElementKind => rows::<ElementKind>(),
            Vocabulary::Sweep => rows::<Sweep>(),
        }
    }
}

fn rows<W: Word>() -> Vec<WordRow> {
    W::all()
        .map(|word| (word.word(), word.description()))
        .collect()
}

/// Returns all words of a class with their meanings, each word once.
#[must_use]
pub fn words_of_class(class: WordClass) -> Vec<WordRow> {
    let of_class = Vocabulary::all().filter(|vocabulary| vocabulary.class() == class);
    let mut found: Vec<WordRow> = Vec::new();
    for row in of_class.flat_map(Vocabulary::rows) {
        if !found.iter().any(|(word, _)| *word == row.0) {
            found.push(row);
        }
    }
    found
}

/// Returns a word that has a meaning without parentheses after it: of items, of clauses or of courses.
/// The vocabulary of the item that contains it counts first, since some words are in several.
#[must_use]
pub fn plain_word(word: &str, item: Option<ItemWord>) -> Option<WordRow> {
    let first = item.and_then(clauses_of);
    let is_plain = |vocabulary: &Vocabulary| match vocabulary.class() {
        WordClass::Item | WordClass::Clause | WordClass::Course => true,
        WordClass::Function
        | WordClass::Quantity
        | WordClass::Unit
        | WordClass::Member
        | WordClass::Hidden => false,
    };
    let others = Vocabulary::all().filter(is_plain);
    let mut rows = first.into_iter().chain(others).flat_map(Vocabulary::rows);
    rows.find(|(candidate, _)| *candidate == word)
}

/// Returns the vocabulary of the clauses of an item, if it has any.
#[must_use]
pub fn clauses_of(item: ItemWord) -> Option<Vocabulary> {
    match item {
        ItemWord::Declaration(
            DeclarationWord::Body | DeclarationWord::Part | DeclarationWord::Input,
        )
        | ItemWord::Joint(_)
        | ItemWord::Load(_) => Some(Vocabulary::ClauseWord),
        ItemWord::Linked(LinkedWord::Link) => Some(Vocabulary::LinkClause),
        ItemWord::Linked(LinkedWord::Slider) => Some(Vocabulary::SliderWord),
        ItemWord::Linked(LinkedWord::Gears | LinkedWord::Belt) => Some(Vocabulary::WheelsWord),
        ItemWord::Declaration(
            DeclarationWord::Unit
            | DeclarationWord::Const
            | DeclarationWord::Param
            | DeclarationWord::Unknown
            | DeclarationWord::Let
            | DeclarationWord::Loop
            | DeclarationWord::Argument
            | DeclarationWord::Gravity
            | DeclarationWord::Arc,
        )
        | ItemWord::Linked(LinkedWord::Joint | LinkedWord::Weld) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_item_gives_a_word_its_meaning() {
        let meaning =
            |word, item| plain_word(word, ItemWord::from_word(item)).map(|(_, text)| text);
        assert_ne!(meaning("at", "link"), meaning("at", "slider"));
        assert_ne!(meaning("at", "link"), meaning("at", "force"));
        assert_eq!(
            meaning("quintic", "let"),
            Some("Four derivatives are continuous.")
        );
        assert_eq!(meaning("polar", "let"), None);
    }

    #[test]
    fn a_class_has_each_word_once() {
        let clauses = words_of_class(WordClass::Clause);
        let count = |wanted: &str| clauses.iter().filter(|(word, _)| *word == wanted).count();
        assert_eq!(count("at"), 1);
        assert_eq!(count("teeth"), 1);
        assert_eq!(count("frame"), 1);
    }
}
