//! A client of the browser's DevTools protocol: commands, their answers, and events in between.

use serde_json::{Value, json};
use std::net::TcpStream;
use std::time::Duration;
use tungstenite::{Message, WebSocket, client::client};

/// After this time without an answer the browser hangs.
const PATIENCE: Duration = Duration::from_secs(30);

/// A connection to one page.
pub(crate) struct DevTools {
    socket: WebSocket<TcpStream>,
    last: u64,
    session: Option<String>,
    /// What the page has reported, in order.
    pub(crate) events: Vec<Value>,
}

impl DevTools {
    /// Connects to the browser and opens an empty page that shares nothing with others.
    pub(crate) fn connect(address: &str) -> Self {
        let place = address.trim_start_matches("ws://");
        let host = place.split('/').next().unwrap_or(place);
        let stream = TcpStream::connect(host).unwrap_or_else(|error| panic!("{host}: {error}"));
        stream
            .set_read_timeout(Some(PATIENCE))
            .expect("a timeout above zero");
        let (socket, _) =
            client(address, stream).unwrap_or_else(|error| panic!("{address}: {error}"));
        let mut tools = Self {
            socket,
            last: 0,
            session: None,
            events: Vec::new(),
        };
        // Ends with the connection: no page stays behind.
        let context = tools.call(
            "Target.createBrowserContext",
            json!({ "disposeOnDetach": true }),
        );
        let target = tools.call(
            "Target.createTarget",
            json!({ "url": "about:blank", "browserContextId": context["browserContextId"] }),
        );
        let attached = tools.call(
            "Target.attachToTarget",
            json!({ "targetId": target["targetId"], "flatten": true }),
        );
        tools.session = attached["sessionId"].as_str().map(String::from);
        tools
    }

    /// Sends a command and waits for its answer.
    ///
    /// # Panics
    /// If the browser refuses it or does not answer.
    pub(crate) fn call(&mut self, method: &str, parameters: Value) -> Value {
        self.try_call(method, parameters)
            .unwrap_or_else(|refusal| panic!("{method}: {refusal}"))
    }

    /// Sends a command and waits for its answer, or for the browser's refusal.
    ///
    /// # Panics
    /// If the browser does not answer.
    pub(crate) fn try_call(&mut self, method: &str, parameters: Value) -> Result<Value, Value> {
        self.last += 1;
        let mut command = json!({ "id": self.last, "method": method, "params": parameters });
        if let Some(session) = &self.session {
            command["sessionId"] = json!(session);
        }
        let sent = self.socket.send(Message::text(command.to_string()));
        sent.unwrap_or_else(|error| panic!("{method}: {error}"));
        loop {
            let answer = self.receive(method);
            if answer["id"] != self.last {
                self.events.push(answer);
                continue;
            }
            return match &answer["error"] {
                Value::Null => Ok(answer["result"].clone()),
                refusal => Err(refusal.clone()),
            };
        }
    }

    /// Waits for an event.
    ///
    /// # Panics
    /// If the browser is silent before.
    pub(crate) fn wait(&mut self, method: &str) {
        while self.events.iter().all(|event| event["method"] != method) {
            let event = self.receive(method);
            self.events.push(event);
        }
    }

    fn receive(&mut self, method: &str) -> Value {
        loop {
            let message = self
                .socket
                .read()
                .unwrap_or_else(|error| panic!("no answer to {method}: {error}"));
            if let Message::Text(text) = message {
                return serde_json::from_str(&text)
                    .unwrap_or_else(|error| panic!("{error} in {text}"));
            }
        }
    }
}
