//! The analysis of a text after each key: messages, and the data of the pages.

use linkage_compiler::check_all;
use linkage_engine::{Mechanism, Source, SourceError};
use serde_json::{Value, json};

use crate::messages::messages;
use crate::page::{Page, page};
use crate::positions::Positions;

/// The file that messages name.
pub(crate) const FILE: &str = "mechanism.mech";

/// Returns lines of JSON: the messages about a text with the names of the mechanisms that have a
/// page, then for each of them the data of its report, and its programs.
pub(crate) fn analysis(text: &str) -> String {
    let source = match Source::new(FILE, text) {
        Ok(source) => source,
        Err(error) => return finished(vec![unread(text, &error)], &[]),
    };
    let positions = Positions::new(source.text());
    let mut found = Vec::new();
    let mut pages = Vec::new();
    for call in source.calls() {
        for checked in check_all(call.tokens.clone()) {
            found.extend(messages(&checked, call, &positions));
            let shown = Mechanism::new(&checked).map(|mechanism| page(&source, mechanism));
            match shown {
                Some(Ok(page)) => pages.push(page),
                Some(Err(note)) => found.push(note_of(call.range.start, &note)),
                None => {}
            }
        }
    }
    finished(found, &pages)
}

fn finished(messages: Vec<Value>, pages: &[Page]) -> String {
    let names: Vec<&str> = pages.iter().map(|page| page.name).collect();
    let first = json!({ "messages": messages, "names": names }).to_string();
    let pages = pages
        .iter()
        .flat_map(|page| [&page.report[..], &page.programs]);
    let lines: Vec<&str> = [&first[..]].into_iter().chain(pages).collect();
    lines.join("\n")
}

fn note_of(start: usize, note: &str) -> Value {
    json!({ "from": start, "to": start, "severity": "info", "text": note })
}

/// The message about a text that is no sequence of tokens.
fn unread(text: &str, error: &SourceError) -> Value {
    let (from, to) = (0, text.encode_utf16().count());
    let text = error.to_string();
    json!({ "from": from, "to": to, "severity": "error", "text": text })
}
