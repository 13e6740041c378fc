//! Places in the source: spans where there are tokens, ids of them behind `model`.

use std::ops::Range;

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

/// The source spans behind the model's [`OriginId`]s, and the parts of the mechanism that they stand in.
#[derive(Clone, Debug, Default)]
pub(crate) struct Origins {
    spans: Vec<SourceSpan>,
    /// Where the origins of each part begin and end, with its name; a part within a part stands before it.
    parts: Vec<(Range<u32>, String)>,
}

impl Origins {
    pub(crate) fn add(&mut self, span: SourceSpan) -> OriginId {
        self.spans.push(span);
        OriginId(self.spans.len() as u32 - 1)
    }

    /// All origins of a part; the answer is what is to be added to their numbers.
    pub(crate) fn add_part(&mut self, name: &str, own: &Origins) -> u32 {
        let first = self.spans.len() as u32;
        self.spans.extend(&own.spans);
        let inner = own.parts.iter().map(|(range, inner)| {
            let range = first + range.start..first + range.end;
            (range, format!("{name}.{inner}"))
        });
        self.parts.extend(inner);
        self.parts
            .push((first..self.spans.len() as u32, name.to_owned()));
        first
    }

    pub(crate) fn span(&self, origin: OriginId) -> SourceSpan {
        self.spans[origin.0 as usize]
    }

    /// The name of the part in which something was written, `None` in the mechanism itself.
    pub(crate) fn part(&self, origin: OriginId) -> Option<&str> {
        let mut parts = self.parts.iter();
        let found = parts.find(|(range, _)| range.contains(&origin.0));
        found.map(|(_, name)| name.as_str())
    }
}

impl OriginId {
    /// The same place of a part, in the mechanism around it; see [`Origins::add_part`].
    pub(crate) fn in_part(self, first: u32) -> Self {
        OriginId(self.0 + first)
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
