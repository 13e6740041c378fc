//! The texts that are open in the editor.

use std::collections::BTreeMap;

use linkage_editor::{Document, Encoding, Lines};
use lsp_server::Notification;
use lsp_types::notification::{
    DidChangeTextDocument, DidCloseTextDocument, DidOpenTextDocument, Notification as _,
};
use lsp_types::{
    DidChangeTextDocumentParams, DidCloseTextDocumentParams, DidOpenTextDocumentParams,
    PublishDiagnosticsParams, TextDocumentContentChangeEvent, Uri,
};
use serde_json::Value;

use super::convert;

/// All open texts.
pub(super) struct Documents {
    pub(super) encoding: Encoding,
    open: BTreeMap<String, Open>,
}

/// An open text.
struct Open {
    uri: Uri,
    version: i32,
    /// The text, which may be newer than the one that has been analysed.
    text: String,
    document: Document,
    /// True if the messages of this text have not been sent.
    is_new: bool,
}

impl Open {
    /// Returns the document of the newest text.
    fn present(&mut self) -> &Document {
        if self.document.text() != self.text {
            self.document.set_text(&self.text);
        }
        &self.document
    }
}

impl Documents {
    /// Starts without texts.
    pub(super) fn new(encoding: Encoding) -> Self {
        Self {
            encoding,
            open: BTreeMap::new(),
        }
    }

    /// Returns an open text, analysed.
    pub(super) fn find(&mut self, uri: &Uri) -> Option<&Document> {
        self.open.get_mut(uri.as_str()).map(Open::present)
    }

    /// Notes that a text has been opened, changed or closed. Returns the messages to send of a closed
    /// one, which are none. Other notifications, and those that cannot be read, change nothing.
    pub(super) fn notified(
        &mut self,
        notification: Notification,
    ) -> Option<PublishDiagnosticsParams> {
        let Notification { method, params } = notification;
        match method.as_str() {
            DidOpenTextDocument::METHOD => self.opened(read(params)?),
            DidChangeTextDocument::METHOD => self.changed(read(params)?),
            DidCloseTextDocument::METHOD => {
                let params: DidCloseTextDocumentParams = read(params)?;
                let uri = params.text_document.uri;
                self.open.remove(uri.as_str());
                return Some(PublishDiagnosticsParams::new(uri, Vec::new(), None));
            }
            _ => {}
        }
        None
    }

    fn opened(&mut self, params: DidOpenTextDocumentParams) {
        let opened = params.text_document;
        let is_rust = opened.language_id == "rust" || opened.uri.as_str().ends_with(".rs");
        let name = if is_rust { "text.rs" } else { "text.mech" };
        let open = Open {
            version: opened.version,
            document: Document::new(name, &opened.text),
            text: opened.text,
            is_new: true,
            uri: opened.uri.clone(),
        };
        self.open.insert(opened.uri.as_str().to_owned(), open);
    }

    fn changed(&mut self, params: DidChangeTextDocumentParams) {
        let encoding = self.encoding;
        let changed = params.text_document;
        let Some(open) = self.open.get_mut(changed.uri.as_str()) else {
            return;
        };
        for change in params.content_changes {
            apply(&mut open.text, change, encoding);
        }
        open.version = changed.version;
        open.is_new = true;
    }

    /// Returns the messages of all texts that have changed since the last call.
    pub(super) fn changed_messages(&mut self) -> Vec<PublishDiagnosticsParams> {
        let encoding = self.encoding;
        let changed = self.open.values_mut().filter(|open| open.is_new);
        let messages = changed.map(|open| {
            open.is_new = false;
            let (uri, version) = (open.uri.clone(), open.version);
            let diagnostics = convert::diagnostics(open.present(), &uri, encoding);
            PublishDiagnosticsParams::new(uri, diagnostics, Some(version))
        });
        messages.collect()
    }
}

/// Reads the parameters of a notification; `None` if they are others.
fn read<P: serde::de::DeserializeOwned>(params: Value) -> Option<P> {
    serde_json::from_value(params).ok()
}

/// Makes a change, of some bytes or of the whole text.
fn apply(text: &mut String, change: TextDocumentContentChangeEvent, encoding: Encoding) {
    let Some(range) = change.range else {
        *text = change.text;
        return;
    };
    let lines = Lines::new(text);
    let [start, end] = [range.start, range.end]
        .map(|position| lines.offset(text, convert::position_of_editor(position), encoding));
    text.replace_range(start..end.max(start), &change.text);
}

#[cfg(test)]
mod tests {
    use super::*;
    use lsp_types::{Position, Range};

    #[test]
    fn changes_are_made_one_after_the_other() {
        let mut text = "a𝛗b\ncd".to_owned();
        let change = |range: Option<[u32; 4]>, text: &str| TextDocumentContentChangeEvent {
            range: range.map(|[a, b, c, d]| Range::new(Position::new(a, b), Position::new(c, d))),
            range_length: None,
            text: text.to_owned(),
        };
        apply(&mut text, change(Some([0, 1, 0, 3]), "x"), Encoding::Utf16);
        assert_eq!(text, "axb\ncd");
        apply(&mut text, change(Some([0, 3, 1, 1]), ""), Encoding::Utf16);
        assert_eq!(text, "axbd");
        // An end before the start, and places outside of the text.
        apply(&mut text, change(Some([0, 9, 0, 0]), "!"), Encoding::Utf8);
        assert_eq!(text, "axbd!");
        apply(&mut text, change(None, "new"), Encoding::Utf8);
        assert_eq!(text, "new");
    }
}
