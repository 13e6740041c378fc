//! Texts with mechanisms.

use std::fs;
use std::io;
use std::ops::Range;
use std::path::Path;

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use linkage_compiler::{UnreadableCharacter, unreadable_character};
use proc_macro2::{LexError, TokenStream, TokenTree};

use crate::error::SourceError;
use crate::normal::normalised;

/// A text and the mechanisms in it: the text between the braces of `mechanism! { ... }`, one or
/// several mechanisms, or a Rust file with calls of that macro.
#[derive(Clone, Debug)]
pub struct Source {
    name: String,
    text: String,
    calls: Vec<MechanismCall>,
}

/// Mechanisms of a file that may have each other as parts: those of a call of the macro, or all of
/// a file that is not Rust.
#[derive(Clone, Debug)]
pub struct MechanismCall {
    /// Tokens for the compiler.
    pub tokens: TokenStream,
    /// The place of messages about no token: the call of the macro in a Rust file, else the
    /// beginning.
    pub range: Range<usize>,
}

impl Source {
    /// Reads a file.
    ///
    /// # Errors
    ///
    /// If it cannot be read, has a bracket without partner or the like or too many within each
    /// other, or is a Rust file without a mechanism.
    pub fn read(path: &Path) -> Result<Self, SourceError> {
        let text = fs::read_to_string(path);
        let text = text.map_err(|error| {
            let why = unread(path, &error);
            SourceError::Message(format!("cannot read `{}`: {why}", path.display()))
        })?;
        Self::new(&path.display().to_string(), &text)
    }

    /// A text; `name` stands in messages and says by its ending whether it is Rust.
    ///
    /// # Errors
    ///
    /// As [`read`](Self::read).
    pub fn new(name: &str, text: &str) -> Result<Self, SourceError> {
        // Editors of some systems put a mark in front, which is no token.
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let tokens: TokenStream = text
            .parse()
            .map_err(|error| SourceError::Rendered(no_tokens(name, text, &error)))?;
        let mut calls = Vec::new();
        collect(tokens.clone(), 0, &mut calls).map_err(|()| {
            SourceError::Message(format!(
                "brackets in `{name}` are nested more than {DEEPEST} deep, which is not read; this is a limit of linkage"
            ))
        })?;
        let ending = Path::new(name).extension();
        let is_rust = ending.is_some_and(|ending| ending == "rs");
        let calls = match (calls.is_empty(), is_rust) {
            (true, true) => {
                let text = format!("there is no call of `mechanism!` in `{name}`");
                return Err(SourceError::Message(text));
            }
            (true, false) => {
                let range = 0..0;
                vec![MechanismCall { tokens, range }]
            }
            (false, _) => calls,
        };
        // Not before it is known how deep brackets are.
        let normal = |found: MechanismCall| MechanismCall {
            tokens: normalised(found.tokens),
            range: found.range,
        };
        let calls = calls.into_iter().map(normal).collect();
        Ok(Self {
            name: name.to_owned(),
            text: text.to_owned(),
            calls,
        })
    }

    /// Returns the name in messages.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns the text.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The mechanisms in it, call by call.
    #[must_use]
    pub fn calls(&self) -> &[MechanismCall] {
        &self.calls
    }
}

/// Brackets within brackets: who reads them needs room for each. rustc stops at the same number.
const DEEPEST: usize = 128;

/// Collects the tokens between the brackets of all calls of `mechanism!`, within functions and
/// modules, too. It is an error if brackets are nested too deep.
fn collect(tokens: TokenStream, depth: usize, calls: &mut Vec<MechanismCall>) -> Result<(), ()> {
    if depth > DEEPEST {
        return Err(());
    }
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    for (index, token) in tokens.iter().enumerate() {
        let TokenTree::Group(group) = token else {
            continue;
        };
        match &tokens[..index] {
            [.., TokenTree::Ident(word), TokenTree::Punct(mark)]
                if word == "mechanism" && mark.as_char() == '!' =>
            {
                let start = word.span().byte_range().start;
                // The content is only checked for its depth.
                collect(group.stream(), depth + 1, &mut Vec::new())?;
                calls.push(MechanismCall {
                    tokens: group.stream(),
                    range: start..group.span_close().byte_range().end,
                });
            }
            // The definition of a macro is no mechanism yet.
            [
                ..,
                TokenTree::Ident(word),
                TokenTree::Punct(_),
                TokenTree::Ident(_),
            ] if word == "macro_rules" => {}
            _ => collect(group.stream(), depth + 1, calls)?,
        }
    }
    Ok(())
}

/// A text that is no sequence of tokens, by the place from which it is none.
fn no_tokens(name: &str, text: &str, error: &LexError) -> String {
    let start = error.span().byte_range().start;
    let found = text.get(start..).and_then(|rest| rest.chars().next());
    let unreadable = unreadable_character(text, start);
    let title = match unreadable {
        Some(UnreadableCharacter {
            fact,
            help: Some(help),
            ..
        }) => format!("{fact}\nhelp: {help}"),
        Some(unreadable) => unreadable.fact,
        None => {
            "this cannot be read: a bracket has no partner, or a text or comment no end".to_owned()
        }
    };
    let end = start + found.map_or(0, char::len_utf8);
    let snippet = Snippet::source(text)
        .path(name)
        .annotation(AnnotationKind::Primary.span(start..end));
    let report = [Level::ERROR.primary_title(title).element(snippet)];
    Renderer::plain().render(&report)
}

/// Returns the reason why a file was not read, and the file that is probably meant.
fn unread(path: &Path, error: &io::Error) -> String {
    if path.is_dir() {
        return "it is a folder".to_owned();
    }
    if error.kind() != io::ErrorKind::NotFound {
        return error.to_string();
    }
    let meant = path.with_extension("mech");
    match meant.is_file() {
        true => format!(
            "there is no such file\nhelp: there is `{}`",
            meant.display()
        ),
        false => "there is no such file".to_owned(),
    }
}
