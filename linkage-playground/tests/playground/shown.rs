//! Messages, hover, completion, examples, addresses, files, widths and colours.

use linkage_browser::{DESKTOP, Key, PHONE};
use linkage_playground::answer;
use serde_json::{Value, json};

use crate::page::{EDITOR, FRAME, Shown};

#[test]
fn messages_follow_each_key() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    assert_eq!(shown.messages(), "");
    let text = shown.text();
    shown.type_after("link rod: k, q", "x");
    shown
        .page
        .wait("document.getElementById('messages').childElementCount > 0");
    assert!(
        shown.messages().contains("unknown joint `qx`"),
        "{}",
        shown.messages()
    );
    // Under the word itself.
    let marked = format!("{EDITOR}.querySelector('.cm-lintRange-error').textContent");
    assert_eq!(shown.page.words(&marked), "qx");
    assert!(
        shown
            .page
            .holds(&format!("{FRAME}.body.classList.contains('stale')"))
    );
    shown.undo();
    assert_eq!(shown.text(), text);
    assert_eq!(shown.messages(), "");
    assert!(
        !shown
            .page
            .holds(&format!("{FRAME}.body.classList.contains('stale')"))
    );
    shown.page.assert_quiet();
}

#[test]
fn words_are_described_and_completed() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    shown.choose("four-bar");
    let offset = shown.text().find("param coupler").expect("a dimension") + 8;
    let place = shown.page.value(&format!(
        "(() => {{ const at = playground.editor.view.coordsAtPos({offset}); return [at.left + 1, (at.top + at.bottom) / 2]; }})()"
    ));
    let place = (
        place[0].as_f64().expect("a number"),
        place[1].as_f64().expect("a number"),
    );
    shown.page.point_at((place.0 + 9.0, place.1));
    shown.page.point_at(place);
    shown
        .page
        .wait(&format!("{EDITOR}.querySelector('.hover')"));
    let described = shown
        .page
        .words(&format!("{EDITOR}.querySelector('.hover').innerText"));
    assert!(
        described.contains("coupler") && described.contains("mm"),
        "{described}"
    );
    shown.page.point_at((5.0, 5.0));

    shown.type_after("Motion { ", "velo");
    shown.page.wait(&format!(
        "{EDITOR}.querySelector('.cm-tooltip-autocomplete li')"
    ));
    shown.page.wait(&format!(
        "{EDITOR}.querySelector('.cm-tooltip-autocomplete li').innerText.startsWith('velocity')"
    ));
    // The list takes no key in its first moments.
    std::thread::sleep(std::time::Duration::from_millis(150));
    shown.page.key(Key::Enter);
    shown
        .page
        .wait("playground.editor.text().includes('Motion { velocity')");
    shown.page.assert_quiet();
}

#[test]
fn examples_are_shown() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    let title = format!("{FRAME}.getElementById('title').textContent");
    let first = shown.page.words(&title);
    shown.choose("slider");
    let second = shown.page.words(&title);
    assert_ne!(first, second);
    // In space, coupled, with several mechanisms in the text.
    for name in ["needle-drive", "hook-needle", "scissors"] {
        shown.choose(name);
        assert_eq!(shown.messages(), "", "{name}");
        assert!(
            shown
                .page
                .holds(&format!("{FRAME}.querySelectorAll('.panel').length > 0"))
        );
    }
    shown.page.assert_quiet();
}

#[test]
fn addresses_have_the_text() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    shown.choose("geneva");
    shown.after(|page| page.value("playground.editor.view.dispatch({ changes: { from: 0, insert: '// \u{3bc}\u{1d6fc} my drive\\n' } })"));
    let text = shown.text();
    shown.page.click("#share");
    shown.page.wait("location.hash.includes('text=')");
    let address = shown.page.words("location.href");
    shown.choose("slider");
    shown.page.value("location.hash = ''");
    // As another reader opens it.
    shown
        .page
        .value(&format!("location.href = {}", json!(address)));
    shown
        .page
        .wait(&format!("playground.editor.text() === {}", json!(text)));
    shown.page.value("location.reload()");
    shown.page.wait(&format!(
        "globalThis.playground && playground.editor.text() === {}",
        json!(text)
    ));
    shown.page.assert_quiet();
}

