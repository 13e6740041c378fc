//! The page in the browser, with words for what tests do in it.

use linkage_browser::Page;
use serde_json::{Value, json};

use crate::built::built;

/// The document of the frame.
pub(crate) const FRAME: &str = "document.getElementById('frame').contentDocument";
/// The root of the editor.
pub(crate) const EDITOR: &str = "document.getElementById('editor').shadowRoot";

/// A function for tests in the page: resolves with the time at which the page shows another state than
/// the one before.
const RENEWED: &str = "globalThis.renewed = (before) => new Promise((done) => { \
     const observer = new MutationObserver(() => { \
       if (document.body.dataset.shown === before) return; \
       observer.disconnect(); \
       done(performance.now()); \
     }); \
     observer.observe(document.body, { attributes: true }); \
   }); null";

/// A playground that has shown its first mechanism.
pub(crate) struct Shown {
    pub(crate) page: Page,
}

impl Shown {
    /// Opens the page from disk. `None` without a browser, or if it cannot be built.
    pub(crate) fn open() -> Option<Self> {
        let file = &built()?.page;
        let mut page = Page::empty()?;
        page.still(true);
        page.load(file);
        page.wait("document.body.dataset.shown");
        page.value(RENEWED);
        Some(Self { page })
    }

    /// The text in the editor.
    pub(crate) fn text(&mut self) -> String {
        self.page.words("playground.editor.text()")
    }

    /// Does something that changes the text, and waits for the result of the last analysis.
    pub(crate) fn after<R>(&mut self, change: impl FnOnce(&mut Page) -> R) -> R {
        let before = self.page.number("Number(document.body.dataset.shown)");
        let result = change(&mut self.page);
        self.page.wait(&format!(
            "Number(document.body.dataset.shown) > {before} && !playground.compiler.isBusy"
        ));
        result
    }

    /// Types after some words, at their first place in the text.
    pub(crate) fn type_after(&mut self, words: &str, typed: &str) {
        let offset = self.text().find(words).expect("the words") + words.len();
        self.page.value(&format!(
            "(() => {{ const {{ view }} = playground.editor; view.focus(); view.dispatch({{ selection: {{ anchor: {offset} }} }}); }})()"
        ));
        self.page.type_text(typed);
    }

    /// Chooses an example.
    pub(crate) fn choose(&mut self, name: &str) {
        self.after(|page| {
            page.value(&format!(
                "(() => {{ const list = document.getElementById('examples'); list.value = 'example {name}'; list.dispatchEvent(new Event('change')); }})()"
            ))
        });
    }

    /// The messages below the text.
    pub(crate) fn messages(&mut self) -> String {
        self.page
            .words("document.getElementById('messages').innerText")
    }

    /// The middle of a point of the drawing, in pixels of the window.
    pub(crate) fn point(&mut self, name: &str) -> (f64, f64) {
        let value = self.page.value(&format!(
            "(() => {{ const frame = document.getElementById('frame').getBoundingClientRect(); \
             const mark = {FRAME}.querySelector('[data-point=\"{name}\"] .mark').getBoundingClientRect(); \
             return [frame.left + mark.left + mark.width / 2, frame.top + mark.top + mark.height / 2]; }})()"
        ));
        (number(&value[0]), number(&value[1]))
    }

    /// Undoes the last step in the editor.
    pub(crate) fn undo(&mut self) {
        self.after(|page| page.value("playground.editor.undo()"));
    }

    /// The answer of the compiler in the worker.
    pub(crate) fn ask(&mut self, request: &Value) -> Value {
        let answer = self
            .page
            .words(&format!("playground.compiler.ask({request})"));
        serde_json::from_str(&answer).expect("JSON")
    }

    /// The files of a format, each with name and text.
    pub(crate) fn exported(&mut self, format: &str) -> Vec<(String, String)> {
        let text = self.text();
        let name = self
            .page
            .words(&format!("{FRAME}.getElementById('title').textContent"));
        let request = json!({ "do": "export", "text": text, "format": format, "mechanism": name });
        let files = self.ask(&request);
        let files = files.as_array().unwrap_or_else(|| panic!("{files}"));
        let word = |file: &Value, field: &str| file[field].as_str().expect("a text").to_owned();
        files
            .iter()
            .map(|file| (word(file, "name"), word(file, "text")))
            .collect()
    }
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}
