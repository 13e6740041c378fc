//! A word of the language is a word of every grammar.

use linkage_grammar::{kinds_of_words, listed_by_message, quoted, read};
use linkage_language::model::{Ends, Function, Law, MotionLawWord, QuantityWord};
use linkage_language::syntax::{JointKind, Word};

const HIGHLIGHTS: [&str; 2] = [
    "editors/neovim/queries/linkage/highlights.scm",
    "editors/helix/queries/linkage/highlights.scm",
];

fn words<W: Word>() -> Vec<String> {
    W::all().map(|word| word.word().to_owned()).collect()
}

fn items() -> Vec<String> {
    listed_by_message("struct M { 5 }", "items are ")
}

fn units() -> Vec<String> {
    listed_by_message("struct M { param a = 5foo; }", "units are ")
}

/// The words of clauses.
fn clauses() -> Vec<String> {
    let mistakes = [
        (
            "slide a = b on c at d, wound b",
            "clauses of a `slide` joint are ",
        ),
        ("link a: b, c wound b", "clauses of a link are "),
        (
            "body a = cylinder on b at c, wound b",
            "clauses of a body on a `cylinder` joint are ",
        ),
        ("spring k on a, wound b", "clauses of a spring are "),
        ("force k on a, wound b", "clauses of a force are "),
        ("part a: B {} wound b", "clauses of a part are "),
    ];
    let mistakes = mistakes
        .iter()
        .flat_map(|(item, before)| listed_by_message(&format!("struct M {{ {item}; }}"), before));
    mistakes.collect()
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
    for wanted in [items(), units(), clauses(), words::<JointKind>()] {
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
