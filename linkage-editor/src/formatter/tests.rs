//! Texts of the repository before and after formatting.

use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};

use super::formatted;

/// All files with mechanisms of the repository.
fn files() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"))
        .parent()
        .expect("the repository");
    let mut folders = vec![root.to_owned()];
    let mut files = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder").flatten() {
            let path = entry.path();
            let is_built = path.ends_with("target") || path.ends_with("node_modules");
            if path.is_dir() && !is_built && !path.ends_with(".git") {
                folders.push(path);
            } else if path.extension().is_some_and(|ending| ending == "mech") {
                files.push(path);
            }
        }
    }
    assert!(files.len() > 60, "{} files", files.len());
    files
}

/// The tokens of a text, with the marks that belong together. Doc comments are attributes, whose
/// first blank may be added.
fn flattened(tokens: TokenStream, into: &mut Vec<String>) {
    for token in tokens {
        match token {
            TokenTree::Group(group) => {
                let (open, close) = match group.delimiter() {
                    Delimiter::Parenthesis => ("(", ")"),
                    Delimiter::Brace => ("{", "}"),
                    Delimiter::Bracket => ("[", "]"),
                    Delimiter::None => ("", ""),
                };
                into.push(open.to_owned());
                flattened(group.stream(), into);
                into.push(close.to_owned());
            }
            TokenTree::Punct(mark) => {
                let joint = mark.as_char() == '+' && mark.spacing() == Spacing::Joint;
                into.push(format!("{mark}{}", if joint { "_" } else { "" }));
            }
            TokenTree::Literal(literal) => into.push(literal.to_string().replace("\" ", "\"")),
            TokenTree::Ident(word) => into.push(word.to_string()),
        }
    }
}

fn all_tokens(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    flattened(text.parse().expect("tokens"), &mut found);
    found
}

fn comments(text: &str) -> Vec<String> {
    let all = crate::lexer::tokens(text);
    let comments = all
        .iter()
        .filter(|token| token.text(text).starts_with("//"));
    comments
        .map(|token| token.text(text).trim_start_matches('/').trim().to_owned())
        .collect()
}

#[test]
fn tokens_and_comments_stay_and_formatted_texts_too() {
    for path in files() {
        let text = fs::read_to_string(&path).expect("a file");
        let once = formatted(&text).unwrap_or_else(|| panic!("{}", path.display()));
        assert_eq!(all_tokens(&text), all_tokens(&once), "{}", path.display());
        assert_eq!(comments(&text), comments(&once), "{}", path.display());
        assert_eq!(formatted(&once).as_ref(), Some(&once), "{}", path.display());
        // Without any blank that could go, and with blanks everywhere.
        let squeezed = all_on_one_line(&text);
        let again = formatted(&squeezed).expect("tokens");
        assert_eq!(
            all_tokens(&squeezed),
            all_tokens(&again),
            "{}",
            path.display()
        );
        assert_eq!(formatted(&again), Some(again.clone()), "{}", path.display());
    }
}

/// A text without comments on one line.
fn all_on_one_line(text: &str) -> String {
    let all = crate::lexer::tokens(text);
    let kept = all.iter().map(|token| match token.is_trivia() {
        true => " ",
        false => token.text(text),
    });
    kept.collect()
}

#[test]
fn templates_are_formatted() {
    let templates = files().into_iter();
    for path in templates.filter(|path| {
        path.parent()
            .is_some_and(|folder| folder.ends_with("templates"))
    }) {
        let text = fs::read_to_string(&path).expect("a file");
        assert_eq!(formatted(&text).as_ref(), Some(&text), "{}", path.display());
    }
}

#[test]
fn blanks_follow_the_rules() {
    for (text, expected) in [
        (
            "loop  a+polar( -b , - c )=(d ,0);",
            "loop a + polar(-b, -c) = (d, 0);",
        ),
        ("param a=-2mm+-0.1mm;", "param a = -2mm +- 0.1mm;"),
        ("param a = 2mm +/- 0.1mm;", "param a = 2mm +/- 0.1mm;"),
        ("gravity=(0,-9.81m/s^2);", "gravity = (0, -9.81m/s^2);"),
        ("let a=b*-c/d-e;", "let a = b * -c / d - e;"),
        (
            "input a=1mm in - 2mm .. 3mm at s ,b;",
            "input a = 1mm in -2mm..3mm at s, b;",
        ),
        (
            "spring 2N/mm from a at(0,0) to b at p.x;",
            "spring 2N/mm from a at (0, 0) to b at p.x;",
        ),
        (
            "link a :b ,c=( 1mm,2mm ) at - phi;",
            "link a: b, c = (1mm, 2mm) at -phi;",
        ),
    ] {
        let whole = formatted(&format!("struct A {{{text}}}")).expect("tokens");
        assert_eq!(whole, format!("struct A {{\n    {expected}\n}}\n"));
    }
}

#[test]
fn brackets_without_partners_are_left_alone() {
    for text in ["struct A { ", "struct A { let a = (1]; }", "struct A { ° }"] {
        assert_eq!(formatted(text), None, "{text}");
    }
}

/// A comment of which one stroke is left begins with a mark.
#[test]
fn a_text_may_begin_with_a_mark() {
    for mark in "+-*/^=<>:;,.?!&|#".chars() {
        for rest in ["", " a", "a", " 2mm", "2mm", "(a)", "-a", "mm*mm"] {
            let text = format!("{mark}{rest}");
            let once = formatted(&text).expect("tokens");
            assert_eq!(all_tokens(&text), all_tokens(&once), "{text}");
        }
    }
    assert_eq!(formatted("/ A crank").as_deref(), Some("/ A crank\n"));
}

#[test]
fn ends_of_lines_are_those_of_the_text() {
    let text = "struct A {\r\n    unit mm; // a\r\n}\r\n";
    let once = formatted(text).expect("tokens");
    assert_eq!(once.matches("\r\n").count(), once.matches('\n').count());
    assert_eq!(formatted(&once), Some(once.clone()));
}
