//! With a finger on a phone, and with the keys alone.

use linkage_browser::{DESKTOP, Key, PHONE, accessible};

use crate::page::{FRAME, Shown};

/// Names of elements of the header that are smaller than a finger, or outside of the window.
const TOO_SMALL: &str = "[...document.querySelectorAll('header button, header select, #tabs button, #messages button')].filter((own) => own.offsetWidth > 0).filter((own) => { \
     const { left, right, width, height } = own.getBoundingClientRect(); \
     return width < 44 || height < 44 || left < 0 || right > innerWidth; }).map(({ id, textContent }) => id || textContent).join()";

#[test]
fn fingers_reach_all_controls() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    shown.page.screen(PHONE);
    shown.type_after("link rod: k, q", "x");
    shown
        .page
        .wait("document.querySelector('#messages button')");
    let hidden = "[...document.querySelectorAll('header button, header select')].filter((own) => own.offsetWidth === 0 && !own.closest('[hidden]')).map(({ id }) => id).join()";
    assert!(shown.page.words(hidden).contains("shape"));
    assert_eq!(shown.page.words(TOO_SMALL), "");
    let more = shown.page.middle("#more");
    shown.page.tap(more);
    assert_eq!(shown.page.words(hidden), "");
    assert_eq!(shown.page.words(TOO_SMALL), "");
    shown.page.shoot("playground_phone_more");
    shown.after(|page| {
        let undo = page.middle("#undo");
        page.tap(undo);
    });
    assert_eq!(shown.messages(), "");
    shown.page.assert_quiet();
}

/// The reason for a pale mechanism is next to it, where the text is on another tab.
#[test]
fn the_reason_is_on_both_tabs() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    shown.page.screen(PHONE);
    let reason = "document.getElementById('stale')";
    assert!(shown.page.holds(&format!("{reason}.hidden")));
    shown.type_after("link rod: k, q", "x");
    shown.page.wait(&format!("!{reason}.hidden"));
    shown.page.click("#view-tab");
    let words = shown.page.words(&format!("{reason}.innerText"));
    assert!(
        words.contains("unknown joint `qx`") && words.contains("the last mechanism"),
        "{words}"
    );
    shown.page.shoot("playground_phone_stale");
    shown.page.click("#stale button");
    assert!(
        shown
            .page
            .holds("document.querySelector('main').dataset.tab === 'text'")
    );
    shown.undo();
    assert!(shown.page.holds(&format!("{reason}.hidden")));
    shown.page.assert_quiet();
}

/// Panels of tabs have names, and the tab says how many mistakes the text has.
#[test]
fn tabs_have_panels_with_names() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    let role = |id: &str| format!("document.getElementById('{id}').getAttribute('role')");
    assert!(shown.page.value(&role("text")).is_null());
    shown.page.screen(PHONE);
    shown.page.settle();
    for id in ["text", "view"] {
        assert_eq!(shown.page.words(&role(id)), "tabpanel");
        let tab = format!("document.querySelector('[role=tab][aria-controls={id}]')");
        let named =
            format!("document.getElementById('{id}').getAttribute('aria-labelledby') === {tab}.id");
        assert!(shown.page.holds(&named));
    }
    shown.type_after("link rod: k, q", "x");
    shown.page.wait(
        "/^Text \\(\\d+ mistakes?\\)$/.test(document.getElementById('text-tab').textContent)",
    );
    shown.page.assert_quiet();
}

/// The tabulator leads through all controls, into the text and out of it, to the mechanism.
#[test]
fn keys_lead_everywhere() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    let mut seen = Vec::new();
    for _ in 0..40 {
        shown.page.key(Key::Tab);
        seen.push(shown.page.words("document.activeElement.id"));
        if seen.last().is_some_and(|id| id == "frame") {
            break;
        }
    }
    for id in [
        "examples", "open", "save", "share", "export", "format", "offer", "shape", "theme",
        "editor", "border", "frame",
    ] {
        assert!(seen.iter().any(|other| other == id), "{id}: {seen:?}");
    }
    let inside = format!("{FRAME}.activeElement.localName");
    assert_ne!(shown.page.words(&inside), "body");
    // Another example, by its arrow keys.
    shown
        .page
        .value("document.getElementById('examples').focus()");
    let before = shown.text();
    shown.page.type_text("slider");
    shown.page.key(Key::Enter);
    shown.page.wait(&format!(
        "playground.editor.text() !== {}",
        serde_json::json!(before)
    ));
    shown.page.assert_quiet();
}

/// A screen reader has a name for everything that can be used, and for every picture.
#[test]
fn everything_has_a_name() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    // With a list of messages as well.
    shown.type_after("link rod: k, q", "x");
    shown
        .page
        .wait("document.querySelector('#messages button')");
    // The mechanism is on another tab of the phone.
    for (screen, least) in [(DESKTOP, 30), (PHONE, 8)] {
        shown.page.screen(screen);
        let found = accessible(&mut shown.page);
        assert!(found.len() >= least, "{found:?}");
        let nameless: Vec<_> = found.iter().filter(|(_, name)| name.is_empty()).collect();
        assert!(nameless.is_empty(), "{}: {nameless:?}", screen.name);
        let has = |role: &str, name: &str| {
            found
                .iter()
                .any(|(other, words)| other == role && words.contains(name))
        };
        assert!(has("textbox", "Text of the mechanism"));
        assert!(has("button", "unknown joint `qx`"), "{found:?}");
    }
    shown.page.assert_quiet();
}
