//! Results of resolving an expression besides the expression: messages, origins, and two facts
//! about the mechanism.

use std::fmt::Display;

use crate::diagnostic::{Diagnostics, Message, OriginId, Origins, SourceSpan};
use crate::model::types::Name;

/// Collects results of resolving that are no expressions.
#[derive(Default)]
pub(in crate::model) struct Sink {
    pub(in crate::model) origins: Origins,
    pub(in crate::model) diagnostics: Diagnostics,
    /// Names declared by numbers without a unit that were found next to lengths.
    pub(in crate::model) suspects: Vec<Name>,
    /// Number of components of the vectors of bodies and loads; `None` before the first.
    pub(in crate::model) components: Option<usize>,
}

impl Sink {
    /// Adds a message without a second line.
    pub(in crate::model) fn error(
        &mut self,
        span: SourceSpan,
        message: impl Into<String>,
    ) -> &mut Message {
        self.diagnostics.error(span, message)
    }

    /// Adds a message with a second line that contains the text to write.
    pub(in crate::model) fn error_with_help(
        &mut self,
        span: SourceSpan,
        fact: impl Display,
        help: impl Display,
    ) -> &mut Message {
        self.diagnostics.error_with_help(span, fact, help)
    }

    /// Returns the number of a new origin.
    pub(in crate::model) fn add_origin(&mut self, span: SourceSpan) -> OriginId {
        self.origins.add(span)
    }

    /// Returns the source text of an origin.
    pub(in crate::model) fn span(&self, origin: OriginId) -> SourceSpan {
        self.origins.span(origin)
    }
}
