//! The text as editors see it: messages with changes to take, hover, completion.

use std::cell::{Cell, RefCell};
use std::ops::Range;

use linkage_editor::{
    Colour, Completion, CompletionKind, Diagnostic, Document, Edit, Fix, NameKind, Severity,
    language_words,
};
use serde_json::{Value, json};

use crate::positions::Positions;

/// The file that messages name.
pub(crate) const FILE: &str = "mechanism.mech";

thread_local! {
    /// The document of the latest request. Values of the last text without a mistake are in it.
    static DOCUMENT: RefCell<Option<Document>> = const { RefCell::new(None) };
    /// True if a later text than the document's was found to have no messages.
    static IS_PASSED: Cell<bool> = const { Cell::new(false) };
}

/// Calls a function with the document of a text. The results of an earlier text are kept if it is
/// the same.
fn with_document<R>(text: &str, ask: impl FnOnce(&Document, &Positions<'_>) -> R) -> R {
    DOCUMENT.with_borrow_mut(|stored| {
        let document = stored.get_or_insert_with(|| Document::new(FILE, text));
        if document.text() != text || !document.is_solved() {
            document.set_text(text);
        }
        IS_PASSED.set(false);
        ask(document, &Positions::new(text))
    })
}

/// Notes that a text has no messages, without reading it: those of the document are older.
pub(crate) fn pass() {
    IS_PASSED.set(true);
}

/// Returns the messages about words and names, and the last ones about the solution, without solving
/// the text: in milliseconds.
pub(crate) fn first_messages(text: &str) -> Vec<Value> {
    let positions = Positions::new(text);
    let read = |document: &mut Document| {
        if document.text() != text {
            // The solution is asked for next.
            let _ = document.read(text);
        }
        shown_messages(document, &positions)
    };
    let new = || Document::new(FILE, "");
    match IS_PASSED.get() {
        true => read(&mut new()),
        false => DOCUMENT.with_borrow_mut(|stored| read(stored.get_or_insert_with(new))),
    }
}

fn shown_messages(document: &Document, positions: &Positions<'_>) -> Vec<Value> {
    let diagnostics = document.diagnostics().iter();
    diagnostics
        .map(|diagnostic| message(diagnostic, positions))
        .collect()
}

/// Returns all messages about a text: places, severity, text, and changes that follow the advice.
pub(crate) fn messages(text: &str) -> Vec<Value> {
    with_document(text, shown_messages)
}

fn message(diagnostic: &Diagnostic, positions: &Positions<'_>) -> Value {
    let help = diagnostic.help.iter().map(|help| format!("\nhelp: {help}"));
    let related = diagnostic.related.iter();
    let related = related.map(|related| format!("\nnote: {}", related.message));
    let text: String = [diagnostic.message.clone()]
        .into_iter()
        .chain(related)
        .chain(help)
        .collect();
    let fixes = diagnostic.fixes.iter();
    let fixes = fixes.map(|proposed| fix(proposed, positions));
    json!({
        "from": positions.utf16(diagnostic.range.start),
        "to": positions.utf16(diagnostic.range.end),
        "severity": match diagnostic.severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
        },
        "text": text,
        "fixes": fixes.collect::<Vec<_>>(),
    })
}

fn fix(fix: &Fix, positions: &Positions<'_>) -> Value {
    let edits = fix.edits.iter().map(|change| edit(change, positions));
    json!({ "title": fix.title, "edits": edits.collect::<Vec<_>>() })
}

fn edit(edit: &Edit, positions: &Positions<'_>) -> Value {
    json!({
        "from": positions.utf16(edit.range.start),
        "to": positions.utf16(edit.range.end),
        "insert": edit.text,
    })
}

/// Returns the changes that can be made to some words, as JSON; places count units of UTF-16.
pub(crate) fn actions(text: &str, from_utf16: usize, to_utf16: usize) -> String {
    let actions = with_document(text, |document, positions| {
        let range = positions.byte(from_utf16)..positions.byte(to_utf16);
        let actions = document.actions(range).into_iter();
        let one = actions.map(|action| fix(&action.fix, positions));
        one.collect::<Vec<_>>()
    });
    Value::from(actions).to_string()
}

/// Describes the word at a place, counted in units of UTF-16; `null` if nothing is known of it.
pub(crate) fn hover(text: &str, at_utf16: usize) -> String {
    let hover = with_document(text, |document, positions| {
        let hover = document.hover(positions.byte(at_utf16))?;
        Some(json!({
            "from": positions.utf16(hover.range.start),
            "to": positions.utf16(hover.range.end),
            "markdown": hover.markdown,
        }))
    });
    hover.unwrap_or(Value::Null).to_string()
}

