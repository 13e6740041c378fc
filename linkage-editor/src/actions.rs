//! Changes that an editor offers at a place.

use std::ops::Range;

use linkage_language::model::{CalledWord, plain_word};
use linkage_language::syntax::{Word, is_unit};

use crate::computed::Age;
use crate::declaration::{Declaration, NameKind};
use crate::diagnostics::{Diagnostic, Edit, Fix};
use crate::document::Document;
use crate::hints::solution;
use crate::insertion::{insertion, item_at};
use crate::lexer::Kind;
use crate::loop_terms::missing_terms;
use crate::outline::Outline;
use crate::shown;

/// A change that an editor offers, and the message whose advice it follows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Action {
    /// The change.
    pub fix: Fix,
    /// The index of the message among [`Document::diagnostics`]; `None` if it follows no message.
    pub diagnostic: Option<usize>,
}

/// See [`Document::actions`].
pub(crate) fn actions(document: &Document, range: &Range<usize>) -> Vec<Action> {
    let mut found = Vec::new();
    for (index, diagnostic) in document.diagnostics().iter().enumerate() {
        if !touches(&diagnostic.range, range) {
            continue;
        }
        let fixes = diagnostic.fixes.iter().cloned();
        let fixes = fixes.chain(declarations(document, diagnostic));
        let fixes = fixes.chain(missing_terms(document, diagnostic));
        found.extend(fixes.map(|fix| Action {
            fix,
            diagnostic: Some(index),
        }));
    }
    let outlines = document.outlines.iter();
    for outline in outlines.filter(|outline| outline.contains(range.start)) {
        let estimates = estimates(document, outline, range);
        let others = estimates
            .into_iter()
            .chain(unused_unknown(document, outline, range));
        let others = others.chain(picture(document, outline));
        found.extend(others.map(|fix| Action {
            fix,
            diagnostic: None,
        }));
    }
    let mut titles: Vec<String> = Vec::new();
    found.retain(|action| {
        let is_new = !titles.contains(&action.fix.title);
        titles.push(action.fix.title.clone());
        is_new
    });
    found
}

fn touches(one: &Range<usize>, other: &Range<usize>) -> bool {
    one.start <= other.end && other.start <= one.end
}

/// Declares a word that a message is about and that means nothing yet.
fn declarations(document: &Document, diagnostic: &Diagnostic) -> Vec<Fix> {
    let range = &diagnostic.range;
    let mut tokens = document.tokens.iter();
    let is_word = tokens.any(|token| token.kind == Kind::Word && token.range == *range);
    let Some(word) = document.text.get(range.clone()).filter(|_| is_word) else {
        return Vec::new();
    };
    let is_used = document.uses.iter().any(|found| found.range == *range);
    let Some(outline) = document.outline_at(range.start) else {
        return Vec::new();
    };
    // A member of something has no declaration.
    let is_member = document.text[..range.start].ends_with('.');
    if is_used || is_member || is_of_language(word) || outline.find(word).is_some() {
        return Vec::new();
    }
    let is_inside = |block: &Range<usize>| block.contains(&range.start);
    if !is_inside(&outline.body) && !outline.implementations.iter().any(is_inside) {
        return Vec::new();
    }
    // The word is a function, a joint or that of an item.
    let is_called = document.text[range.end..].trim_start().starts_with('(');
    if is_called || !is_value(document, outline, range.start) {
        return Vec::new();
    }
    let Some(location) = item_before(document, outline, range.start) else {
        return Vec::new();
    };
    let declared = |item: String| Fix {
        title: format!("declare `{item}`"),
        edits: vec![insertion(&document.text, location, &format!("{item};"))],
    };
    let items = declaring(word, document.length_unit(outline), outline, diagnostic);
    items.into_iter().map(declared).collect()
}

/// Returns the items that may declare a word of a message. The changes of the message are better
/// advice, but a name that is near to that of a forgotten input is hardly meant.
fn declaring(word: &str, length: &str, outline: &Outline, diagnostic: &Diagnostic) -> Vec<String> {
    let has_input = outline
        .names
        .iter()
        .any(|name| name.kind == NameKind::Input);
    let mut edits = diagnostic.fixes.iter().flat_map(|fix| &fix.edits);
    let is_declared = edits.any(|edit| edit.range.is_empty());
    let mut items = Vec::new();
    if !has_input && !is_declared {
        items.push(format!("input {word} = 0deg in 0deg..360deg"));
    }
    // Functions list inputs alone.
    let mut functions = outline.functions.iter();
    let is_listed = functions.any(|function| function.arguments.contains(&diagnostic.range.start));
    if diagnostic.fixes.is_empty() && !is_listed {
        items.extend([
            format!("unknown {word} = 0deg"),
            format!("unknown {word} = 10{length}"),
            format!("param {word} = 10{length}"),
        ]);
    }
    items
}

/// Returns false at the beginning of an item, and for a joint of a link.
fn is_value(document: &Document, outline: &Outline, offset: usize) -> bool {
    let Some(item) = item_before(document, outline, offset).filter(|item| *item <= offset) else {
        return true;
    };
    let before = document.text[item..offset].trim_end();
    let is_joint = before.starts_with("link ") && before.ends_with([':', ',']);
    !before.is_empty() && !is_joint
}

