//! The abilities of the editor that matter.

use linkage_editor::Encoding;
use lsp_types::{MarkupKind, PositionEncodingKind};
use serde_json::{Value, json};

/// The abilities of the editor that matter.
///
/// Nothing else is read of what it offers: any other part may be of a later protocol.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Client {
    /// The unit of columns: bytes if the editor knows them, else that of UTF-16.
    pub(super) encoding: Encoding,
    /// The form of hover.
    pub(super) hover: Form,
    /// The form of descriptions of words that can be written.
    pub(super) completion: Form,
    /// The form of descriptions of calls.
    pub(super) signature: Form,
    /// True if it shows the further places of messages; otherwise they are part of the messages.
    pub(super) shows_related: bool,
    /// True if names can be within names.
    pub(super) has_tree_of_symbols: bool,
    /// True if it asks whether a name can be changed.
    pub(super) prepares_rename: bool,
    /// True if it takes changes as such, and not commands alone.
    pub(super) takes_actions: bool,
    /// True if it asks for hints again on request.
    pub(super) refreshes_hints: bool,
    /// True if it wants to know when all is computed, by the notification of rust-analyzer.
    pub(super) takes_status: bool,
}

/// The form of texts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    Markdown,
    Plain,
}

impl Client {
    /// Reads the parameters of `initialize`.
    pub(super) fn new(params: &Value) -> Self {
        let offered = |path: &str| params.pointer(&format!("/capabilities/{path}"));
        let is_true = |path: &str| offered(path) == Some(&json!(true));
        let has = |path: &str, value: Value| {
            let list = offered(path).and_then(Value::as_array);
            list.map(|list| list.contains(&value))
        };
        let form = |path: &str| match has(path, json!(MarkupKind::Markdown)) {
            Some(false) => Form::Plain,
            Some(true) | None => Form::Markdown,
        };
        let bytes = json!(PositionEncodingKind::UTF8);
        Self {
            encoding: match has("general/positionEncodings", bytes) {
                Some(true) => Encoding::Utf8,
                Some(false) | None => Encoding::Utf16,
            },
            hover: form("textDocument/hover/contentFormat"),
            completion: form("textDocument/completion/completionItem/documentationFormat"),
            signature: form("textDocument/signatureHelp/signatureInformation/documentationFormat"),
            shows_related: is_true("textDocument/publishDiagnostics/relatedInformation"),
            has_tree_of_symbols: is_true(
                "textDocument/documentSymbol/hierarchicalDocumentSymbolSupport",
            ),
            prepares_rename: is_true("textDocument/rename/prepareSupport"),
            takes_actions: offered("textDocument/codeAction/codeActionLiteralSupport").is_some(),
            refreshes_hints: is_true("workspace/inlayHint/refreshSupport"),
            takes_status: is_true("experimental/serverStatusNotification"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_of_other_types_are_not_read() {
        let nothing = Client::new(&json!({}));
        let odd = json!({ "capabilities": {
            "general": { "positionEncodings": "utf-8" },
            "textDocument": { "hover": [], "rename": { "prepareSupport": 1 } },
            "workspace": null,
        } });
        assert_eq!(Client::new(&odd), nothing);
        assert_eq!(
            (nothing.encoding, nothing.hover),
            (Encoding::Utf16, Form::Markdown)
        );
    }
}