/// Files of the page are those of the same code here; the page of its own opens without the
/// playground.
#[test]
fn files_are_exported() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    let text = shown.text();
    for (format, ending) in [
        ("svg", "</svg>"),
        ("dxf", "EOF"),
        ("csv", ""),
        ("c", "}"),
        ("js", ";"),
        ("page", "</html>"),
    ] {
        let files = shown.exported(format);
        let request =
            json!({ "do": "export", "text": text, "format": format, "mechanism": "Press" });
        let here: Value = serde_json::from_str(&answer(&request.to_string())).expect("JSON");
        assert_eq!(files.len(), here.as_array().expect("a list").len());
        for ((name, content), file) in files.iter().zip(here.as_array().expect("a list")) {
            assert_eq!(file["name"], *name);
            assert!(file["text"] == *content, "{name}");
            assert!(content.trim_end().ends_with(ending), "{name}");
        }
    }
}

#[test]
fn a_computation_that_does_not_end_is_stopped() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    let text = json!(shown.text());
    // Years of work for the worker.
    shown.page.value(&format!(
        "void playground.compiler.ask({{ do: 'sweep', text: {text}, function: 'motion', positions: 100000, repeats: 1e15 }})"
    ));
    shown.type_after("link rod: k, q", " ");
    shown.page.wait("!document.getElementById('busy').hidden");
    // The page stays alive meanwhile.
    assert_eq!(shown.page.number("1 + 1"), 2.0);
    shown.page.click("#stop");
    shown.page.wait("document.getElementById('busy').hidden");
    shown.after(|page| {
        page.value("playground.editor.view.dispatch({ changes: { from: 0, insert: '// ' } })")
    });
    assert_eq!(shown.messages(), "");
    shown.page.assert_quiet();
}

/// Tabs on a phone, and pictures in light and dark: contrast of words on their ground.
#[test]
fn phones_and_dark_rooms_are_served() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    for (screen, width) in [(DESKTOP, "desktop"), (PHONE, "phone")] {
        shown.page.screen(screen);
        for dark in [false, true] {
            shown.page.dark(dark);
            shown.page.settle();
            let colours = if dark { "dark" } else { "light" };
            shown.page.shoot(&format!("playground_{width}_{colours}"));
            let [ink, ground] = shown.page.colours("#status");
            let brightness = |[red, green, blue]: [f64; 3]| red + green + blue;
            assert_eq!(
                brightness(ink) > brightness(ground),
                dark,
                "{width}: {ink:?} on {ground:?}"
            );
            assert!(
                shown
                    .page
                    .holds("document.documentElement.scrollWidth <= innerWidth")
            );
        }
    }
    let seen =
        |id: &str| format!("document.getElementById('{id}').getBoundingClientRect().width > 0");
    assert!(shown.page.holds(&seen("text")) && !shown.page.holds(&seen("view")));
    shown.page.click("#view-tab");
    assert!(shown.page.holds(&seen("view")) && !shown.page.holds(&seen("text")));
    shown.page.shoot("playground_phone_mechanism");
    shown.page.key(Key::Left);
    assert!(shown.page.holds(&seen("text")));
    shown.page.assert_quiet();
}

/// Nothing but the hashes of the two scripts and styles, and WebAssembly.
#[test]
fn the_content_policy_has_no_exceptions() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    let policy = shown
        .page
        .words("document.querySelector('meta[http-equiv]').content");
    assert!(policy.contains("default-src 'none'"), "{policy}");
    assert!(
        !policy.contains("'unsafe-inline")
            && !policy.contains("'unsafe-eval")
            && !policy.contains('*')
            && !policy.contains("http"),
        "{policy}"
    );
    let script = "(() => { const own = document.createElement('script'); own.textContent = 'globalThis.intruder = 1'; document.head.append(own); return globalThis.intruder ?? 0; })()";
    assert_eq!(shown.page.number(script), 0.0);
}
