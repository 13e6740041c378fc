//! The place that a request is about.

use linkage_editor::Document;
use lsp_types::{Location, TextDocumentPositionParams, TextEdit, Uri, WorkspaceEdit};
use serde_json::Value;

use super::client::Client;
use super::convert;

/// The place that a request is about.
#[derive(Clone, Copy)]
pub(super) struct At<'d> {
    pub(super) document: &'d Document,
    pub(super) uri: &'d Uri,
    /// The byte; 0 for a request about a whole text.
    pub(super) offset: usize,
    pub(super) client: Client,
}

/// Returns the text that a request is about, and its position if it has one.
pub(super) fn location(params: &Value) -> Result<(Uri, lsp_types::Position), serde_json::Error> {
    if params.get("position").is_some() {
        let location: TextDocumentPositionParams = serde_json::from_value(params.clone())?;
        return Ok((location.text_document.uri, location.position));
    }
    let text = params.get("textDocument").cloned().unwrap_or_default();
    let text: lsp_types::TextDocumentIdentifier = serde_json::from_value(text)?;
    Ok((text.uri, lsp_types::Position::default()))
}

impl At<'_> {
    /// Returns the positions of some bytes.
    pub(super) fn range(&self, bytes: &std::ops::Range<usize>) -> lsp_types::Range {
        convert::range(self.document, bytes, self.client.encoding)
    }

    /// Returns some bytes with the address of the text.
    pub(super) fn location(&self, bytes: &std::ops::Range<usize>) -> Location {
        Location::new(self.uri.clone(), self.range(bytes))
    }

    /// Returns changes of the text alone.
    pub(super) fn edit(&self, edits: Vec<TextEdit>) -> WorkspaceEdit {
        WorkspaceEdit::new([(self.uri.clone(), edits)].into())
    }
}
