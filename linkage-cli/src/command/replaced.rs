//! Refusal to write over a mechanism.

use std::fs;
use std::path::{Path, PathBuf};

use linkage_engine::Source;
use proc_macro2::{Delimiter, TokenStream, TokenTree};

use crate::failure::Failure;

/// No mechanism is as long. A longer file is not read before it is replaced.
const LONGEST: u64 = 1 << 24;

/// Files that a page may have.
const OF_A_PAGE: [&str; 6] = ["html", "json", "csv", "svg", "dxf", "js"];

/// Refuses a file to write to that is the file that is read, or holds a mechanism.
pub(super) fn refuse_mechanism(output: &Path, input: &Path) -> Result<(), Failure> {
    let why = if is_same(output, input) {
        "it is the file with the mechanism that is read"
    } else if has_ending(output, &["mech"]) {
        "its ending is that of files with mechanisms"
    } else if holds_mechanism(output) {
        "there is a mechanism in it"
    } else {
        return Ok(());
    };
    Err(refused(output, why))
}

/// Refuses a folder for a page that has the name of a mechanism, or in which the page can replace
/// the file that is read.
pub(super) fn refuse_page(folder: &Path, input: &Path) -> Result<(), Failure> {
    if has_ending(folder, &["mech"]) {
        return refuse_mechanism(folder, input);
    }
    let [inner, outer] = [input, folder].map(|path| fs::canonicalize(path).ok());
    match inner.zip(outer) {
        Some((inner, outer)) if inner.starts_with(&outer) && has_ending(&inner, &OF_A_PAGE) => {
            Err(refused(
                input,
                "it is the file with the mechanism that is read, and pages have files of such names",
            ))
        }
        _ => Ok(()),
    }
}

fn refused(output: &Path, why: &str) -> Failure {
    Failure::Told(format!(
        "cannot write `{}`: {why}\nhelp: give another name after `-o`",
        output.display()
    ))
}

fn has_ending(path: &Path, endings: &[&str]) -> bool {
    let ending = path.extension().and_then(|ending| ending.to_str());
    ending.is_some_and(|ending| {
        endings
            .iter()
            .any(|other| ending.eq_ignore_ascii_case(other))
    })
}

/// Returns true if two names are of one file, also through links.
fn is_same(a: &Path, b: &Path) -> bool {
    let canonical = |path: &Path| -> Option<PathBuf> { fs::canonicalize(path).ok() };
    let same = canonical(a).zip(canonical(b)).is_some_and(|(a, b)| a == b);
    #[cfg(unix)]
    let same = same || {
        use std::os::unix::fs::MetadataExt;
        let number = |path: &Path| fs::metadata(path).ok().map(|data| (data.dev(), data.ino()));
        number(a).is_some_and(|first| number(b) == Some(first))
    };
    same
}

/// Returns true if a file has a call of `mechanism!`, or the content of one: a struct with items of
/// a mechanism, with mistakes or without.
fn holds_mechanism(path: &Path) -> bool {
    let short = fs::metadata(path).is_ok_and(|data| data.is_file() && data.len() <= LONGEST);
    let text = short.then(|| fs::read_to_string(path).ok()).flatten();
    let Some(text) = text.filter(|text| text.contains("struct")) else {
        return false;
    };
    let Ok(source) = Source::new(&path.display().to_string(), &text) else {
        return false;
    };
    // All of a file that is not Rust is taken for a call.
    let mut calls = source.calls().iter();
    calls.any(|found| !found.range.is_empty() || has_mechanism(&found.tokens))
}

/// `struct NAME { unit mm; ... }`
fn has_mechanism(tokens: &TokenStream) -> bool {
    let tokens: Vec<TokenTree> = tokens.clone().into_iter().collect();
    tokens.windows(3).any(|three| match three {
        [
            TokenTree::Ident(word),
            TokenTree::Ident(_),
            TokenTree::Group(body),
        ] => word == "struct" && body.delimiter() == Delimiter::Brace && has_items(body.stream()),
        _ => false,
    })
}

/// Returns true if one of the items is one that every mechanism has.
fn has_items(body: TokenStream) -> bool {
    let mut begins = true;
    body.into_iter().any(|token| {
        let word = match &token {
            TokenTree::Ident(word) if begins => {
                ["unit", "param", "input", "unknown", "loop", "part"]
                    .iter()
                    .any(|reserved| word == reserved)
            }
            _ => false,
        };
        begins = match &token {
            TokenTree::Punct(mark) => matches!(mark.as_char(), ';' | '#'),
            // Attributes and comments stand before an item.
            TokenTree::Group(group) => begins && group.delimiter() == Delimiter::Bracket,
            _ => false,
        };
        word
    })
}
