//! Words that can be written at a place.

use std::ops::Range;

use linkage_language::model::{
    Function, Law, LengthUnit, MotionLawWord, QuantityWord, Repeating, SplineWord,
};
use linkage_language::syntax::{
    ClauseWord, DeclarationWord, ItemWord, JointKind, Word, unit_description, unit_names,
};

use crate::context::{Region, call_at, path_before, region};
use crate::document::Document;
use crate::lexer::Kind;
use crate::outline::{NameKind, Outline};
use crate::shown;
use crate::signature::{call_of_function, call_of_quantity};

/// A word that can be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Completion {
    /// The word, as it is listed.
    pub label: String,
    /// Its kind.
    pub kind: CompletionKind,
    /// Its type, form or value, on a line.
    pub detail: String,
    /// Its meaning, in Markdown; may be empty.
    pub documentation: String,
    /// The bytes that it replaces.
    pub range: Range<usize>,
    /// The text instead of them.
    pub text: String,
}

/// The kind of a word that can be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CompletionKind {
    /// A declared name.
    Name(NameKind),
    /// A part of a vector or frame, or a quantity of a link.
    Member,
    /// A function of expressions.
    Function,
    /// A quantity of functions.
    Quantity,
    /// A unit.
    Unit,
    /// A law of motion, or another word of a course.
    Law,
    /// A word of the language.
    Keyword,
}

/// The words that have been found.
struct CompletionList {
    range: Range<usize>,
    words: Vec<Completion>,
}

impl CompletionList {
    fn add(&mut self, label: &str, kind: CompletionKind, detail: String, documentation: &str) {
        let text = label.to_owned();
        self.add_as(label, kind, detail, documentation, text);
    }

    fn add_as(
        &mut self,
        label: &str,
        kind: CompletionKind,
        detail: String,
        documentation: &str,
        text: String,
    ) {
        self.words.push(Completion {
            label: label.to_owned(),
            kind,
            detail,
            documentation: documentation.to_owned(),
            range: self.range.clone(),
            text,
        });
    }

    fn add_words<W: Word>(&mut self, words: impl Iterator<Item = W>, kind: CompletionKind) {
        for word in words {
            self.add(word.word(), kind, String::new(), word.description());
        }
    }
}

/// Returns the words that can be written before a byte, whatever has been written of them.
/// Editors choose those that fit.
pub(crate) fn completions(document: &Document, offset: usize) -> Vec<Completion> {
    let offset = offset.min(document.text.len());
    let Some(range) = begun(document, offset) else {
        return units_after_number(document, offset);
    };
    let mut found = CompletionList {
        range: range.clone(),
        words: Vec::new(),
    };
    if document.text[..range.start].ends_with('.') {
        add_members(document, &mut found, range.start - 1);
        return found.words;
    }
    match region(document, range.start) {
        Region::Outside => {
            found.add(
                "pub struct",
                CompletionKind::Keyword,
                String::new(),
                "A mechanism.",
            );
            found.add(
                "impl",
                CompletionKind::Keyword,
                String::new(),
                "Functions of a mechanism.",
            );
        }
        Region::Implementation => {
            found.add(
                "pub fn",
                CompletionKind::Keyword,
                String::new(),
                "A function of inputs.",
            );
        }
        Region::Item => found.add_words(ItemWord::all(), CompletionKind::Keyword),
        Region::Arguments(outline) => add_names(document, &mut found, outline, is_argument),
        Region::Inside(outline, word) => {
            add_inside(document, &mut found, outline, &word, range.start)
        }
        Region::Quantities(outline) => {
            add_names(document, &mut found, outline, |_| true);
            for word in QuantityWord::all() {
                let call = call_of_quantity(word);
                let text = format!("{}(", word.word());
                found.add_as(
                    word.word(),
                    CompletionKind::Quantity,
                    call,
                    word.description(),
                    text,
                );
            }
            add_functions(document, &mut found, range.start);
        }
    }
    found.words
}

