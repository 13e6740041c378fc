//! The texts that are open in the editor.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use crossbeam_channel::Sender;
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

use super::client::Client;
use super::convert;
use super::worker::{About, Done, Work};

/// The time that the messages about a text wait for its solution, so that most texts have all
/// messages at once.
const PATIENCE: Duration = Duration::from_millis(10);

/// All open texts.
pub(super) struct Documents {
    pub(super) client: Client,
    open: BTreeMap<String, Open>,
    worker: Sender<About<Work>>,
}

/// An open text.
struct Open {
    uri: Uri,
    version: i32,
    /// The text, which may be newer than the one that has been read.
    text: String,
    document: Document,
    /// True if the text is newer than the last [`Documents::read_changed`].
    is_new: bool,
    /// The time at which messages are sent, if the text has not been solved until then.
    due: Option<Instant>,
}

impl Open {
    /// Returns the document of the newest text, whose solution may be at work.
    fn present(&mut self, worker: &Sender<About<Work>>) -> &Document {
        if self.document.text() != self.text
            && let Some(solving) = self.document.read(&self.text)
        {
            send(worker, &self.uri, Work::Solve(solving));
        }
        &self.document
    }

    fn messages(&self, client: Client) -> PublishDiagnosticsParams {
        let diagnostics = convert::diagnostics(&self.document, &self.uri, client);
        PublishDiagnosticsParams::new(self.uri.clone(), diagnostics, Some(self.version))
    }
}

/// The consequences of a result of the worker.
pub(super) enum Change {
    /// New messages.
    Messages(PublishDiagnosticsParams),
    /// New values of names.
    Values,
}

impl Documents {
    /// Starts without texts.
    pub(super) fn new(client: Client, worker: Sender<About<Work>>) -> Self {
        Self {
            client,
            open: BTreeMap::new(),
            worker,
        }
    }

    /// Returns an open text, read.
    pub(super) fn find(&mut self, uri: &Uri) -> Option<&Document> {
        let open = self.open.get_mut(uri.as_str())?;
        Some(open.present(&self.worker))
    }

    /// Returns true if no text is read, solved or evaluated.
    pub(super) fn are_settled(&self) -> bool {
        let mut open = self.open.values();
        open.all(|open| !open.is_new && open.document.is_settled())
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
            document: Document::new(name, ""),
            text: opened.text,
            is_new: true,
            due: None,
            uri: opened.uri.clone(),
        };
        self.open.insert(opened.uri.as_str().to_owned(), open);
    }

    fn changed(&mut self, params: DidChangeTextDocumentParams) {
        let encoding = self.client.encoding;
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

    /// Reads all texts that have changed since the last call. Returns the messages of those that
    /// need no solution; the others are [due](Self::due).
    pub(super) fn read_changed(&mut self) -> Vec<PublishDiagnosticsParams> {
        let mut messages = Vec::new();
        for open in self.open.values_mut().filter(|open| open.is_new) {
            open.is_new = false;
            let is_solved = open.present(&self.worker).is_solved();
            open.due = (!is_solved).then(|| Instant::now() + PATIENCE);
            if is_solved {
                messages.push(open.messages(self.client));
            }
        }
        messages
    }

    /// Returns the time at which the next messages are to be sent.
    pub(super) fn due(&self) -> Option<Instant> {
        self.open.values().filter_map(|open| open.due).min()
    }

    /// Returns the messages that are due: those of the first stage.
    pub(super) fn due_messages(&mut self) -> Vec<PublishDiagnosticsParams> {
        let now = Instant::now();
        let client = self.client;
        let open = self.open.values_mut();
        let due = open.filter(|open| open.due.is_some_and(|due| due <= now));
        due.map(|open| {
            open.due = None;
            open.messages(client)
        })
        .collect()
    }

    /// Takes a result of the worker; that of an earlier version changes nothing.
    pub(super) fn take(&mut self, (uri, done): About<Done>) -> Option<Change> {
        let open = self.open.get_mut(&uri)?;
        match done {
            Done::Evaluated(values) => open.document.take_values(values).then_some(Change::Values),
            Done::Solved(solved) => {
                if let Some(evaluation) = open.document.finish(solved) {
                    send(&self.worker, &open.uri, Work::Evaluate(evaluation));
                }
                // A newer text has other messages.
                let is_present = open.document.is_solved() && !open.is_new;
                is_present.then(|| {
                    open.due = None;
                    Change::Messages(open.messages(self.client))
                })
            }
        }
    }
}

/// Hands work to the worker. If it is gone, the end of its results follows.
fn send(worker: &Sender<About<Work>>, uri: &Uri, work: Work) {
    let _ = worker.send((uri.as_str().to_owned(), work));
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
