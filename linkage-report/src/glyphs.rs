//! Words that pictures and pages can show.

use std::format;
use std::string::String;
use std::vec::Vec;

use super::builder::Report;
use super::summary;
use linkage_formats::Mistake;
use linkage_formats::characters::control;

pub(super) fn check_words(report: &Report, mistakes: &mut Vec<Mistake>) {
    let of = |what: &str, words: &str| control(what, words);
    mistakes.extend(of("the title", &report.title));
    mistakes.extend(of("the text below the title", &report.about));
    let index = report.index.as_ref();
    mistakes.extend(index.and_then(|title| of("the title of the index", title)));
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
