//! Chromium: finding and starting it, and a client of its DevTools protocol.

use serde_json::{Value, json};
use std::io::{BufRead, BufReader};
use std::net::TcpStream;
use std::os::unix::process::CommandExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::{LazyLock, OnceLock};
use std::time::Duration;
use std::{env, process, thread};
use tungstenite::client::client;
use tungstenite::{Message, WebSocket};

// Finding and starting Chromium.

/// Those without a window first: a page takes them less than half the time.
const NAMES: [&str; 6] = [
    "chromium-headless-shell",
    "chrome-headless-shell",
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
];

/// Nothing but the page: no first-run pages, no services that ask the network.
const FLAGS: [&str; 14] = [
    "--headless=new",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--disable-dev-shm-usage",
    "--no-first-run",
    "--no-default-browser-check",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-default-apps",
    "--disable-extensions",
    "--disable-sync",
    "--hide-scrollbars",
    "--remote-debugging-port=0",
];

/// The browser: what `CHROMIUM` names, otherwise the first that the search path has.
#[must_use]
pub fn find() -> Option<PathBuf> {
    // Asking a program whether it is one takes longer than many a test.
    static FOUND: LazyLock<Option<PathBuf>> = LazyLock::new(search);
    FOUND.clone()
}

fn search() -> Option<PathBuf> {
    if let Some(named) = env::var_os("CHROMIUM") {
        let path = PathBuf::from(named);
        assert!(
            path.is_file(),
            "CHROMIUM is {}: there is no such file",
            path.display()
        );
        return Some(path);
    }
    let path = env::var_os("PATH")?;
    let folders: Vec<PathBuf> = env::split_paths(&path).collect();
    let places = NAMES
        .iter()
        .flat_map(|name| folders.iter().map(move |folder| folder.join(name)));
    places
        .into_iter()
        .find(|place| place.is_file() && answers(place))
}

/// Whether it is a browser, and not only a word about where one is to be had.
fn answers(program: &Path) -> bool {
    let answer = Command::new(program).arg("--version").output();
    answer.is_ok_and(|answer| answer.status.success())
}

/// Whether a missing browser is a failure: `LINKAGE_BROWSER=required`.
#[must_use]
pub fn required() -> bool {
    env::var_os("LINKAGE_BROWSER").is_some_and(|value| value == "required")
}

/// A running browser; it ends with this process.
pub(crate) struct Chromium {
    _child: Child,
    _end: Child,
    /// Where it listens.
    pub(crate) address: String,
}

/// Waits until the tests have ended in whatever way, which closes what it reads; then ends the browser with all its processes.
const END: &str = r#"read -r _; kill -KILL "-$1"; rm -rf "$2""#;

impl Chromium {
    /// The browser of this process: it starts with the first page, once, since starting takes longer than many a test.
    pub(crate) fn shared(program: &Path) -> &'static Self {
        static RUNNING: OnceLock<Chromium> = OnceLock::new();
        RUNNING.get_or_init(|| Self::start(program))
    }

    fn start(program: &Path) -> Self {
        let profile = env::temp_dir().join(format!("linkage-browser-{}", process::id()));
        let mut child = Command::new(program)
            .args(FLAGS)
            .arg(format!("--user-data-dir={}", profile.display()))
            .arg("about:blank")
            .process_group(0)
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap_or_else(|error| panic!("{} does not start: {error}", program.display()));
        let end = Command::new("sh")
            .args(["-c", END, "sh", &child.id().to_string()])
            .arg(&profile)
            .process_group(0)
            .stdin(Stdio::piped())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap_or_else(|error| panic!("sh does not start: {error}"));
        let address = listening(&mut child);
        Self {
            _child: child,
            _end: end,
            address,
        }
    }
}

/// Reads what the browser says until it tells its address, and goes on reading, so that it is never held up.
fn listening(child: &mut Child) -> String {
    let mut lines = BufReader::new(child.stderr.take().expect("stderr is piped")).lines();
    let mut said = Vec::new();
    while let Some(Ok(line)) = lines.next() {
        if let Some(address) = line.strip_prefix("DevTools listening on ") {
            let address = address.trim().to_string();
            thread::spawn(move || lines.for_each(drop));
            return address;
        }
        said.push(line);
    }
    panic!("the browser ended before it listened:\n{}", said.join("\n"));
}

// A client of the browser's DevTools protocol: commands, their answers, and events in between.

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
