//! The compiler's view of a text: messages, types, and whether it has programs.

use std::ops::Range;

use linkage_compiler::{Checked, Message, SourceSpan, check_all, check_names};
use linkage_engine::{MechanismCall, Source};
use linkage_language::diagnostic::characters::unreadable_character;
use proc_macro2::{TokenStream, extra::invalidate_current_thread_spans};

use crate::diagnostics::{Diagnostic, Edit, Fix, Related, Severity};
use crate::facts::Facts;
use crate::function_facts::{FunctionFacts, functions};
use crate::suggested::suggested;

/// The results of compiling a text.
#[derive(Clone, Debug, Default)]
pub(crate) struct Analysis {
    pub(crate) diagnostics: Vec<Diagnostic>,
    /// Types of the mechanisms whose names have no mistake.
    pub(crate) facts: Vec<Facts>,
    /// The functions of the mechanisms that have programs.
    pub(crate) functions: Vec<FunctionFacts>,
    /// True if all mechanisms have programs, perhaps in other ranges than the declared ones.
    pub(crate) runs: bool,
}

/// The phases that a text passes.
type Check = fn(TokenStream) -> Vec<Checked>;

/// Compiles a text. Spans of this thread's earlier tokens become invalid.
pub(crate) fn analyse(name: &str, text: &str) -> Analysis {
    analysed(name, text, check_all)
}

/// Reads a text and resolves its names, without solving anything. Spans of this thread's earlier
/// tokens become invalid.
pub(crate) fn names(name: &str, text: &str) -> Analysis {
    analysed(name, text, check_names)
}

fn analysed(name: &str, text: &str, check: Check) -> Analysis {
    let analysis = match Source::new(name, text) {
        Ok(source) => checked(&source, text, check),
        // The compiler of Rust has messages about the rest of a Rust file.
        Err(_) if name.ends_with(".rs") => Analysis::default(),
        Err(error) => unreadable(text, &error.to_string()),
    };
    // Otherwise the texts of all analyses stay in memory.
    invalidate_current_thread_spans();
    analysis
}

/// Returns the bytes of the mark in front of a text, which the compiler does not see.
pub(crate) fn offset_of_text(text: &str) -> usize {
    match text.starts_with('\u{feff}') {
        true => '\u{feff}'.len_utf8(),
        false => 0,
    }
}

fn checked(source: &Source, text: &str, check: Check) -> Analysis {
    let mut analysis = Analysis {
        runs: true,
        ..Analysis::default()
    };
    for call in source.calls() {
        for checked in check(call.tokens.clone()) {
            analysis.runs &= checked.unit.is_some() || checked.out_of_range.is_some();
            analysis.functions.extend(functions(&checked));
            let model = checked.model.as_ref();
            analysis
                .facts
                .extend(model.map(|model| Facts::new(&model.mechanism)));
            analysis
                .diagnostics
                .extend(diagnostics(text, call, &checked));
        }
    }
    analysis
}

/// Returns the messages about a mechanism; further places of a mistake are part of its message.
fn diagnostics(text: &str, call: &MechanismCall, checked: &Checked) -> Vec<Diagnostic> {
    let offset = offset_of_text(text);
    let mut found: Vec<Diagnostic> = Vec::new();
    let mistakes = checked
        .messages
        .iter()
        .map(|message| (message, Severity::Error));
    let warnings = checked
        .warnings
        .iter()
        .map(|message| (message, Severity::Warning));
    for (message, severity) in mistakes.chain(warnings) {
        let diagnostic = diagnostic((text, call), message, severity, offset);
        match found.last_mut() {
            Some(first) if message.is_related => first.related.push(Related {
                range: diagnostic.range,
                message: diagnostic.message,
            }),
            _ => found.push(diagnostic),
        }
    }
    found
}

fn diagnostic(
    (text, call): (&str, &MechanismCall),
    message: &Message,
    severity: Severity,
    offset: usize,
) -> Diagnostic {
    let range = |span: SourceSpan| bytes(call, span, offset);
    let fixes = message.suggestions.iter();
    let fixes = fixes.filter_map(|suggestion| suggested(text, suggestion, range));
    let (fact, help) = match message.text.split_once("\nhelp: ") {
        Some((fact, help)) => (fact, Some(help.to_owned())),
        None => (message.text.as_str(), None),
    };
    Diagnostic {
        range: range(message.span),
        severity,
        message: fact.to_owned(),
        help,
        related: Vec::new(),
        fixes: fixes.collect(),
    }
}

/// Returns the bytes between the ends of two tokens. Text that the compiler made up is that of the
/// whole call.
pub(crate) fn bytes(call: &MechanismCall, span: SourceSpan, offset: usize) -> Range<usize> {
    let [first, last] = [span.first, span.last].map(|span| span.byte_range());
    let range = match (first.start, last.end) {
        (0, 0) => call.range.clone(),
        (start, end) => start..end.max(start),
    };
    range.start + offset..range.end + offset
}

/// The message of a text that is no sequence of tokens.
fn unreadable(text: &str, message: &str) -> Analysis {
    let offset = offset_of_text(text);
    let location = match text[offset..].parse::<TokenStream>() {
        Ok(_) => None,
        Err(error) => Some(error.span().byte_range().start + offset),
    };
    let Some(start) = location else {
        // Brackets that are too deep.
        return only(Diagnostic::error(0..0, message));
    };
    let rest = text.get(start..).unwrap_or_default();
    let found = rest.chars().next();
    let end = start + found.map_or(0, char::len_utf8);
    let Some(unreadable) = unreadable_character(text, start) else {
        let message = "this cannot be read: a bracket has no partner, or a text or comment no end";
        return only(Diagnostic::error(start..end, message));
    };
    let fixes = unreadable.replacement.map(|text| Fix {
        title: format!("write `{text}`"),
        edits: vec![Edit {
            range: start..end,
            text: text.to_owned(),
        }],
    });
    only(Diagnostic {
        help: unreadable.help,
        fixes: fixes.into_iter().collect(),
        ..Diagnostic::error(start..end, &unreadable.fact)
    })
}

fn only(diagnostic: Diagnostic) -> Analysis {
    Analysis {
        diagnostics: vec![diagnostic],
        ..Analysis::default()
    }
}
