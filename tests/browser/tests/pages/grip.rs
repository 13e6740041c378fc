//! Points that are dragged along their paths, and fingers on a phone.

use crate::checks;
use linkage_browser::samples::{FourBar, four_bar, sliders, spatial, written};
use linkage_browser::{Key, PHONE, Page, SMALL_PHONE};

// Points that are dragged along their paths, and points that lie on each other.

/// Where a point is in the window, at a row.
fn place(page: &mut Page, name: &str, row: usize) -> (f64, f64) {
    let before = page.row();
    go(page, row);
    let [left, top, width, height] = page.place(&format!("[data-point={name}] .mark"));
    go(page, before);
    (left + width / 2.0, top + height / 2.0)
}

fn go(page: &mut Page, row: usize) {
    page.value(&format!(
        "(() => {{ const s = document.querySelector('#position'); s.value = {row}; s.dispatchEvent(new Event('input')); }})()"
    ));
}

/// Drags a point from where it is through the places that it has at rows; where the mechanism was at each of them.
fn through(page: &mut Page, name: &str, rows: &[usize]) -> Vec<usize> {
    let start = page.row();
    let from = place(page, name, start);
    let places: Vec<_> = rows.iter().map(|row| place(page, name, *row)).collect();
    page.hold(from);
    let reached = places.iter().map(|to| {
        page.pull(*to);
        page.row()
    });
    let reached = reached.collect();
    page.release(places[places.len() - 1]);
    reached
}

fn assert_near(reached: &[usize], rows: &[usize], within: usize) {
    let near = |(a, b): (&usize, &usize)| a.abs_diff(*b) <= within;
    assert!(
        reached.iter().zip(rows).all(near),
        "at rows {reached:?} and not {rows:?}"
    );
}

#[test]
fn joints_are_dragged_to_their_nearest_row() {
    let file = written(&four_bar("Dragged", FourBar::TURNING), "dragged");
    let Some(mut page) = Page::open(&file) else {
        return;
    };
    page.middle("#drawing");
    // The end of the crank, which is at every place once; over the ends of the turn, too.
    let rows = [8, 40, 90, 170, 300, 350, 20];
    let reached = through(&mut page, "a", &rows);
    assert_near(&reached, &rows, 1);
    // A press without a drag still traces, and a drag does not.
    assert!(page.holds("document.querySelector('[data-trace=a]') === null"));
    // The view stays as it was.
    let report = checks::report(&mut page);
    let row = page.row();
    checks::points_stand_where_the_data_say(&mut page, &report, row);

    // The end of the rocker is at every place twice: it goes on where it came from, on both branches, and past the ends.
    for start in [100, 300] {
        go(&mut page, start);
        let rows: Vec<usize> = (0..=12).map(|i| start - 30 + 5 * i).rev().collect();
        let reached = through(&mut page, "b", &rows);
        assert_near(&reached, &rows, 3);
    }
    page.assert_quiet();
}

/// A pivot cannot be dragged: the picture is.
#[test]
fn pivots_and_what_is_beside_points_move_the_picture() {
    let file = written(&four_bar("Pivots", FourBar::TURNING), "pivots");
    let Some(mut page) = Page::open(&file) else {
        return;
    };
    page.middle("#drawing");
    let from = place(&mut page, "pivot_d", 0);
    page.drag(from, (from.0 + 40.0, from.1 - 30.0));
    assert_eq!(page.row(), 0);
    let now = place(&mut page, "pivot_d", 0);
    assert!((now.0 - from.0 - 40.0).abs() < 1.5 && (now.1 - from.1 + 30.0).abs() < 1.5);
    page.assert_quiet();
}

#[test]
fn points_in_space_are_dragged_as_they_are_seen() {
    let Some(mut page) = Page::open(&written(&spatial(), "dragged-space")) else {
        return;
    };
    page.middle("#drawing");
    for view in ["3-D", "x-y"] {
        page.click(&format!("[data-view={view:?}]"));
        go(&mut page, 10);
        let rows = [20, 45, 80, 120];
        let reached = through(&mut page, "p", &rows);
        assert_near(&reached, &rows, 1);
    }
    page.assert_quiet();
}

#[test]
fn a_finger_drags_a_joint_and_not_the_page() {
    let file = written(
        &four_bar("With a finger", FourBar::TURNING),
        "dragged-phone",
    );
    let Some(mut page) = Page::open(&file) else {
        return;
    };
    page.screen(PHONE);
    page.middle("#drawing");
    let scrolled = page.number("scrollY");
    let (from, to) = (place(&mut page, "a", 0), place(&mut page, "a", 60));
    page.swipe(from, to);
    assert!(page.row().abs_diff(60) <= 1, "row {}", page.row());
    assert_eq!(page.number("scrollY"), scrolled);
    page.assert_quiet();
}

