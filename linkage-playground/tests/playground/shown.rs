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

    shown.type_after("Path { ", "velo");
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
        .wait("playground.editor.text().includes('Path { velocity')");
    shown.page.assert_quiet();
}

#[test]
fn changes_are_offered_and_taken() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    shown.choose("slider");
    let text = shown.text();
    // Blanks are arranged, in one step.
    shown.after(|page| {
        page.value("playground.editor.view.dispatch({ changes: { from: playground.editor.text().indexOf('unit mm;'), insert: '      ' } })")
    });
    shown.after(|page| page.click("#format"));
    assert_eq!(shown.text(), text);
    // The advice of a message is one click away.
    shown.type_after("param crank", "s");
    shown
        .page
        .wait("document.getElementById('messages').childElementCount > 0");
    shown.page.click("#messages button");
    shown.page.click("#offer");
    shown
        .page
        .wait("document.querySelector('#changes[open] button')");
    shown.after(|page| page.click("#changes button"));
    assert_eq!(shown.messages(), "");
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

/// Files of each format. Code is that of the command; drawings and tables have values, which may
/// differ in the last digits where this machine fuses multiply-adds.
#[test]
fn files_are_exported() {
    const FORMATS: [(&str, &str); 7] = [
        ("svg", "</svg>"),
        ("dxf", "EOF"),
        ("csv", ""),
        ("csv-radians", ""),
        ("c", ""),
        ("js", ""),
        ("page", "</html>"),
    ];
    let Some(mut shown) = Shown::open() else {
        return;
    };
    shown.choose("slider");
    let text = shown.text();
    let name = text
        .split("struct ")
        .nth(1)
        .and_then(|rest| rest.split(' ').next());
    for (format, ending) in FORMATS {
        let files = shown.exported(format);
        assert!(files[0].1.trim_end().ends_with(ending), "{}", files[0].0);
        let request = json!({ "do": "export", "text": text, "format": format, "mechanism": name });
        let here: Value = serde_json::from_str(&answer(&request.to_string())).expect("JSON");
        let here = here.as_array().expect("a list");
        assert_eq!(files.len(), here.len(), "{format}");
        for ((name, content), file) in files.iter().zip(here) {
            assert_eq!(file["name"], *name);
            let is_code = format == "c" || format == "js";
            assert!(!is_code || file["text"] == *content, "{name}");
            // Angles are in degrees, as on the page, unless radians are asked for.
            let has = |unit: &str| {
                content
                    .lines()
                    .next()
                    .is_some_and(|head| head.contains(unit))
            };
            assert!(
                format != "csv" || has("[deg]") && !has("[rad]"),
                "{content}"
            );
            assert!(format != "csv-radians" || has("[rad]"), "{content}");
        }
    }
    shown.page.assert_quiet();
}

/// The choice of a format saves its files, which the line below the text reports.
#[test]
fn a_chosen_format_is_saved() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    shown.choose("slider");
    shown.page.value(
        "globalThis.saved = [], HTMLAnchorElement.prototype.click = function () { saved.push(this.download); }",
    );
    shown.page.value("(() => { const list = document.getElementById('export'); list.value = 'c'; list.dispatchEvent(new Event('change')); })()");
    shown.page.wait("saved.length === 2");
    let status = shown
        .page
        .words("document.getElementById('status').textContent");
    let saved = shown.page.words("saved.join(', ')");
    assert_eq!(status, format!("Saved: {saved}."));
    assert!(saved.contains(".h") && saved.contains(".c"), "{saved}");
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
