//! Texts are never lost: another one can be undone, a reload and another visit begin with the same.

use serde_json::json;

use crate::page::Shown;

const TYPED: &str = "// a text of mine\n";

/// The name of the file of the text.
const FILE_NAME: &str = "playground.editor.file().name";

fn write_at_start(shown: &mut Shown) -> String {
    shown.after(|page| {
        page.value(&format!(
            "playground.editor.view.dispatch({{ changes: {{ from: 0, insert: {} }} }})",
            json!(TYPED)
        ))
    });
    shown.text()
}

/// Loads the page again, and waits for a text.
fn reload(shown: &mut Shown, text: &str) {
    // The page before has the same text.
    shown.page.value("globalThis.isOld = true");
    shown.page.value("setTimeout(() => location.reload())");
    shown.page.wait(&format!(
        "!globalThis.isOld && document.body.dataset.shown && playground.editor.text() === {}",
        json!(text)
    ));
}

#[test]
fn another_text_is_one_step() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    let mine = write_at_start(&mut shown);
    let name = shown.page.words(FILE_NAME);
    shown.choose("geneva");
    assert_ne!(shown.text(), mine);
    assert_eq!(shown.page.words(FILE_NAME), "geneva.mech");
    assert!(
        shown
            .page
            .words("document.getElementById('status').textContent")
            .contains("Undo")
    );
    shown.after(|page| page.click("#undo"));
    assert_eq!(shown.text(), mine);
    assert_eq!(shown.page.words(FILE_NAME), name);
    shown.after(|page| page.click("#redo"));
    assert_eq!(shown.page.words(FILE_NAME), "geneva.mech");
    shown.page.assert_quiet();
}

#[test]
fn a_reload_keeps_text_and_steps() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    let first = shown.text();
    let mine = write_at_start(&mut shown);
    shown.choose("geneva");
    let geneva = shown.text();
    reload(&mut shown, &geneva);
    assert_eq!(shown.page.words(FILE_NAME), "geneva.mech");
    shown.undo();
    assert_eq!(shown.text(), mine);
    shown.undo();
    assert_eq!(shown.text(), first);
    shown.page.assert_quiet();
}

#[test]
fn another_visit_begins_with_the_latest_text() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    let mine = write_at_start(&mut shown);
    shown.choose("geneva");
    // Of two texts that were written, the first one is in the list.
    let second = write_at_start(&mut shown);
    let kept = "Object.keys(localStorage).filter((key) => key.startsWith('linkage-playground/')).length === 2";
    shown.page.wait(kept);
    // As in another window: nothing is known of this one.
    shown
        .page
        .value("addEventListener('pagehide', () => sessionStorage.clear())");
    reload(&mut shown, &second);
    let earlier = "document.querySelector('#examples optgroup:last-child option')";
    assert!(
        shown
            .page
            .words(&format!("{earlier}.textContent"))
            .contains(".mech")
    );
    shown.after(|page| {
        page.value(&format!(
            "(() => {{ const list = document.getElementById('examples'); list.value = {earlier}.value; list.dispatchEvent(new Event('change')); }})()"
        ))
    });
    assert_eq!(shown.text(), mine);
    shown.page.assert_quiet();
}

#[test]
fn a_browser_that_keeps_nothing_is_reported() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    let hidden = "document.getElementById('unkept').hidden";
    assert!(shown.page.holds(hidden));
    shown.page.value(
        "Storage.prototype.setItem = () => { throw new DOMException('no', 'SecurityError'); }",
    );
    write_at_start(&mut shown);
    shown.page.wait(&format!("!{hidden}"));
    let leaves = "(() => { const leaving = new Event('beforeunload', { cancelable: true }); dispatchEvent(leaving); return leaving.defaultPrevented; })()";
    assert!(shown.page.holds(leaves));
    shown.page.assert_quiet();
}

/// The mark at the beginning of a file, and its ends of lines, are those of the file that is saved.
#[test]
fn files_keep_their_form() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    let save = "new Promise((done) => { URL.createObjectURL = (blob) => { blob.arrayBuffer().then((buffer) => done([...new Uint8Array(buffer)])); return '#'; }; document.getElementById('save').click(); })";
    for text in [
        "\u{feff}// one\r\n// two\r\n",
        "\u{feff}// one\n",
        "// one\r// two\r",
        "// one",
    ] {
        let bytes = json!(text.as_bytes());
        shown.after(|page| {
            page.value(&format!(
                "playground.openBytes('form.mech', new Uint8Array({bytes}))"
            ))
        });
        assert!(!shown.text().contains('\r') && !shown.text().contains('\u{feff}'));
        assert_eq!(shown.page.value(save), bytes, "{text:?}");
    }
    let before = shown.text();
    shown
        .page
        .value("playground.openBytes('latin.mech', new Uint8Array([0xb5]))");
    assert_eq!(shown.text(), before);
    let status = "document.getElementById('status').textContent";
    assert!(shown.page.words(status).contains("UTF-8"));
    shown.page.assert_quiet();
}
