//! Places in the source: spans where there are tokens, ids of them in all phases after `model`.

use std::ops::Range;

use proc_macro2::{Ident, Span};

/// First and last token of a piece of source text; messages underline all text between them.
///
/// Outside of a procedural macro, lines and columns of both are known if proc-macro2 has its
/// feature `span-locations`.
#[derive(Clone, Copy, Debug)]
pub struct SourceSpan {
    /// The first token, or a group with its delimiters.
    pub first: Span,
    /// The last one; it may be the first.
    pub last: Span,
}

/// Index into [`Origins`]: where in the source something was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct OriginId(pub u32);

/// The source spans of the model's [`OriginId`]s, and the parts of the mechanism that contain them.
#[derive(Clone, Debug, Default)]
pub struct Origins {
    spans: Vec<SourceSpan>,
    /// Ranges of the origins of parts, with their names. A part within a part comes before the part
    /// around it.
    parts: Vec<(Range<u32>, String)>,
}

impl Origins {
    pub fn add(&mut self, span: SourceSpan) -> OriginId {
        self.spans.push(span);
        OriginId(self.spans.len() as u32 - 1)
    }

    /// Adds all origins of a part. Returns the offset of their numbers.
    pub fn add_part(&mut self, name: &str, origins: &Origins) -> u32 {
        let first = self.spans.len() as u32;
        self.spans.extend(&origins.spans);
        let inner = origins.parts.iter().map(|(range, inner)| {
            let range = first + range.start..first + range.end;
            (range, format!("{name}.{inner}"))
        });
        self.parts.extend(inner);
        self.parts
            .push((first..self.spans.len() as u32, name.to_owned()));
        first
    }

    pub fn span(&self, origin: OriginId) -> SourceSpan {
        self.spans[origin.0 as usize]
    }

    /// The name of the part in which something was written, `None` in the mechanism itself.
    pub fn part(&self, origin: OriginId) -> Option<&str> {
        let mut parts = self.parts.iter();
        let found = parts.find(|(range, _)| range.contains(&origin.0));
        found.map(|(_, name)| name.as_str())
    }
}

impl OriginId {
    /// The same place of a part, in the mechanism around it; see [`Origins::add_part`].
    pub fn in_part(self, first: u32) -> Self {
        OriginId(self.0 + first)
    }
}

impl SourceSpan {
    /// One token, or a group with its delimiters.
    pub fn single(span: Span) -> Self {
        SourceSpan {
            first: span,
            last: span,
        }
    }

    /// Returns the span from the start of `self` to the end of `last`.
    pub fn to(self, last: SourceSpan) -> Self {
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