/// Returns the bytes of the word that ends at a byte, empty ones if there is none; `None` after
/// a number or within a comment.
fn begun(document: &Document, offset: usize) -> Option<Range<usize>> {
    let index = document
        .tokens
        .partition_point(|token| token.range.end < offset);
    let Some(token) = document
        .tokens
        .get(index)
        .filter(|token| token.range.start < offset)
    else {
        return Some(offset..offset);
    };
    match token.kind {
        Kind::Word => Some(token.range.start..offset),
        Kind::Blank | Kind::Open | Kind::Close | Kind::Mark => Some(offset..offset),
        Kind::Number | Kind::Comment | Kind::Documentation | Kind::Text | Kind::Unknown => None,
    }
}

/// Returns the units that a number can have.
fn units_after_number(document: &Document, offset: usize) -> Vec<Completion> {
    let index = document
        .tokens
        .partition_point(|token| token.range.end < offset);
    let number = document
        .tokens
        .get(index)
        .filter(|token| token.kind == Kind::Number);
    let Some(number) = number else {
        return Vec::new();
    };
    let written = &document.text[number.range.start..offset];
    let digits = written
        .trim_end_matches(|c: char| c.is_alphabetic() || c == '\u{b5}')
        .len();
    let mut found = CompletionList {
        range: number.range.start + digits..offset,
        words: Vec::new(),
    };
    for unit in unit_names() {
        let description = unit_description(unit).unwrap_or_default();
        found.add(unit, CompletionKind::Unit, description.to_owned(), "");
    }
    found.words
}

/// Adds the words after a dot.
fn add_members(document: &Document, found: &mut CompletionList, dot: usize) {
    let (Some(path), Some(outline)) = (path_before(document, dot), document.outline_at(dot)) else {
        return;
    };
    let prefix = format!("{path}.");
    if let Some(facts) = document.facts(&outline.mechanism.name) {
        let inner = facts.names.range(prefix.clone()..);
        let inner = inner.take_while(|(name, _)| name.starts_with(&prefix));
        for (name, fact) in inner {
            let rest = &name[prefix.len()..];
            // Names of parts within parts follow after their first dot.
            let word = rest.split('.').next().unwrap_or(rest);
            if found.words.last().is_none_or(|last| last.label != word) {
                let detail = if word == rest {
                    fact.ty.clone()
                } else {
                    String::new()
                };
                found.add(word, CompletionKind::Member, detail, "");
            }
        }
        if let Some(fact) = facts.names.get(&path) {
            for member in fact.members {
                found.add(member, CompletionKind::Member, String::new(), "");
            }
        }
    }
    if found.words.is_empty() {
        add_written_members(document, found, outline, &path);
    }
}

/// Adds the words after a dot that the text alone gives: names of a part, quantities of a link.
fn add_written_members(
    document: &Document,
    found: &mut CompletionList,
    outline: &Outline,
    path: &str,
) {
    let Some(declared) = outline.find(path) else {
        return;
    };
    if let Some(part) = &declared.mechanism {
        let mut outlines = document.outlines.iter();
        let part = outlines.find(|outline| outline.mechanism.name == *part);
        for name in part.into_iter().flat_map(|part| &part.names) {
            found.add(
                &name.name,
                CompletionKind::Name(name.kind),
                String::new(),
                &name.documentation,
            );
        }
    }
    if declared.kind == NameKind::Link {
        for word in ["length", "angle"] {
            found.add(word, CompletionKind::Member, String::new(), "");
        }
    }
}

