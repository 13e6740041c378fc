//! The words that each part of a text can have.

use linkage_language::model::{
    Function, Law, LengthUnit, MotionLawWord, Repeating, SplineWord, clauses_of,
};
use linkage_language::syntax::{
    DeclarationWord, ItemWord, JointKind, LinkQuantity, LinkedWord, MarkWord, Word,
};

use crate::completion_list::{CompletionKind, CompletionList};
use crate::context::{call_at, path_before};
use crate::declaration::NameKind;
use crate::document::Document;
use crate::outline::Outline;
use crate::shown;
use crate::signature::call_of_function;

/// Adds the words after a dot.
pub(crate) fn add_members(document: &Document, found: &mut CompletionList, dot: usize) {
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
        for word in [LinkQuantity::Length, LinkQuantity::Angle] {
            found.add_words([word].into_iter(), CompletionKind::Member);
        }
    }
}

/// Adds the words within an item.
pub(crate) fn add_inside(
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
            found.add_words([MarkWord::In].into_iter(), CompletionKind::Keyword);
        }
        Some(ItemWord::Declaration(DeclarationWord::Loop)) => {
            found.add_words([MarkWord::Redundant].into_iter(), CompletionKind::Keyword);
        }
        Some(
            ItemWord::Declaration(_) | ItemWord::Joint(_) | ItemWord::Load(_) | ItemWord::Linked(_),
        )
        | None => {}
    }
    add_names(document, found, outline, |_| true);
    add_functions(document, found, start);
    let item = ItemWord::from_word(word);
    if let Some(vocabulary) = item.and_then(clauses_of) {
        for (word, meaning) in vocabulary.rows() {
            found.add(word, CompletionKind::Keyword, String::new(), meaning);
        }
    }
    if item.is_some_and(names_bodies) {
        add_frame(found, outline);
    }
}

/// Adds the names of a mechanism.
pub(crate) fn add_names(
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
pub(crate) fn add_functions(document: &Document, found: &mut CompletionList, offset: usize) {
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
pub(crate) fn is_argument(kind: NameKind) -> bool {
    matches!(kind, NameKind::Input | NameKind::Argument)
}

/// Returns true for the word of an item that a value follows instead of a new name.
fn is_valued(word: &str) -> bool {
    matches!(
        word,
        "loop"
            | "gravity"
            | "force"
            | "torque"
            | "spring"
            | "damper"
            | "friction"
            | "gears"
            | "belt"
            | "weld"
    )
}

/// Adds the fixed link in place of the function with this name.
fn add_frame(found: &mut CompletionList, outline: &Outline) {
    let frame = MarkWord::Frame;
    let is_function = |kind: CompletionKind| kind == CompletionKind::Function;
    found
        .words
        .retain(|word| word.label != frame.word() || !is_function(word.kind));
    if outline.find(frame.word()).is_none() {
        found.add_words([frame].into_iter(), CompletionKind::Keyword);
    }
}

/// Returns true for an item that names bodies or links, the frame among them.
fn names_bodies(word: ItemWord) -> bool {
    match word {
        ItemWord::Declaration(DeclarationWord::Body | DeclarationWord::Part)
        | ItemWord::Joint(_)
        | ItemWord::Load(_)
        | ItemWord::Linked(
            LinkedWord::Link
            | LinkedWord::Slider
            | LinkedWord::Gears
            | LinkedWord::Belt
            | LinkedWord::Weld,
        ) => true,
        ItemWord::Declaration(_) | ItemWord::Linked(LinkedWord::Joint) => false,
    }
}
