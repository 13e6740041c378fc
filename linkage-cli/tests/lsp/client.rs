//! An editor: sends messages, and waits for answers.

use std::io::BufReader;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use lsp_server::{Message, Notification, Request, RequestId, Response};
use serde_json::{Value, json};

/// The address of the text that tests edit.
pub(crate) const URI: &str = "file:///folder%20of%20mine/mechanism.mech";

const PUBLISH: &str = "textDocument/publishDiagnostics";

/// A running server and its editor.
pub(crate) struct Client {
    child: Child,
    input: Option<ChildStdin>,
    output: BufReader<ChildStdout>,
    next: i32,
    version: i32,
}

impl Client {
    /// Starts a server, as an editor with these encodings of positions that takes its status.
    pub(crate) fn start(encodings: &[&str]) -> (Self, Value) {
        let capabilities = json!({
            "general": { "positionEncodings": encodings },
            "experimental": { "serverStatusNotification": true },
            // Not as the protocol has it: the server reads only what it needs.
            "notebookDocument": {},
        });
        Self::start_as(json!({ "capabilities": capabilities }))
    }

    /// Starts a server with these parameters of `initialize`.
    pub(crate) fn start_as(params: Value) -> (Self, Value) {
        let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
        command
            .arg("lsp")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped());
        let mut child = command.spawn().expect("it runs");
        let input = child.stdin.take();
        let output = BufReader::new(child.stdout.take().expect("its output"));
        let mut client = Self {
            child,
            input,
            output,
            next: 0,
            version: 0,
        };
        let answer = client.ask("initialize", params);
        client.tell("initialized", json!({}));
        (client, answer)
    }

    fn send(&mut self, message: Message) {
        let input = self.input.as_mut().expect("it is open");
        message.write(input).expect("the server reads");
    }

    fn receive(&mut self) -> Message {
        let message = Message::read(&mut self.output).expect("a message");
        message.expect("the server runs")
    }

    /// Sends a notification.
    pub(crate) fn tell(&mut self, method: &str, params: Value) {
        self.send(Notification::new(method.to_owned(), params).into());
    }

    /// Sends a request, and returns its number.
    pub(crate) fn begin(&mut self, method: &str, params: Value) -> i32 {
        self.next += 1;
        self.send(Request::new(self.next.into(), method.to_owned(), params).into());
        self.next
    }

    /// Returns the answer to a request; other messages that come before it are left out.
    pub(crate) fn answer(&mut self, id: i32) -> Response {
        loop {
            match self.receive() {
                Message::Response(response) if response.id == id.into() => return response,
                Message::Response(other) => panic!("the answer to {}", other.id),
                Message::Notification(_) => {}
                Message::Request(_) => {}
            }
        }
    }

    /// Sends a request, and returns the result.
    pub(crate) fn ask(&mut self, method: &str, params: Value) -> Value {
        let id = self.begin(method, params);
        let response = self.answer(id);
        let result = response.response_result;
        result.unwrap_or_else(|error| panic!("{method}: {error:?}"))
    }

    /// Sends a request about a place of the text.
    pub(crate) fn ask_at(&mut self, method: &str, line: usize, character: usize) -> Value {
        let position = json!({ "line": line, "character": character });
        self.ask(
            method,
            json!({ "textDocument": { "uri": URI }, "position": position }),
        )
    }

    /// Sends a request about the whole text.
    pub(crate) fn ask_of_text(&mut self, method: &str) -> Value {
        self.ask(method, json!({ "textDocument": { "uri": URI } }))
    }

    /// Opens a text.
    pub(crate) fn begin_open(&mut self, language: &str, text: &str) {
        self.version += 1;
        let item = json!({
            "uri": URI, "languageId": language, "version": self.version, "text": text,
        });
        self.tell("textDocument/didOpen", json!({ "textDocument": item }));
    }

    /// Opens a text, and returns its messages.
    pub(crate) fn open(&mut self, language: &str, text: &str) -> Value {
        self.begin_open(language, text);
        self.messages()
    }

    /// Changes the whole text.
    pub(crate) fn change_whole(&mut self, text: &str) {
        self.version += 1;
        let params = json!({
            "textDocument": { "uri": URI, "version": self.version },
            "contentChanges": [{ "text": text }],
        });
        self.tell("textDocument/didChange", params);
    }

    /// Waits for a request of the server; returns its number and method.
    pub(crate) fn request_of_server(&mut self) -> (RequestId, String) {
        loop {
            if let Message::Request(request) = self.receive() {
                return (request.id, request.method);
            }
        }
    }

    /// Answers a request of the server.
    pub(crate) fn respond(&mut self, id: RequestId, result: Value) {
        self.send(Response::new_ok(id, result).into());
    }

    /// Changes a piece of the text: from a line and column to others.
    pub(crate) fn change(&mut self, [from, to]: [[usize; 2]; 2], text: &str) {
        self.version += 1;
        let position =
            |[line, character]: [usize; 2]| json!({ "line": line, "character": character });
        let range = json!({ "start": position(from), "end": position(to) });
        let params = json!({
            "textDocument": { "uri": URI, "version": self.version },
            "contentChanges": [{ "range": range, "text": text }],
        });
        self.tell("textDocument/didChange", params);
    }

    /// Returns the next notification, with its method.
    pub(crate) fn notification(&mut self) -> (String, Value) {
        loop {
            match self.receive() {
                Message::Notification(found) => return (found.method, found.params),
                Message::Response(other) => panic!("the answer to {}", other.id),
                Message::Request(_) => {}
            }
        }
    }

    /// Waits for the first messages about the newest version of the text, which need no solution.
    pub(crate) fn first_messages(&mut self) -> Value {
        loop {
            let (method, params) = self.notification();
            if method == PUBLISH && params["version"] == json!(self.version) {
                return params["diagnostics"].clone();
            }
        }
    }

    /// Waits until the server has computed all about the newest version of the text. Returns the
    /// last messages.
    pub(crate) fn messages(&mut self) -> Value {
        let mut last = self.first_messages();
        loop {
            let (method, params) = self.notification();
            match method.as_str() {
                PUBLISH => last = params["diagnostics"].clone(),
                "experimental/serverStatus" if params["quiescent"] == json!(true) => return last,
                _ => {}
            }
        }
    }

    /// Ends the server as the protocol wants it.
    pub(crate) fn stop(mut self) {
        assert_eq!(self.ask("shutdown", Value::Null), Value::Null);
        self.tell("exit", Value::Null);
        let status = self.child.wait().expect("it ends");
        assert!(status.success(), "{status}");
    }

    /// Closes the pipes as an editor that was killed does, and returns whether the server ends.
    pub(crate) fn vanish(mut self) -> bool {
        drop(self.input.take());
        self.child.wait().is_ok()
    }
}

/// Returns the code of an error; `None` for a result.
pub(crate) fn error_code(response: &Response) -> Option<i32> {
    let error = response.response_result.as_ref().err()?;
    Some(error.code)
}
