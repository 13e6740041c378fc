//! Mistakes of the user: collected through a phase, reported together.

use std::fmt::Display;

use proc_macro2::{Ident, TokenStream};
use quote::{quote, quote_spanned};

mod place;
pub(crate) mod text;

pub use place::{OriginId, Origins, SourceSpan};

/// One message at one place.
#[derive(Clone, Debug)]
pub struct Diagnostic {
    pub span: SourceSpan,
    pub message: String,
}

/// Where phases without spans report: messages at the places that [`OriginId`]s lead back to.
#[derive(Debug)]
pub(crate) struct Reporter<'a> {
    pub(crate) origins: &'a Origins,
    pub(crate) diagnostics: &'a mut Diagnostics,
}

impl Reporter<'_> {
    /// See [`Diagnostics::error`].
    pub(crate) fn error(&mut self, origin: OriginId, message: impl Into<String>) {
        self.diagnostics.error(self.origins.span(origin), message);
    }

    /// See [`Diagnostics::error_with_help`].
    pub(crate) fn error_with_help(
        &mut self,
        origin: OriginId,
        fact: impl Display,
        help: impl Display,
    ) {
        let span = self.origins.span(origin);
        self.diagnostics.error_with_help(span, fact, help);
    }

    /// At all that stands from one place to another.
    pub(crate) fn error_between(
        &mut self,
        [first, last]: [OriginId; 2],
        message: impl Into<String>,
    ) {
        let span = self.origins.span(first).to(self.origins.span(last));
        self.diagnostics.error(span, message);
    }

    /// For somebody who keeps it.
    pub(crate) fn reborrow(&mut self) -> Reporter<'_> {
        Reporter {
            origins: self.origins,
            diagnostics: self.diagnostics,
        }
    }

    /// How many messages there are by now, of all phases.
    pub(crate) fn errors(&self) -> usize {
        self.diagnostics.len()
    }
}

/// The sink that every phase writes to.
#[derive(Debug, Default)]
pub struct Diagnostics {
    list: Vec<Diagnostic>,
}

impl Diagnostics {
    /// Fact first, lower case, names in back-ticks; a second line `help: ...` says what to write.
    pub fn error(&mut self, span: SourceSpan, message: impl Into<String>) {
        self.list.push(Diagnostic {
            span,
            message: message.into(),
        });
    }

    /// As [`error`](Self::error), with the second line given apart.
    pub fn error_with_help(&mut self, span: SourceSpan, fact: impl Display, help: impl Display) {
        self.error(span, format!("{fact}\nhelp: {help}"));
    }

    /// Adds the messages of another sink behind those of this one.
    pub fn append(&mut self, other: Diagnostics) {
        self.list.extend(other.list);
    }

    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    pub fn len(&self) -> usize {
        self.list.len()
    }

    pub fn iter(&self) -> impl Iterator<Item = &Diagnostic> {
        self.list.iter()
    }

    /// One `compile_error!` for each message, underlining the words at fault.
    pub fn to_tokens(&self) -> TokenStream {
        self.list.iter().map(compile_error).collect()
    }
}

fn compile_error(diagnostic: &Diagnostic) -> TokenStream {
    let SourceSpan { first, last } = diagnostic.span;
    let message = &diagnostic.message;
    let path = [
        Ident::new("core", first),
        Ident::new("compile_error", first),
    ];
    let [core, macro_name] = path;
    let head = quote_spanned!(first=> ::#core::#macro_name!);
    let tail = quote_spanned!(last=> { #message });
    quote!(#head #tail)
}