#[test]
fn of_points_on_each_other_one_is_chosen() {
    // The tracer is a hair's breadth from the end of the crank.
    let folded = FourBar {
        arm: 0.5,
        ..FourBar::TURNING
    };
    let Some(mut page) = Page::open(&written(&four_bar("Stacked", folded), "stacked")) else {
        return;
    };
    page.middle("#drawing");
    let traced =
        "[...document.querySelectorAll('[data-trace]')].map((t) => t.dataset.trace).join(' ')";
    let choices =
        "[...document.querySelectorAll('[data-choice]')].map((t) => t.dataset.choice).join(' ')";
    let at = place(&mut page, "tracer", 0);
    page.click_at(at);
    let names = page.words(choices);
    assert!(
        names.contains("tracer") && names.split(' ').count() == 2,
        "{names}"
    );
    let hidden = names
        .split(' ')
        .find(|name| *name != "tracer")
        .expect("two");
    page.click(&format!("[data-choice={hidden}]"));
    assert_eq!(page.words(traced), format!("tracer {hidden}"));
    assert_eq!(page.words(choices), "");
    // It closes when it is not wanted.
    for close in [true, false] {
        let at = place(&mut page, "tracer", 0);
        page.click_at(at);
        assert_ne!(page.words(choices), "");
        page.shoot("stacked");
        if close {
            page.key(Key::Escape);
        } else {
            page.click_at((at.0 + 120.0, at.1 + 90.0));
        }
        assert_eq!(page.words(choices), "");
    }
    page.assert_quiet();
}

/// Targets overlap, and the nearest point is meant, whichever lies on top.
#[test]
fn the_nearest_point_is_meant() {
    let Some(mut page) = Page::open(&written(&sliders(), "nearest")) else {
        return;
    };
    page.middle("#drawing");
    // Both directions from the middle between two points, whose targets are made to overlap.
    page.value("for (let n = 0; n < 8; n += 1) document.querySelector('#farther').click()");
    page.settle();
    let (a, b) = (place(&mut page, "main", 0), place(&mut page, "big", 0));
    let apart = (b.0 - a.0).hypot(b.1 - a.1);
    assert!(apart > 6.0 && apart < 25.0, "{apart} pixels apart");
    for (near, far, name) in [(a, b, "main"), (b, a, "big")] {
        let at = (
            near.0 - 0.2 * (far.0 - near.0),
            near.1 - 0.2 * (far.1 - near.1),
        );
        page.click_at(at);
        assert!(
            page.holds(&format!(
                "document.querySelector('[data-trace={name}]') !== null"
            )),
            "{name}"
        );
    }
    page.assert_quiet();
}

// With a finger on a phone.

#[test]
fn fingers_play_and_trace() {
    let file = written(&four_bar("On a phone", FourBar::TURNING), "phone");
    let Some(mut page) = Page::open(&file) else {
        return;
    };
    page.screen(PHONE);
    let place = page.middle("[data-point=b] .mark");
    page.tap(place);
    page.wait("document.querySelector('[data-trace=b]')");

    let before = page.row();
    let place = page.middle("#play");
    page.tap(place);
    page.wait(&format!(
        "Number(document.querySelector('#position').value) !== {before}"
    ));
    page.tap(place);
    page.wait("document.querySelector('#play').getAttribute('aria-label') === 'Play'");

    // Below all plots and tables the controls are still there.
    page.value("window.scrollTo(0, document.body.scrollHeight)");
    page.settle();
    let [_, top, _, height] = page.place("#play");
    assert!(top > 0.0 && top + height <= f64::from(PHONE.height));
    page.shoot("phone-end");

    let place = page.middle(".plot");
    page.tap(place);
    page.settle();
    let last = page.number("Number(document.querySelector('#position').max)");
    assert!(
        (page.row() as f64 / last - 0.45).abs() < 0.15,
        "a tap in the plot leads there"
    );
    page.shoot("phone-plots");
    page.assert_quiet();
}

/// The slider and the words of the position have a row each, and the words are whole.
#[test]
fn the_readout_is_whole() {
    let Some(mut page) = Page::open(&written(
        &four_bar("Words", FourBar::TURNING),
        "phone-words",
    )) else {
        return;
    };
    for screen in [PHONE, SMALL_PHONE] {
        page.screen(screen);
        // The longest numbers.
        page.value("(() => { const slider = document.getElementById('position'); slider.value = 287; slider.dispatchEvent(new Event('input')); })()");
        page.settle();
        let cut = page.words(
            "[document.getElementById('readout'), ...document.getElementById('readout').children].filter((own) => own.scrollWidth > own.clientWidth + 1 && own.clientWidth > 0 \
             || own.getBoundingClientRect().right > innerWidth).map((own) => own.textContent).join('; ')",
        );
        assert_eq!(cut, "", "on a {}", screen.name);
        let words = page.words("document.getElementById('readout').innerText");
        assert!(
            words.contains("phi = 287 deg")
                && words.contains("rad")
                && words.contains("row 288 of 361, t = "),
            "{words}"
        );
        let [_, top, width, height] = page.place("#position");
        assert!(width > f64::from(screen.width) - 40.0, "{width}");
        for other in ["#play", "#readout", "#direction", "#speed"] {
            let [_, own, _, tall] = page.place(other);
            assert!(
                own >= top + height - 1.0 || own + tall <= top + 1.0,
                "{other} is beside the slider"
            );
        }
        page.shoot(&format!("readout-{}", screen.name));
    }
    page.assert_quiet();
}

#[test]
fn two_fingers_make_it_larger() {
    let file = written(&spatial(), "pinch");
    let Some(mut page) = Page::open(&file) else {
        return;
    };
    page.screen(PHONE);
    let scale = "Number(document.querySelector('#drawing').dataset.scale)";
    let fitted = page.number(scale);
    let middle = page.middle("#drawing");
    page.pinch(middle, 80.0, 160.0);
    page.settle();
    let larger = page.number(scale) / fitted;
    assert!((larger - 2.0).abs() < 0.3, "made larger {larger} times");
    page.assert_quiet();
}
