//! A word of the language is a word of every grammar.

use linkage_grammar::{kinds_of_words, quoted, read};
use linkage_language::model::{
    Ends, Function, Law, MotionLawWord, QuantityWord, WordClass, words_of_class,
};
use linkage_language::syntax::{JointKind, Word, unit_names};
use serde_json::Value;

const TEXTMATE: &str = "editors/vscode/syntaxes/linkage.tmLanguage.json";
const HIGHLIGHTS: [&str; 2] = [
    "editors/neovim/queries/linkage/highlights.scm",
    "editors/helix/queries/linkage/highlights.scm",
];

fn words<W: Word>() -> Vec<String> {
    W::all().map(|word| word.word().to_owned()).collect()
}

fn of_class(class: WordClass) -> Vec<String> {
    let rows = words_of_class(class).into_iter();
    rows.map(|(word, _)| word.to_owned()).collect()
}

fn items() -> Vec<String> {
    of_class(WordClass::Item)
}

fn units() -> Vec<String> {
    unit_names().map(str::to_owned).collect()
}

/// Words of items and of functions are all that Emacs has colours for.
const EMACS: &str = "editors/emacs/linkage-mode.el";

/// The words of clauses.
fn clauses() -> Vec<String> {
    of_class(WordClass::Clause)
}

fn assert_has(grammar: &str, present: &[String], wanted: &[String]) {
    let missing: Vec<&String> = wanted
        .iter()
        .filter(|word| !present.contains(word))
        .collect();
    assert!(missing.is_empty(), "{grammar} lacks {missing:?}");
}

#[test]
fn the_parser_has_all_words() {
    let present = kinds_of_words();
    // The frame is a name like those of other links.
    let clauses = clauses().into_iter().filter(|word| word != "frame");
    for wanted in [items(), units(), clauses.collect(), words::<JointKind>()] {
        assert!(wanted.len() > 4, "{wanted:?}");
        assert_has("the parser", &present, &wanted);
    }
}

#[test]
fn the_colours_have_all_words() {
    for path in HIGHLIGHTS {
        let query = read(path);
        let present: Vec<String> = quoted(&query).into_iter().map(str::to_owned).collect();
        // Words of pairs are nodes with one name.
        let pairs = words::<JointKind>();
        let items = items().into_iter().filter(|item| !pairs.contains(item));
        assert_has(path, &present, &items.collect::<Vec<_>>());
        for wanted in [
            clauses(),
            words::<Function>(),
            words::<MotionLawWord>(),
            words::<QuantityWord>(),
            words::<Law>(),
            words::<Ends>(),
        ] {
            assert_has(path, &present, &wanted);
        }
    }
}

#[test]
fn the_mode_of_emacs_has_its_words() {
    let mode = read(EMACS);
    let present: Vec<String> = quoted(&mode).into_iter().map(str::to_owned).collect();
    for wanted in [
        items(),
        words::<Function>(),
        words::<MotionLawWord>(),
        words::<QuantityWord>(),
    ] {
        assert_has(EMACS, &present, &wanted);
    }
}

/// Collects the words of all patterns of a grammar.
fn words_of_patterns(grammar: &Value, words: &mut Vec<String>) {
    match grammar {
        Value::Object(fields) => {
            for (name, value) in fields {
                match (name.as_str(), value.as_str()) {
                    ("match", Some(pattern)) => words.extend(words_of_pattern(pattern)),
                    _ => words_of_patterns(value, words),
                }
            }
        }
        Value::Array(entries) => {
            for entry in entries {
                words_of_patterns(entry, words);
            }
        }
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => {}
    }
}

/// Returns the words of a pattern, without its signs for kinds of letters.
fn words_of_pattern(pattern: &str) -> Vec<String> {
    let mut letters = pattern.chars();
    let mut plain = String::new();
    while let Some(letter) = letters.next() {
        match letter {
            '\\' => plain.extend(letters.next().map(|_| ' ')),
            letter => plain.push(letter),
        }
    }
    let words = plain.split(|letter: char| !letter.is_alphanumeric() && letter != '_');
    words.map(str::to_owned).collect()
}

#[test]
fn the_grammar_of_textmate_has_all_words() {
    let grammar = serde_json::from_str(&read(TEXTMATE)).expect("a grammar in JSON");
    let mut present = Vec::new();
    words_of_patterns(&grammar, &mut present);
    for wanted in [
        items(),
        units(),
        clauses(),
        words::<JointKind>(),
        words::<Function>(),
        words::<MotionLawWord>(),
        words::<QuantityWord>(),
        words::<Law>(),
        words::<Ends>(),
    ] {
        assert_has(TEXTMATE, &present, &wanted);
    }
}
