//! A page in the browser, also one that the program `gallery` has written.

use crate::chromium;
use crate::chromium::{Chromium, DevTools};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use std::{env, fs, thread};

// A page in the browser: what it contains, and what it complains about.

/// The data of a report's page, with lists in the place of packed numbers.
pub const REPORT: &str = "JSON.parse(document.getElementById('report').textContent, (_, value) => { \
     const packed = value?.f64; \
     if (Array.isArray(packed)) return Array(packed[1]).fill(packed[0]); \
     if (typeof packed !== 'string') return value; \
     const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0)); \
     return Array.from(new Float64Array(bytes.buffer), (x) => (x === x ? x : null)); })";

/// A page that is shown.
pub struct Page {
    pub(crate) tools: DevTools,
}

impl Page {
    /// Shows the page in this file at the size of a desktop, still until it is told to play. `None` without a browser,
    /// which is printed.
    ///
    /// # Panics
    /// If there is no browser and one is [required](chromium::required); if the page does not get ready.
    #[must_use]
    pub fn open(file: &Path) -> Option<Self> {
        let mut page = Self::empty()?;
        page.still(true);
        page.load(file);
        page.wait("document.body.dataset.ready === 'true'");
        Some(page)
    }

    /// The browser with an empty page.
    ///
    /// # Panics
    /// If there is no browser and one is [required](chromium::required).
    #[must_use]
    pub fn empty() -> Option<Self> {
        let Some(program) = chromium::find() else {
            assert!(
                !chromium::required(),
                "no Chromium on the search path, and none is named by CHROMIUM"
            );
            eprintln!("skipped: no Chromium on the search path, and none is named by CHROMIUM");
            return None;
        };
        let browser = Chromium::shared(&program);
        let mut page = Self {
            tools: DevTools::connect(&browser.address),
        };
        for domain in ["Page", "Runtime", "Log", "Network"] {
            page.tools.call(&format!("{domain}.enable"), json!({}));
        }
        // Beside others, too, it is the one that is looked at.
        page.tools.call(
            "Emulation.setFocusEmulationEnabled",
            json!({ "enabled": true }),
        );
        page.screen(crate::DESKTOP);
        Some(page)
    }

    /// Goes to a file.
    pub fn load(&mut self, file: &Path) {
        let file = file
            .canonicalize()
            .unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        let address = format!("file://{}", file.display());
        let answer = self.tools.call("Page.navigate", json!({ "url": address }));
        assert!(
            answer["errorText"].is_null(),
            "{address}: {}",
            answer["errorText"]
        );
    }

    /// The value of an expression of the page.
    ///
    /// # Panics
    /// If it throws.
    pub fn value(&mut self, expression: &str) -> Value {
        let answer = self.tools.call("Runtime.evaluate", evaluation(expression));
        let thrown = &answer["exceptionDetails"];
        assert!(thrown.is_null(), "{expression}\n{thrown}");
        answer["result"]["value"].clone()
    }

    /// The number that an expression of the page is, as the page has it.
    pub fn number(&mut self, expression: &str) -> f64 {
        let value = self.value(expression);
        value
            .as_f64()
            .unwrap_or_else(|| panic!("{expression} is {value} and no number"))
    }

    /// The words that an expression of the page is.
    pub fn words(&mut self, expression: &str) -> String {
        let value = self.value(expression);
        value
            .as_str()
            .unwrap_or_else(|| panic!("{expression} is {value} and no text"))
            .to_string()
    }

    /// Whether an expression of the page holds.
    pub fn holds(&mut self, expression: &str) -> bool {
        self.value(expression) == Value::Bool(true)
    }

    /// Waits until an expression holds.
    ///
    /// # Panics
    /// If it does not within half a minute; with what the page complains about.
    pub fn wait(&mut self, expression: &str) {
        let begin = Instant::now();
        let tried = format!(
            "(() => {{ try {{ return Boolean({expression}); }} catch {{ return false; }} }})()"
        );
        while !self.holds_yet(&tried) {
            let complaints = self.complaints().join("\n");
            assert!(
                begin.elapsed() < Duration::from_secs(30),
                "never: {expression}\n{complaints}"
            );
            thread::sleep(Duration::from_millis(30));
        }
    }

