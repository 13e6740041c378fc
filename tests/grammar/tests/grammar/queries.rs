//! The queries of editors: each can be used with the parser, and colours are those of the words.

use linkage_grammar::{Captures, read};

const TEXT: &str = "/// A drive.
pub struct Drive {
    unit mm;
    param link = 40mm +- 10um;                // a length
    input phi = 30deg in 0deg..360deg at omega;
    let way = rise(phi, poly345) * polar(link, phi) / PI;
    damper 0.1N*s/m on way;
    link frame: a, d;
}
impl Drive { pub fn motion(phi) -> Motion { way, v: velocity(way.x) } }
";

/// Queries of an editor, by the names of their files.
fn queries(editor: &str, names: &[&str]) -> Vec<(String, String)> {
    let path = |name: &&str| format!("editors/{editor}/queries/linkage/{name}.scm");
    let pairs = names
        .iter()
        .map(|name| ((*name).to_owned(), read(&path(name))));
    pairs.collect()
}

#[test]
fn every_query_finds_something() {
    let shared = [
        "highlights",
        "indents",
        "injections",
        "locals",
        "tags",
        "textobjects",
    ];
    let neovim = queries("neovim", &[&shared[..], &["folds"]].concat());
    for (name, query) in neovim.iter().chain(&queries("helix", &shared)) {
        let names = query
            .split_whitespace()
            .filter_map(|word| word.strip_prefix('@'));
        let names = names.map(|name| name.trim_matches(|letter| "()[]".contains(letter)));
        let captures = Captures::of(query, TEXT);
        let found = names.filter(|name| !captures.all(name).is_empty()).count();
        assert!(found > 0, "{name}");
    }
}

#[test]
fn words_have_their_colours() {
    for (editor, number, part) in [
        ("neovim", "number", "property"),
        ("helix", "constant.numeric", "variable.other.member"),
    ] {
        let query = &queries(editor, &["highlights"])[0].1;
        let captures = Captures::of(query, TEXT);
        for (text, expected) in [
            ("/// A drive.", "comment"),
            ("struct", "keyword"),
            ("Drive", "type"),
            ("mm", "type.builtin"),
            ("phi", "variable.parameter"),
            ("10um", number),
            ("+-", "operator"),
            ("rise", "function.builtin"),
            ("poly345", "constant.builtin"),
            ("polar", "function.builtin"),
            ("PI", "constant.builtin"),
            ("s", "type.builtin"),
            ("m", "type.builtin"),
            ("frame", "variable.builtin"),
            ("// a length", "comment"),
            ("motion", "function"),
            ("x", part),
            ("velocity", "function.builtin"),
            ("}", "punctuation.bracket"),
        ] {
            let found = captures.last_of(text).unwrap_or_default();
            assert!(found.starts_with(expected), "{editor}, {text}: {found}");
        }
        // A word of the language is a name where it is one.
        let keywords = captures.all("keyword");
        assert_eq!(keywords.iter().filter(|word| **word == "link").count(), 1);
        assert!(captures.all("variable.parameter").contains(&"link"));
    }
}