/// Describes the call around a place, counted in units of UTF-16; `null` if there is none. Arguments
/// are pairs of places in the label.
pub(crate) fn signature(text: &str, at_utf16: usize) -> String {
    let signature = with_document(text, |document, positions| {
        let signature = document.signature(positions.byte(at_utf16))?;
        let label = Positions::new(&signature.label);
        let arguments = signature.arguments.iter();
        let arguments = arguments.map(|range| [range.start, range.end].map(|at| label.utf16(at)));
        Some(json!({
            "label": signature.label,
            "arguments": arguments.collect::<Vec<_>>(),
            "active": signature.active,
            "documentation": signature.documentation,
        }))
    });
    signature.unwrap_or(Value::Null).to_string()
}

/// Lists the values next to names, each with its place in units of UTF-16, and the places of names
/// that are words of the language elsewhere.
pub(crate) fn hints(text: &str) -> String {
    with_document(text, |document, positions| {
        let values = document.hints().into_iter().map(|hint| {
            json!({
                "at": positions.utf16(hint.offset),
                "label": hint.label,
                "isSolution": hint.is_solution,
            })
        });
        let language = language_words();
        let is_word = |range: &Range<usize>| {
            language
                .iter()
                .any(|(word, _)| *word == &text[range.clone()])
        };
        let words = document.words().into_iter();
        let names =
            words.filter(|word| matches!(word.colour, Colour::Name(_)) && is_word(&word.range));
        let names =
            names.map(|word| [word.range.start, word.range.end].map(|at| positions.utf16(at)));
        json!({ "values": values.collect::<Vec<_>>(), "names": names.collect::<Vec<_>>() })
            .to_string()
    })
}

/// Lists the words of the language by their colours.
pub(crate) fn words() -> String {
    let of = |colour: Colour| -> Vec<&str> {
        let words = language_words().into_iter();
        let words = words.filter(|(_, other)| *other == colour);
        words.map(|(word, _)| word).collect()
    };
    json!({ "keywords": of(Colour::Keyword), "functions": of(Colour::Function) }).to_string()
}

/// Lists the words that can be written at a place, counted in units of UTF-16, as the editor of the
/// front end takes them.
pub(crate) fn completions(text: &str, at_utf16: usize) -> String {
    with_document(text, |document, positions| {
        let completions = document.completions(positions.byte(at_utf16));
        let start = completions
            .first()
            .map(|first| positions.utf16(first.range.start));
        let options: Vec<Value> = completions.iter().map(option).collect();
        json!({ "from": start, "options": options }).to_string()
    })
}

fn option(completion: &Completion) -> Value {
    json!({
        "label": completion.label,
        "type": icon(completion.kind),
        "detail": completion.detail,
        "info": completion.documentation,
        "apply": completion.text,
    })
}

/// The icon of a kind in the list of the front end.
fn icon(kind: CompletionKind) -> &'static str {
    match kind {
        CompletionKind::Name(NameKind::Constant) => "constant",
        CompletionKind::Name(NameKind::Mechanism | NameKind::Part) => "class",
        CompletionKind::Name(NameKind::Function) | CompletionKind::Function => "function",
        CompletionKind::Name(NameKind::Field) | CompletionKind::Member => "property",
        CompletionKind::Name(
            NameKind::Parameter
            | NameKind::Input
            | NameKind::Unknown
            | NameKind::Derived
            | NameKind::Argument
            | NameKind::Body
            | NameKind::Joint
            | NameKind::Link
            | NameKind::Slider
            | NameKind::Slot,
        ) => "variable",
        CompletionKind::Quantity => "method",
        CompletionKind::Unit => "type",
        CompletionKind::Law => "enum",
        CompletionKind::Keyword => "keyword",
    }
}

#[cfg(test)]
mod tests {
    use crate::answer;
    use serde_json::{Value, json};

    fn messages(work: &str, text: &str) -> Vec<String> {
        let answer = answer(&json!({ "do": work, "text": text }).to_string());
        let first = answer.lines().next().expect("a line");
        let found: Value = serde_json::from_str(first).expect("JSON");
        let messages = found["messages"].as_array().expect("a list").iter();
        messages
            .map(|message| message["text"].to_string())
            .collect()
    }

    /// Links that reach each other if the rod is long.
    fn with_rod(length: &str) -> String {
        format!(
            "struct Slider {{ unit mm; param rod = {length}; input phi = 0deg in 0deg..360deg; \
             unknown theta = -10deg; unknown s = 90mm; \
             loop polar(20mm, phi) + polar(rod, theta) = (s, 5mm); }}"
        )
    }

    #[test]
    fn first_messages_are_those_of_words_and_of_the_last_solution() {
        let closes = |messages: &[String]| {
            let mut messages = messages.iter();
            messages.all(|message| !message.contains("the links") && !message.contains("apart"))
        };
        let short = with_rod("2mm");
        assert!(!closes(&messages("analyse", &short)));
        // The message of the last solution stays until there is another one.
        assert!(!closes(&messages("messages", &with_rod("3mm"))));
        // Now there is another one, without a message.
        assert_eq!(messages("analyse", &with_rod("80mm")), [""; 0]);
        assert_eq!(messages("messages", &with_rod("81mm")), [""; 0]);
        let names = messages("messages", &with_rod("rodd"));
        assert!(names[0].contains("unknown name `rodd`"), "{names:?}");
    }
}
