//! Places in the source: spans where there are tokens, ids of them behind `model`.

use proc_macro2::{Ident, Span};

/// First and last token of a piece of source text; messages underline all that lies between.
///
/// Outside of a procedural macro, lines and columns of both are known if proc-macro2 has its feature `span-locations`.
#[derive(Clone, Copy, Debug)]
pub struct SourceSpan {
    /// The first token, or a group with its delimiters.
    pub first: Span,
    /// The last one; it may be the first.
    pub last: Span,
}

/// Index into [`Origins`]: where in the source something was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct OriginId(pub u32);

/// The source spans behind the model's [`OriginId`]s.
#[derive(Debug, Default)]
pub(crate) struct Origins {
    spans: Vec<SourceSpan>,
}

impl Origins {
    pub(crate) fn add(&mut self, span: SourceSpan) -> OriginId {
        self.spans.push(span);
        OriginId(self.spans.len() as u32 - 1)
    }

    pub(crate) fn span(&self, origin: OriginId) -> SourceSpan {
        self.spans[origin.0 as usize]
    }
}

impl SourceSpan {
    /// One token, or a group with its delimiters.
    pub(crate) fn single(span: Span) -> Self {
        SourceSpan {
            first: span,
            last: span,
        }
    }

    /// From the start of `self` to the end of `last`.
    pub(crate) fn to(self, last: SourceSpan) -> Self {
        SourceSpan {
            first: self.first,
            last: last.last,
        }
    }
}

impl From<Span> for SourceSpan {
    fn from(span: Span) -> Self {
        SourceSpan::single(span)
    }
}

impl From<&Ident> for SourceSpan {
    fn from(ident: &Ident) -> Self {
        SourceSpan::single(ident.span())
    }
}
