//! The messages of the editor and the results of the worker that have arrived and wait.

use std::collections::VecDeque;
use std::time::Instant;

use crossbeam_channel::{Receiver, TryRecvError, at, never, select};
use lsp_server::{Message, Request, RequestId};
use lsp_types::notification::{Cancel, DidChangeTextDocument, Notification as _};
use serde_json::Value;

use super::worker::{About, Done};

/// Messages in order.
pub(super) struct Queue<'r> {
    receiver: &'r Receiver<Message>,
    done: Receiver<About<Done>>,
    waiting: VecDeque<Message>,
    cancelled: VecDeque<RequestId>,
    /// True if nothing has happened since the last [`Next::Idle`].
    is_idle: bool,
    is_closed: bool,
}

/// The next thing to do.
pub(super) enum Next {
    /// A message.
    Message(Message),
    /// The answer to a request that the editor does not want any more.
    Cancelled(RequestId),
    /// No message waits; given once before the next one.
    Idle,
    /// A result of the worker.
    Done(About<Done>),
    /// The time has come that was asked for.
    Due,
    /// The editor is gone.
    Closed,
    /// The worker is gone, which is a fault of the compiler.
    Stopped,
}

impl<'r> Queue<'r> {
    pub(super) fn new(receiver: &'r Receiver<Message>, done: Receiver<About<Done>>) -> Self {
        Self {
            receiver,
            done,
            waiting: VecDeque::new(),
            cancelled: VecDeque::new(),
            is_idle: true,
            is_closed: false,
        }
    }

    /// Returns the next thing to do; waits for a message, a result or a time if there is nothing.
    pub(super) fn next(&mut self, due: Option<Instant>) -> Next {
        self.take_arrived();
        if let Some(id) = self.cancelled.pop_front() {
            return Next::Cancelled(id);
        }
        if let Some(message) = self.waiting.pop_front() {
            self.is_idle = false;
            return Next::Message(message);
        }
        if self.is_closed {
            return Next::Closed;
        }
        if !self.is_idle {
            self.is_idle = true;
            return Next::Idle;
        }
        let time = due.map_or_else(never, at);
        select! {
            recv(self.receiver) -> message => match message {
                Ok(message) => self.add(message),
                Err(_) => self.is_closed = true,
            },
            recv(self.done) -> done => return done.map_or(Next::Stopped, Next::Done),
            recv(time) -> _ => return Next::Due,
        }
        self.next(due)
    }

    /// Returns true if the text that a request is about changes in a message that waits.
    pub(super) fn changes_later(&self, request: &Request) -> bool {
        let Some(uri) = uri(&request.params) else {
            return false;
        };
        self.waiting.iter().any(|message| match message {
            Message::Notification(notification) => {
                let is_change = notification.method == DidChangeTextDocument::METHOD;
                is_change && self::uri(&notification.params) == Some(uri)
            }
            Message::Request(_) | Message::Response(_) => false,
        })
    }

    fn take_arrived(&mut self) {
        loop {
            match self.receiver.try_recv() {
                Ok(message) => self.add(message),
                Err(TryRecvError::Empty) => return,
                Err(TryRecvError::Disconnected) => {
                    self.is_closed = true;
                    return;
                }
            }
        }
    }

    fn add(&mut self, message: Message) {
        match message {
            Message::Notification(notification) if notification.method == Cancel::METHOD => {
                self.cancel(&notification.params);
            }
            message => self.waiting.push_back(message),
        }
    }

    /// Removes a request that waits. One that has been answered is no longer there.
    fn cancel(&mut self, params: &Value) {
        let id = params.get("id").cloned().unwrap_or_default();
        let Ok(id) = serde_json::from_value::<RequestId>(id) else {
            return;
        };
        let is_meant = |message: &Message| match message {
            Message::Request(request) => request.id == id,
            Message::Notification(_) | Message::Response(_) => false,
        };
        if let Some(index) = self.waiting.iter().position(is_meant) {
            self.waiting.remove(index);
            self.cancelled.push_back(id);
        }
    }
}

/// Returns the text that a message is about.
fn uri(params: &Value) -> Option<&str> {
    params.get("textDocument")?.get("uri")?.as_str()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crossbeam_channel::unbounded;
    use lsp_server::Notification;
    use serde_json::json;

    fn hover(id: i32, uri: &str) -> Message {
        let params = json!({ "textDocument": { "uri": uri } });
        Request::new(id.into(), "textDocument/hover".to_owned(), params).into()
    }

    fn change(uri: &str) -> Message {
        let params = json!({ "textDocument": { "uri": uri } });
        Notification::new(DidChangeTextDocument::METHOD.to_owned(), params).into()
    }

    fn cancel(id: i32) -> Message {
        Notification::new(Cancel::METHOD.to_owned(), json!({ "id": id })).into()
    }

    /// The messages in the order in which they are handled, and those that are outdated.
    fn handled(messages: Vec<Message>) -> Vec<String> {
        let (sender, receiver) = unbounded();
        messages
            .into_iter()
            .for_each(|message| sender.send(message).expect("open"));
        drop(sender);
        let (_worker, done) = unbounded();
        let mut queue = Queue::new(&receiver, done);
        let mut found = Vec::new();
        loop {
            found.push(match queue.next(None) {
                Next::Message(Message::Request(request)) => {
                    let word = if queue.changes_later(&request) {
                        "outdated"
                    } else {
                        "request"
                    };
                    format!("{word} {}", request.id)
                }
                Next::Message(_) => "change".to_owned(),
                Next::Cancelled(id) => format!("cancelled {id}"),
                Next::Idle => "idle".to_owned(),
                Next::Closed => return found,
                Next::Done(_) | Next::Due | Next::Stopped => panic!("there is no worker"),
            });
        }
    }

    #[test]
    fn cancelled_and_outdated_requests_are_found() {
        let messages = vec![
            change("a"),
            hover(1, "a"),
            hover(2, "b"),
            hover(3, "a"),
            change("a"),
            hover(4, "a"),
            cancel(3),
            cancel(9),
        ];
        let expected = [
            "cancelled 3",
            "change",
            "outdated 1",
            "request 2",
            "change",
            "request 4",
        ];
        assert_eq!(handled(messages), expected);
    }

    #[test]
    fn messages_come_before_results_and_times() {
        let (sender, receiver) = unbounded();
        let (worker, done) = unbounded();
        let mut queue = Queue::new(&receiver, done);
        let now = Some(Instant::now());
        sender.send(change("a")).expect("open");
        assert!(matches!(queue.next(now), Next::Message(_)));
        assert!(matches!(queue.next(now), Next::Idle));
        assert!(matches!(queue.next(now), Next::Due));
        drop(worker);
        assert!(matches!(queue.next(None), Next::Stopped));
        drop(sender);
        assert!(matches!(queue.next(now), Next::Closed | Next::Stopped));
    }
}