/// Adds the words within an item.
fn add_inside(
    document: &Document,
    found: &mut CompletionList,
    outline: &Outline,
    word: &str,
    start: usize,
) {
    let before = document.text[..start].trim_end();
    match ItemWord::from_word(word) {
        Some(ItemWord::Declaration(DeclarationWord::Unit)) => {
            found.add_words(LengthUnit::all(), CompletionKind::Unit);
            return;
        }
        // A new name follows.
        Some(_) if before.ends_with(word) && !is_valued(word) => return,
        Some(ItemWord::Declaration(DeclarationWord::Part)) => {
            for outline in &document.outlines {
                let mechanism = &outline.mechanism;
                let kind = CompletionKind::Name(NameKind::Mechanism);
                found.add(
                    &mechanism.name,
                    kind,
                    String::new(),
                    &mechanism.documentation,
                );
            }
        }
        Some(ItemWord::Declaration(DeclarationWord::Body)) => {
            found.add_words(JointKind::all(), CompletionKind::Keyword);
        }
        Some(ItemWord::Declaration(DeclarationWord::Input)) => {
            found.add(
                "in",
                CompletionKind::Keyword,
                "in LOW..HIGH".to_owned(),
                "The range in which the mechanism must work.",
            );
        }
        Some(ItemWord::Declaration(DeclarationWord::Loop)) => {
            found.add(
                "redundant",
                CompletionKind::Keyword,
                String::new(),
                "The equation follows from the others.",
            );
        }
        Some(
            ItemWord::Declaration(_) | ItemWord::Joint(_) | ItemWord::Load(_) | ItemWord::Linked(_),
        )
        | None => {}
    }
    add_names(document, found, outline, |_| true);
    add_functions(document, found, start);
    if has_clauses(word) {
        found.add_words(ClauseWord::all(), CompletionKind::Keyword);
        found.add(
            "frame",
            CompletionKind::Keyword,
            String::new(),
            "The link that does not move.",
        );
    }
}

/// Adds the names of a mechanism.
fn add_names(
    document: &Document,
    found: &mut CompletionList,
    outline: &Outline,
    is_meant: fn(NameKind) -> bool,
) {
    let mechanism = &outline.mechanism.name;
    let facts = document.facts(mechanism);
    for name in outline.names.iter().filter(|name| is_meant(name.kind)) {
        let fact = facts.and_then(|facts| facts.names.get(&name.name));
        let ty = fact.map_or(name.kind.word(), |fact| &fact.ty);
        let value = document.computed_value(mechanism, &name.name);
        let value = value.map(shown::short);
        let detail = match value {
            Some(value) => format!("{ty}, {value}"),
            None => ty.to_owned(),
        };
        let kind = CompletionKind::Name(name.kind);
        found.add(&name.name, kind, detail, &name.documentation);
    }
}

/// Adds the functions of expressions, and in a course its laws.
fn add_functions(document: &Document, found: &mut CompletionList, offset: usize) {
    for word in Function::all() {
        let text = format!("{}(", word.word());
        let call = call_of_function(word);
        found.add_as(
            word.word(),
            CompletionKind::Function,
            call,
            word.description(),
            text,
        );
    }
    for word in MotionLawWord::all() {
        let text = format!("{}(", word.word());
        let form = word.form().to_owned();
        found.add_as(
            word.word(),
            CompletionKind::Function,
            form,
            word.description(),
            text,
        );
    }
    found.add(
        "PI",
        CompletionKind::Keyword,
        "3.14159...".to_owned(),
        "Half a turn.",
    );
    let call = call_at(document, offset);
    match call.and_then(|call| MotionLawWord::from_word(&call.word)) {
        Some(MotionLawWord::Rise) => found.add_words(Law::all(), CompletionKind::Law),
        Some(MotionLawWord::Piecewise) => {
            found.add_words(Law::all(), CompletionKind::Law);
            found.add_words(Repeating::all(), CompletionKind::Law);
        }
        Some(MotionLawWord::Spline) => {
            found.add_words(SplineWord::all(), CompletionKind::Law);
        }
        Some(MotionLawWord::Slope) | None => {}
    }
}

/// Returns true for names that functions take as arguments.
fn is_argument(kind: NameKind) -> bool {
    matches!(kind, NameKind::Input | NameKind::Argument)
}

/// Returns true for the word of an item that a value follows instead of a new name.
fn is_valued(word: &str) -> bool {
    matches!(
        word,
        "loop" | "gravity" | "force" | "torque" | "spring" | "damper" | "gears" | "belt" | "weld"
    )
}

/// Returns true for the word of an item with clauses.
fn has_clauses(word: &str) -> bool {
    match ItemWord::from_word(word) {
        Some(ItemWord::Declaration(
            DeclarationWord::Body | DeclarationWord::Part | DeclarationWord::Input,
        ))
        | Some(ItemWord::Joint(_) | ItemWord::Load(_) | ItemWord::Linked(_)) => true,
        Some(ItemWord::Declaration(_)) | None => false,
    }
}
