//! The grammars of editors against the texts and the words of the language.

mod words;

use linkage_grammar::{Captures, Text, faults, mechanism_files, read, rust_macros, samples, tree};
use linkage_language::diagnostic::Diagnostics;
use linkage_language::syntax::parse;
use serde_json::Value;

// The trees of `test/corpus`, which `tree-sitter test` compares, too.

const FILES: [&str; 4] = ["blocks", "comments", "expressions", "items"];

/// The line before and after a title.
const LINE: &str = "========================================\n";

/// Returns title, text and tree of each case of a file.
fn cases(file: &str) -> Vec<(&str, &str, String)> {
    let parts: Vec<&str> = file.split(LINE).skip(1).collect();
    let pairs = parts.chunks(2).map(|pair| (pair[0].trim(), pair[1]));
    let cases = pairs.map(|(title, rest)| {
        let (text, tree) = rest.split_once("\n---\n").expect("a text and a tree");
        let tree: Vec<&str> = tree.split_whitespace().collect();
        (title, text, tree.join(" "))
    });
    cases.collect()
}

#[test]
fn trees_are_those_of_the_corpus() {
    let mut count = 0;
    for name in FILES {
        let file = read(&format!(
            "editors/tree-sitter-linkage/test/corpus/{name}.txt"
        ));
        for (title, text, expected) in cases(&file) {
            let found = tree(text).root_node().to_sexp();
            assert_eq!(found, expected, "{name}: {title}");
            count += 1;
        }
    }
    assert_eq!(count, 16);
}

// The parser reads every text that the compiler reads.

fn assert_readable(texts: &[Text], at_least: usize) {
    assert!(texts.len() >= at_least, "{} texts", texts.len());
    let faults = texts.iter().flat_map(|text| {
        let faults = faults(&text.text).into_iter();
        faults.map(|fault| format!("{}, line {fault}", text.name))
    });
    let faults: Vec<String> = faults.collect();
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

#[test]
fn text_files_are_read() {
    assert_readable(&mechanism_files(), 70);
}

#[test]
fn macros_are_read() {
    assert_readable(&rust_macros("mechanisms"), 30);
}

#[test]
fn samples_of_documents_are_read() {
    assert_readable(&samples("docs"), 80);
}

#[test]
fn a_fault_has_its_line() {
    let found = faults("struct M {\n    param a = ;\n    unit mm;\n}\n");
    assert_eq!(found, ["2: param a = ;"]);
    assert_eq!(faults("struct M { param a 5mm; }").len(), 1);
    assert_eq!(faults("struct M { unit mm; /* }").len(), 1);
}

// Snippets of VS Code: the compiler reads them as they are inserted, and so does the parser.

/// Returns a snippet with the texts that it proposes: `${1:crank}` is `crank`, `$0` nothing.
fn filled(snippet: &str) -> String {
    let mut parts = snippet.split('$');
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (proposed, rest) = match part.strip_prefix('{') {
            Some(stop) => {
                let (stop, rest) = stop.split_once('}').expect("the end of a stop");
                (stop.split_once(':').expect("a proposed text").1, rest)
            }
            None => (
                "",
                part.trim_start_matches(|digit: char| digit.is_ascii_digit()),
            ),
        };
        text.push_str(proposed);
        text.push_str(rest);
    }
    text
}

/// Returns a snippet as a whole text: an item in a struct block, a function in an `impl` block.
fn whole(snippet: &str) -> String {
    if snippet.contains("struct ") {
        return snippet.to_owned();
    }
    if snippet.contains("pub fn ") {
        return format!("struct M {{ unit mm; }}\nimpl M {{\n{snippet}\n}}\n");
    }
    format!("struct M {{\n{snippet}\n}}\n")
}

#[test]
fn snippets_are_texts_of_the_language() {
    let file = read("editors/vscode/snippets/linkage.json");
    let snippets: Value = serde_json::from_str(&file).expect("snippets in JSON");
    let snippets = snippets.as_object().expect("snippets by their names");
    assert!(snippets.len() >= 20);
    for (name, snippet) in snippets {
        let lines = snippet["body"].as_array().expect("lines");
        let lines = lines.iter().map(|line| line.as_str().expect("a line"));
        let text = whole(&filled(&lines.collect::<Vec<_>>().join("\n")));
        let mut diagnostics = Diagnostics::default();
        parse(text.parse().expect("tokens"), &mut diagnostics);
        assert_eq!(diagnostics.texts(), Vec::<String>::new(), "{name}: {text}");
        assert_eq!(faults(&text), Vec::<String>::new(), "{name}");
    }
}

#[test]
fn stops_are_filled() {
    assert_eq!(
        filled("param ${1:a} = ${2:(1mm, 2mm)};$0"),
        "param a = (1mm, 2mm);"
    );
}

// The queries of editors: each can be used with the parser, and colours are those of the words.

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
