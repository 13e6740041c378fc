//! Play, pause, speed, direction.

use linkage_browser::samples::{FourBar, four_bar, written};
use linkage_browser::{Key, Page};
use std::thread;
use std::time::Duration;

const PLAYING: &str = "document.querySelector('#play').getAttribute('aria-label') === 'Pause'";

fn page(name: &str) -> Option<Page> {
    Page::open(&written(&four_bar("Playing", FourBar::TURNING), name))
}

/// Waits until the mechanism has moved; the row it was at.
fn moves(page: &mut Page) -> usize {
    let row = page.row();
    page.wait(&format!(
        "Number(document.querySelector('#position').value) !== {row}"
    ));
    row
}

fn rests(page: &mut Page) {
    let row = page.row();
    thread::sleep(Duration::from_millis(300));
    assert_eq!(page.row(), row);
}

#[test]
fn the_button_and_the_space_bar_play_and_pause() {
    let Some(mut page) = page("playing") else {
        return;
    };
    rests(&mut page);
    page.click("#play");
    assert!(page.holds(PLAYING));
    moves(&mut page);
    page.click("#play");
    rests(&mut page);

    // The button has the focus now: space means the same, and once only.
    page.key(Key::Space);
    moves(&mut page);
    page.value("document.activeElement.blur()");
    page.key(Key::Space);
    rests(&mut page);

    // Whoever takes the position into his hands wants it to stay there.
    page.key(Key::Space);
    moves(&mut page);
    page.key(Key::Home);
    assert!(!page.holds(PLAYING));
    assert_eq!(page.row(), 0);
    page.assert_quiet();
}

#[test]
fn backwards_and_past_the_end_of_a_turn() {
    let Some(mut page) = page("backwards") else {
        return;
    };
    page.key(Key::Home);
    page.click("#direction");
    assert_eq!(
        page.words("document.querySelector('#direction').getAttribute('aria-label')"),
        "Direction: backward"
    );
    page.click("#play");
    moves(&mut page);
    thread::sleep(Duration::from_millis(200));
    let row = page.row();
    assert!(
        row > 180,
        "a whole turn goes on at its other end, not at row {row}"
    );
    page.click("#play");
    page.assert_quiet();
}

#[test]
fn speeds_tell_their_slow_motion() {
    let Some(mut page) = page("speeds") else {
        return;
    };
    let words = page.words("document.querySelector('#speed').innerText");
    // 10 turns in a second.
    assert!(words.contains("true time (0.1 s per cycle)"), "{words}");
    assert!(words.contains("8 s per cycle, slowed 80 times"), "{words}");

    // The test is the clock: how busy the computer is must not matter.
    page.value("window.requestAnimationFrame = (frame) => { window.nextFrame = frame; };");
    for (option, seconds) in [(3, 4.0), (5, 16.0)] {
        page.value(&format!(
            "(() => {{ const s = document.querySelector('#speed'); s.selectedIndex = {option}; \
             s.dispatchEvent(new Event('change')); }})()"
        ));
        page.key(Key::Home);
        page.key(Key::Space);
        page.value("for (let n = 0; n <= 20; n += 1) window.nextFrame(1000 + 50 * n);");
        // After one second of a cycle of 360 rows.
        assert_eq!(page.row(), (360.0_f64 / seconds).round() as usize);
        page.key(Key::Space);
    }
    page.assert_quiet();
}

/// Its speed is one of every position, and no time follows from it.
#[test]
fn an_accelerated_input_has_no_true_time() {
    let report = four_bar("Accelerated", FourBar::TURNING).speed(-5.0, 0.25);
    let Some(mut page) = Page::open(&written(&report, "accelerated")) else {
        return;
    };
    let words = page.words("document.querySelector('#speed').innerText");
    assert!(
        words.contains("8 s per cycle") && !words.contains("slowed") && !words.contains("true"),
        "{words}"
    );
    let readout = page.words("document.querySelector('#readout').innerText");
    assert!(
        readout.contains("row 1 of 361") && !readout.contains("t = "),
        "{readout}"
    );
    let facts = page.words("document.querySelector('[data-table=facts]').innerText");
    assert!(facts.contains("-5 rad/s ("), "{facts}");
    assert!(
        facts.contains("Acceleration of phi\t0.25 rad/s^2"),
        "{facts}"
    );
    // The machine still runs backwards.
    let direction = page.words("document.querySelector('#direction').getAttribute('aria-label')");
    assert_eq!(direction, "Direction: backward");
    page.assert_quiet();
}

#[test]
fn it_plays_by_itself_unless_less_motion_is_asked_for() {
    let file = written(&four_bar("By itself", FourBar::TURNING), "by-itself");
    let Some(mut page) = Page::empty() else {
        return;
    };
    page.still(false);
    page.load(&file);
    page.wait("document.body.dataset.ready === 'true'");
    assert!(page.holds(PLAYING));
    moves(&mut page);
    page.assert_quiet();
}
