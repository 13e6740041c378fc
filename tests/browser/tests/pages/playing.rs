//! Pages that change: play, pause, speed and direction, and pages that are written again while they are open.

use linkage_browser::samples::{FourBar, four_bar, written};
use linkage_browser::{Key, Page};
use linkage_report::{Index, show_mistakes};
use std::path::Path;
use std::thread;
use std::time::Duration;

// Play, pause, speed, direction.

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

// Pages of reports that are written anew while they are open.

/// The text of the banner, empty while it is hidden.
const BANNER: &str = "(() => { const own = document.getElementById('mistakes'); return own.hidden ? '' : own.innerText; })()";

#[test]
fn the_open_page_shows_the_new_report() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("followed");
    let write = |title: &str, version| {
        let report = four_bar(title, FourBar::SWINGING).version(version);
        report.write(&folder).expect("it can be written");
    };
    write("First", 1);
    let Some(mut page) = Page::open(&folder.join("index.html")) else {
        return;
    };
    // Asking for the version it has changes nothing.
    page.value("window.untouched = true");
    page.wait("window.linkageVersion !== undefined && document.head.querySelector('script[src]') === null");
    assert!(page.holds("window.untouched && document.title === 'First'"));
    write("Second", 2);
    page.wait("document.title === 'Second' && document.body.dataset.ready === 'true'");
    assert!(page.holds("window.untouched === undefined"));
    assert!(page.complaints().is_empty(), "{:?}", page.complaints());
}

#[test]
fn the_open_page_shows_mistakes_until_they_are_gone() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("mistaken");
    let report = four_bar("Four-bar", FourBar::SWINGING)
        .index("Machine")
        .version(3);
    report.write(folder.join("bar")).expect("it can be written");
    let index = Index::new("Machine").version(3).report("bar", &report);
    index.write(&folder).expect("it can be written");
    let Some(mut page) = Page::open(&folder.join("bar/index.html")) else {
        return;
    };
    page.value("window.untouched = true");
    let mistakes = "error: unknown name `rot`\n  --> bar.mech:3:5 <b>\u{2028}</script>";
    for place in [folder.join("bar"), folder.clone()] {
        assert_eq!(show_mistakes(&place, mistakes).ok(), Some(true));
    }
    page.wait(&format!("{BANNER}.includes('bar.mech:3:5 <b>')"));
    assert!(page.holds(
        "window.untouched && document.getElementById('mistakes').getBoundingClientRect().top >= 0"
    ));
    show_mistakes(folder.join("bar"), "").expect("it can be written");
    page.wait(&format!("{BANNER} === ''"));
    assert!(page.holds("window.untouched"));
    // The page that leads to the report has them, too.
    page.value("document.getElementById('index').click()");
    page.wait("document.title === 'Machine' && document.getElementById('mistakes') !== null");
    page.wait(&format!("{BANNER}.includes('unknown name')"));
    assert!(page.complaints().is_empty(), "{:?}", page.complaints());
    let nothing = folder.join("plots");
    assert_eq!(show_mistakes(nothing, mistakes).ok(), Some(false));
}