    /// Whether an expression holds on a page that may be loaded anew meanwhile: the browser then refuses to tell.
    fn holds_yet(&mut self, expression: &str) -> bool {
        let answer = (self.tools).try_call("Runtime.evaluate", evaluation(expression));
        answer.is_ok_and(|answer| answer["result"]["value"] == Value::Bool(true))
    }

    /// The row at which the mechanism stands.
    pub fn row(&mut self) -> usize {
        self.number("Number(document.querySelector('#position').value)") as usize
    }

    /// Exceptions, errors and warnings since the page was opened.
    #[must_use]
    pub fn complaints(&self) -> Vec<String> {
        self.tools.events.iter().filter_map(complaint).collect()
    }

    /// Addresses that the page asked for beside files and what it contains itself.
    #[must_use]
    pub fn requests(&self) -> Vec<String> {
        let events = self.tools.events.iter();
        let requests = events.filter(|event| event["method"] == "Network.requestWillBeSent");
        let addresses = requests.filter_map(|event| event["params"]["request"]["url"].as_str());
        let own = |address: &str| {
            ["file:", "data:", "blob:"]
                .iter()
                .any(|scheme| address.starts_with(scheme))
        };
        addresses
            .filter(|address| !own(address))
            .map(String::from)
            .collect()
    }

    /// Asserts that nothing went wrong so far and nothing was asked of the network.
    pub fn assert_quiet(&mut self) {
        // Whatever happened before this answer has been reported before it.
        self.value("1");
        assert_eq!(self.complaints(), Vec::<String>::new());
        assert_eq!(self.requests(), Vec::<String>::new());
    }
}

fn evaluation(expression: &str) -> Value {
    json!({ "expression": expression, "returnByValue": true, "awaitPromise": true })
}

fn complaint(event: &Value) -> Option<String> {
    let parameters = &event["params"];
    let (level, what) = match event["method"].as_str()? {
        "Runtime.exceptionThrown" => (
            "error",
            &parameters["exceptionDetails"]["exception"]["description"],
        ),
        "Log.entryAdded" => (parameters["entry"]["level"].as_str()?, &parameters["entry"]),
        "Runtime.consoleAPICalled" => (parameters["type"].as_str()?, &parameters["args"]),
        _ => return None,
    };
    matches!(level, "error" | "warning" | "assert").then(|| what.to_string())
}

// Pages that the program `gallery` has written.

/// A report of the gallery.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Its folder's name.
    pub name: String,
    /// Its page.
    pub page: PathBuf,
}

/// The gallery's folder: what `LINKAGE_GALLERY` names, otherwise `target/gallery` of the workspace.
#[must_use]
pub fn folder() -> PathBuf {
    match env::var_os("LINKAGE_GALLERY") {
        Some(named) => PathBuf::from(named),
        None => Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/gallery"),
    }
}

/// A sixth of the reports in the gallery, all of them in long runs: each takes seconds, and they are made of the same parts.
#[must_use]
pub fn some() -> Vec<Entry> {
    linkage_random::one_in(6, entries()).collect()
}

/// The reports in the gallery, by name. Without a gallery none, which is printed.
///
/// # Panics
/// If there is none and a browser is [required](chromium::required).
#[must_use]
pub fn entries() -> Vec<Entry> {
    let folder = folder();
    let mut entries: Vec<Entry> = fs::read_dir(&folder)
        .into_iter()
        .flatten()
        .flatten()
        .map(|item| Entry {
            name: item.file_name().to_string_lossy().into_owned(),
            page: item.path().join("index.html"),
        })
        .filter(|entry| entry.page.is_file())
        .collect();
    entries.sort_by(|a, b| a.name.cmp(&b.name));
    if entries.is_empty() {
        let advice = format!(
            "no report in {}: `cargo test --release -p linkage-tests --test gallery` writes them",
            folder.display()
        );
        assert!(!chromium::required(), "{advice}");
        eprintln!("skipped: {advice}");
    }
    entries
}
