//! Work that takes long: the drawing is marked, a key or a button ends the work, and messages do
//! not wait for it.

use std::thread;
use std::time::Duration;

use linkage_browser::Page;
use serde_json::json;

use crate::page::{FRAME, Shown};

const BUSY: &str = "!document.getElementById('busy').hidden";
const REASON: &str = "document.getElementById('stale')";

/// Counts the ends of workers and lists the requests to them. The worker may get other work in the
/// place of an analysis.
const OBSERVED: &str = "(() => { \
     const { postMessage: post, terminate } = Worker.prototype; \
     globalThis.observed = { stops: 0, asked: [], instead: null }; \
     Worker.prototype.terminate = function () { observed.stops += 1; terminate.call(this); }; \
     Worker.prototype.postMessage = function (data) { \
       const work = data.request?.do; \
       if (work === undefined) return post.call(this, data); \
       observed.asked.push(work); \
       const isReplaced = work === 'analyse' && observed.instead !== null; \
       const request = isReplaced ? observed.instead : data.request; \
       if (isReplaced) observed.instead = null; \
       post.call(this, { ...data, request }); \
     }; })()";

fn open() -> Option<Shown> {
    let mut shown = Shown::open()?;
    shown.page.value(OBSERVED);
    Some(shown)
}

/// Changes the text, whose analysis then takes years.
fn occupy(shown: &mut Shown) {
    let request = json!({
        "do": "sweep", "text": shown.text(), "function": "motion", "positions": 100_000, "repeats": 1e15,
    });
    shown.page.value(&format!(
        "observed.instead = {request}, {}",
        written("// a key")
    ));
}

/// A change of the text at its beginning.
fn written(words: &str) -> String {
    format!(
        "playground.editor.view.dispatch({{ changes: {{ from: 0, insert: {} }} }})",
        json!(format!("{words}\n"))
    )
}

/// True while the replaced analysis is computed.
const ANALYSED: &str =
    "observed.instead === null && playground.compiler.present?.request.do === 'analyse'";

fn pause(milliseconds: u64) {
    thread::sleep(Duration::from_millis(milliseconds));
}

fn is_pale(page: &mut Page) -> bool {
    page.holds(&format!("{FRAME}.body.classList.contains('stale')"))
}

fn reason(page: &mut Page) -> String {
    page.words(&format!("{REASON}.innerText"))
}

#[test]
fn a_computation_that_does_not_end_is_stopped() {
    let Some(mut shown) = open() else {
        return;
    };
    assert!(!is_pale(&mut shown.page));
    occupy(&mut shown);
    shown.page.wait(BUSY);
    // The page stays alive meanwhile, and the drawing is marked as older than the text.
    assert_eq!(shown.page.number("1 + 1"), 2.0);
    assert!(is_pale(&mut shown.page));
    let words = reason(&mut shown.page);
    assert!(words.contains("at work on the last change"), "{words}");
    shown.page.shoot("playground_late");
    shown.page.click("#stop");
    assert!(!shown.page.holds(BUSY));
    assert!(is_pale(&mut shown.page));
    let words = reason(&mut shown.page);
    assert!(
        words.contains("was stopped") && words.contains("the mechanism before the last change"),
        "{words}"
    );
    shown.after(|page| page.click("#stale button"));
    assert!(shown.page.holds(&format!("{REASON}.hidden")));
    assert!(!is_pale(&mut shown.page));
    assert_eq!(shown.messages(), "");
    shown.page.assert_quiet();
}

/// The mark is next to the mechanism, where a phone has the button as well.
#[test]
fn the_button_is_next_to_the_mechanism() {
    let Some(mut shown) = open() else {
        return;
    };
    occupy(&mut shown);
    shown.page.wait(&format!("!{REASON}.hidden"));
    shown.page.click("#stale button");
    let words = reason(&mut shown.page);
    assert!(words.contains("was stopped"), "{words}");
    shown.after(|page| page.value(&written("// a key")));
    assert!(!is_pale(&mut shown.page));
    shown.page.assert_quiet();
}

#[test]
fn a_key_drops_the_work_for_an_earlier_text() {
    let Some(mut shown) = open() else {
        return;
    };
    // At once, and after a while.
    for milliseconds in [0, 250] {
        occupy(&mut shown);
        shown.page.wait(ANALYSED);
        pause(milliseconds);
        shown.after(|page| page.value(&written("// another key")));
    }
    shown.page.assert_quiet();
}

/// Something is shown while keys follow each other: of two results in succession one is waited for.
#[test]
fn keys_do_not_drop_all_results() {
    let Some(mut shown) = open() else {
        return;
    };
    occupy(&mut shown);
    shown.page.wait(ANALYSED);
    // The work for this key takes forever, too.
    occupy(&mut shown);
    shown.page.wait(ANALYSED);
    let stops = shown.page.number("observed.stops");
    shown.page.value(&written("// another key"));
    pause(500);
    assert_eq!(shown.page.number("observed.stops"), stops);
    let current = "!playground.compiler.isBusy && document.getElementById('stale').hidden";
    shown.page.wait(current);
    assert_eq!(shown.page.number("observed.stops"), stops + 1.0);
    shown.page.assert_quiet();
}

/// The messages of a text that takes long are shown before its solution.
#[test]
fn messages_do_not_wait_for_the_solution() {
    let Some(mut shown) = open() else {
        return;
    };
    shown.choose("five-link-axle");
    shown.page.value("observed.asked = []");
    shown.page.value(
        "void (globalThis.first = new Promise((done) => new MutationObserver((_, observer) => { observer.disconnect(); \
         done({ shown: document.body.dataset.shown, messages: document.getElementById('messages').innerText }); }) \
         .observe(document.getElementById('messages'), { childList: true })))",
    );
    let before = shown.page.words("document.body.dataset.shown");
    shown.after(|page| {
        page.value(
            "playground.editor.replace(playground.editor.text().replace('param rod1', 'param rot1'))",
        )
    });
    let first = shown.page.value("first");
    assert_eq!(first["shown"], before, "{first}");
    let words = first["messages"].as_str().expect("a text");
    assert!(words.contains("unknown name `rod1`"), "{words}");
    let asked = shown.page.value("observed.asked");
    let mut asked = asked.as_array().expect("a list").iter();
    // Values next to names are asked for after a pause.
    let first = asked.find(|work| **work != "hints");
    assert_eq!(first, Some(&json!("messages")));
    shown.page.assert_quiet();
}
