//! The analysis of a text after each key: messages, and the data of the pages.

use linkage_compiler::{Checked, check_all};
use linkage_engine::{Mechanism, Source};
use linkage_page::with_drawings;
use proc_macro2::TokenStream;
use serde_json::{Value, json};

use crate::document::{FILE, messages, pass};
use crate::page::{Page, page};

/// The result of compiling a text.
#[derive(Default)]
struct Compiled {
    pages: Vec<Page>,
    /// Remarks about mechanisms without a page.
    notes: Vec<String>,
    /// True if the compiler has neither mistakes nor warnings.
    is_plain: bool,
}

/// Returns lines of JSON: the messages about a text with the names of the mechanisms that have a
/// page, then for each of them the data of its report, and its programs.
pub(crate) fn analysis(text: &str) -> String {
    let compiled = compiled(text);
    let mut messages = match compiled.is_plain {
        true => {
            pass();
            Vec::new()
        }
        false => messages(text),
    };
    messages.extend(compiled.notes.iter().map(|note| remark(note)));
    finished(&messages, &compiled.pages)
}

fn compiled(text: &str) -> Compiled {
    let Ok(source) = Source::new(FILE, text) else {
        return Compiled::default();
    };
    let mut compiled = Compiled {
        is_plain: true,
        ..Compiled::default()
    };
    for call in source.calls() {
        for checked in checked_with_drawings(&call.tokens) {
            compiled.is_plain &= checked.messages.is_empty() && checked.warnings.is_empty();
            // Its motion shows where a range is refused.
            let Some(mechanism) = Mechanism::new(&checked.in_any_range()) else {
                continue;
            };
            match page(&source, mechanism) {
                Ok(page) => compiled.pages.push(page),
                Err(note) => compiled.notes.push(note),
            }
        }
    }
    compiled
}

/// The mechanisms of a call, with functions for missing drawings unless these are refused. The page
/// needs such a function, and a second compilation would take as long as the first one.
fn checked_with_drawings(tokens: &TokenStream) -> Vec<Checked> {
    let drawn = with_drawings(tokens).map(check_all);
    let drawn = drawn.filter(|drawn| drawn.iter().all(|checked| checked.messages.is_empty()));
    drawn.unwrap_or_else(|| check_all(tokens.clone()))
}

/// The answer. Data of pages are JSON already.
fn finished(messages: &[Value], pages: &[Page]) -> String {
    let names: Vec<&str> = pages.iter().map(|page| page.name).collect();
    let first = json!({ "messages": messages, "names": names }).to_string();
    let pages = pages
        .iter()
        .flat_map(|page| [&page.report[..], &page.programs]);
    let lines: Vec<&str> = [&first[..]].into_iter().chain(pages).collect();
    lines.join("\n")
}

fn remark(note: &str) -> Value {
    json!({ "from": 0, "to": 0, "severity": "info", "text": note, "fixes": [] })
}
