//! Terms that a loop lacks: offers for a loop that its unknowns cannot close.

use std::ops::Range;

use linkage_language::syntax::{DeclarationWord, MarkWord, Word};

use crate::diagnostics::{Diagnostic, Edit, Fix, Severity};
use crate::document::Document;
use crate::outline::Outline;
use crate::statements::statements;

/// Names for unknown angles and lengths, in the order in which they are taken.
const ANGLES: [&str; 4] = ["theta", "psi", "chi", "delta"];
const LENGTHS: [&str; 4] = ["length", "reach", "travel", "stretch"];

/// Returns changes that add a term with new unknowns to the loop of a message: a link of given
/// length, which takes up one equation too many, or one of unknown length, which takes up two.
pub(crate) fn missing_terms(document: &Document, diagnostic: &Diagnostic) -> Vec<Fix> {
    if diagnostic.severity != Severity::Error {
        return Vec::new();
    }
    let Some(outline) = document.outline_at(diagnostic.range.start) else {
        return Vec::new();
    };
    // Messages about the whole item are about its unknowns.
    let items = statements(&document.text, &document.tokens, &outline.body, ';');
    let is_whole = |item: &&Range<usize>| **item == diagnostic.range && is_loop(document, item);
    let Some(item) = items.iter().find(is_whole) else {
        return Vec::new();
    };
    let unit = document.length_unit(outline);
    let angle = free_name(outline, &ANGLES);
    let length = free_name(outline, &LENGTHS);
    let [fixed, free] = [
        format!("polar(10{unit}, {angle})"),
        format!("polar({length}, {angle})"),
    ];
    let fix = |title: String, unknowns: &[String], term: &str| Fix {
        title,
        edits: vec![
            declarations(document, item, unknowns),
            Edit {
                range: end_of_equation(document, item),
                text: format!(" + {term}"),
            },
        ],
    };
    let turning = format!("unknown {angle} = 0deg;");
    let growing = format!("unknown {length} = 10{unit};");
    vec![
        fix(
            format!("add a link with an unknown angle, `{fixed}`"),
            std::slice::from_ref(&turning),
            &fixed,
        ),
        fix(
            format!("add a link with unknown angle and length, `{free}`"),
            &[turning.clone(), growing],
            &free,
        ),
    ]
}

fn is_loop(document: &Document, item: &Range<usize>) -> bool {
    let text = &document.text[item.clone()];
    let word = text.split(|c: char| !c.is_alphanumeric()).next();
    word == Some(DeclarationWord::Loop.word())
}

/// Returns a name that nothing has.
fn free_name(outline: &Outline, names: &[&'static str]) -> String {
    let mut free = names.iter().filter(|name| outline.find(name).is_none());
    free.next().map_or_else(
        || format!("{}_{}", names[0], outline.names.len()),
        |name| (*name).to_owned(),
    )
}

/// Declares unknowns on lines before an item.
fn declarations(document: &Document, item: &Range<usize>, unknowns: &[String]) -> Edit {
    let line = document.text[..item.start]
        .rfind('\n')
        .map_or(0, |end| end + 1);
    let before = &document.text[line..item.start];
    let indent = match before.trim().is_empty() {
        true => format!("\n{before}"),
        false => " ".to_owned(),
    };
    let lines = unknowns.iter().map(|unknown| format!("{unknown}{indent}"));
    Edit {
        range: item.start..item.start,
        text: lines.collect(),
    }
}

/// Returns the place after the right side of a loop.
fn end_of_equation(document: &Document, item: &Range<usize>) -> Range<usize> {
    let text = document.text[item.clone()].trim_end();
    let text = text
        .strip_suffix(MarkWord::Redundant.word())
        .unwrap_or(text);
    let end = item.start + text.trim_end().len();
    end..end
}
