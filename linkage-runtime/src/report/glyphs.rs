//! Words that pictures and pages can show.

use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use super::Mistake;
use super::builder::Report;
use super::summary;

/// Returns the first character that neither XML nor HTML can show, such as a control character.
/// Line ends and tabs are spaces there.
pub(super) fn control(what: &str, words: &str) -> Option<Mistake> {
    let is_shown = |c: char| matches!(c, '\t' | '\n' | '\r') || !c.is_control();
    let is_character = |c: char| u32::from(c) & 0xFFFE != 0xFFFE;
    let (at, character) = words
        .char_indices()
        .find(|&(_, c)| !is_shown(c) || !is_character(c))?;
    Some(Mistake::Control {
        what: what.to_string(),
        before: words[..at].to_string(),
        character,
    })
}

pub(super) fn check_words(report: &Report, mistakes: &mut Vec<Mistake>) {
    let of = |what: &str, words: &str| control(what, words);
    mistakes.extend(of("the title", &report.title));
    mistakes.extend(of("the text below the title", &report.about));
    for (index, note) in report.notes.iter().enumerate() {
        mistakes.extend(of(&format!("note {index}"), note));
    }
    for (index, fact) in report.facts.iter().enumerate() {
        mistakes.extend(of(&format!("the name of fact {index}"), &fact.name));
        mistakes.extend(of(&format!("fact {index}"), &fact.text));
    }
    for (index, row) in summary::summary_rows(report).iter().enumerate() {
        let words: [&String; 3] = [&row.quantity, &row.what, &row.unit];
        mistakes.extend(
            words
                .into_iter()
                .find_map(|words| of(&format!("row {index} of the summary"), words)),
        );
    }
}
