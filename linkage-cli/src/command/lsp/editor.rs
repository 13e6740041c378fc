//! The messages that the server sends to the editor.

use crossbeam_channel::Sender;
use lsp_server::{Message, Notification, Request};
use lsp_types::PublishDiagnosticsParams;
use lsp_types::notification::{Notification as _, PublishDiagnostics};
use lsp_types::request::{InlayHintRefreshRequest, Request as _};
use serde_json::{Value, json};

use super::client::Client;

/// The editor, as far as messages to it go.
pub(super) struct Editor<'c> {
    sender: &'c Sender<Message>,
    client: Client,
    /// The number of requests so far.
    requests: i32,
    /// The status that it has been sent last.
    is_settled: bool,
}

impl<'c> Editor<'c> {
    pub(super) fn new(sender: &'c Sender<Message>, client: Client) -> Self {
        Self {
            sender,
            client,
            requests: 0,
            is_settled: true,
        }
    }

    /// Sends a message. If the editor is gone, the end of its messages follows.
    pub(super) fn send(&self, message: impl Into<Message>) {
        let _ = self.sender.send(message.into());
    }

    /// Sends messages about a text.
    pub(super) fn publish(&self, messages: PublishDiagnosticsParams) {
        let method = PublishDiagnostics::METHOD.to_owned();
        self.send(Notification::new(method, messages));
    }

    /// Sends messages about several texts.
    pub(super) fn publish_all(&self, messages: Vec<PublishDiagnosticsParams>) {
        messages
            .into_iter()
            .for_each(|messages| self.publish(messages));
    }

    /// Sends the request that hints are asked for again, if the editor knows it.
    pub(super) fn refresh_hints(&mut self) {
        if self.client.refreshes_hints {
            self.requests += 1;
            let method = InlayHintRefreshRequest::METHOD.to_owned();
            self.send(Request::new(self.requests.into(), method, Value::Null));
        }
    }

    /// Sends whether all is computed, if that is new and the editor wants it.
    pub(super) fn show_status(&mut self, is_settled: bool) {
        if self.client.takes_status && self.is_settled != is_settled {
            let status = json!({ "health": "ok", "quiescent": is_settled });
            let method = "experimental/serverStatus".to_owned();
            self.send(Notification::new(method, status));
        }
        self.is_settled = is_settled;
    }
}
