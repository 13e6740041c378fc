//! Mistakes of the user: collected through a phase, reported together.

use std::fmt::Display;

use proc_macro2::{Ident, TokenStream};
use quote::{quote, quote_spanned};

use crate::model::OriginId;
use crate::syntax::SourceSpan;

pub(crate) mod text;

/// One message at one place.
#[derive(Clone, Debug)]
pub struct Diagnostic {
    pub span: SourceSpan,
    pub message: String,
}

/// The source spans behind the model's [`OriginId`]s.
#[derive(Debug, Default)]
pub struct Origins {
    spans: Vec<SourceSpan>,
}

impl Origins {
    pub fn add(&mut self, span: SourceSpan) -> OriginId {
        self.spans.push(span);
        OriginId(self.spans.len() as u32 - 1)
    }

    pub fn span(&self, origin: OriginId) -> SourceSpan {
        self.spans[origin.0 as usize]
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
