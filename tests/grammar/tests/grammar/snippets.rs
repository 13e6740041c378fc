//! Snippets of VS Code: the compiler reads them as they are inserted, and so does the parser.

use linkage_grammar::{faults, read};
use linkage_language::diagnostic::Diagnostics;
use linkage_language::syntax::parse;
use serde_json::Value;

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