fn item_before(document: &Document, outline: &Outline, offset: usize) -> Option<usize> {
    item_at(&document.text, &document.tokens, outline, offset)
}

/// Returns true for a word that has a meaning without a declaration.
fn is_of_language(word: &str) -> bool {
    CalledWord::from_word(word).is_some()
        || plain_word(word, None).is_some()
        || is_unit(word)
        || word == "PI"
}

/// Takes the solution of an unknown as its estimate; and those of all unknowns.
fn estimates(document: &Document, outline: &Outline, range: &Range<usize>) -> Vec<Fix> {
    let is_here = |name: &Declaration| name.kind == NameKind::Unknown && touches(&name.item, range);
    // Values take a compilation, so they are computed for unknowns only.
    let is_present = document.age_of_values() == Age::Present;
    if !is_present || !outline.names.iter().any(is_here) {
        return Vec::new();
    }
    let Some(values) = document.values(&outline.mechanism.name) else {
        return Vec::new();
    };
    let unknowns = outline
        .names
        .iter()
        .filter(|name| name.kind == NameKind::Unknown);
    let computed = unknowns.filter_map(|unknown| {
        let location = unknown.value.clone()?;
        let found = solution(values, &unknown.name)?;
        let text = shown::short(found);
        let edit = Edit {
            range: location,
            text,
        };
        Some((unknown, edit))
    });
    let computed: Vec<_> = computed.collect();
    let here = computed
        .iter()
        .filter(|(unknown, _)| touches(&unknown.item, range));
    let mut fixes: Vec<Fix> = here
        .map(|(_, edit)| Fix {
            title: format!("take the estimate {}", edit.text),
            edits: vec![edit.clone()],
        })
        .collect();
    if !fixes.is_empty() && computed.len() > 1 {
        fixes.push(Fix {
            title: "take all computed estimates".to_owned(),
            edits: computed.into_iter().map(|(_, edit)| edit).collect(),
        });
    }
    fixes
}

/// Writes a loop for an unknown that no loop contains, directly or by derived quantities.
fn unused_unknown(document: &Document, outline: &Outline, range: &Range<usize>) -> Option<Fix> {
    let mut unknowns = outline
        .names
        .iter()
        .filter(|name| name.kind == NameKind::Unknown);
    let unknown = unknowns.find(|unknown| touches(&unknown.item, range))?;
    let uses = document.references(unknown.range.start, false);
    if uses.iter().any(|used| outline.body.contains(&used.start)) {
        return None;
    }
    let end = unknown.item.end;
    let rest = &document.text[end..];
    let after = end + rest.find('\n').unwrap_or(rest.len());
    let item = format!("loop {} = 0;", unknown.name);
    Some(Fix {
        title: format!("add a loop with `{}`", unknown.name),
        edits: vec![Edit {
            range: after..after,
            text: format!("\n    {item}"),
        }],
    })
}

/// Adds a function with the picture, if there is none.
fn picture(document: &Document, outline: &Outline) -> Option<Fix> {
    let is_drawn = |range: &Range<usize>| {
        let text = document.text.get(range.clone());
        text.is_some_and(|text| text.contains("picture("))
    };
    if outline.implementations.iter().any(is_drawn) {
        return None;
    }
    let facts = document.facts(&outline.mechanism.name)?;
    let function = free_name(outline, "shape");
    let result = free_result(document, "Shape");
    let inputs = facts.inputs.join(", ");
    let item = format!(
        "    /// The links, for the drawing.\n    pub fn {function}({inputs}) -> {result} {{ shape: picture() }}\n"
    );
    let edit = match outline.implementations.last() {
        Some(block) => {
            let inside = &document.text[block.clone()];
            let end = block.start + inside.trim_end().len();
            Edit {
                range: end..block.end,
                text: if end == block.start {
                    format!("\n{item}")
                } else {
                    format!("\n\n{item}")
                },
            }
        }
        None => {
            let end = outline.mechanism.item.end.min(document.text.len());
            let name = &outline.mechanism.name;
            Edit {
                range: end..end,
                text: format!("\n\nimpl {name} {{\n{item}}}"),
            }
        }
    };
    Some(Fix {
        title: "add a function with `picture()`".to_owned(),
        edits: vec![edit],
    })
}

/// Returns a name that no function has.
fn free_name(outline: &Outline, wanted: &str) -> String {
    let is_taken = |name: &str| {
        let mut functions = outline.functions.iter();
        functions.any(|function| function.function.name == name)
    };
    let mut name = wanted.to_owned();
    while is_taken(&name) {
        name.push('_');
    }
    name
}

/// Returns a name that is no word of the text.
fn free_result(document: &Document, wanted: &str) -> String {
    let is_taken = |name: &str| {
        let mut tokens = document.tokens.iter();
        tokens.any(|token| token.kind == Kind::Word && token.text(&document.text) == name)
    };
    let mut name = wanted.to_owned();
    while is_taken(&name) {
        name = format!("Drawn{name}");
    }
    name
}
