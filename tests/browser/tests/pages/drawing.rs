//! The drawing in the plane.

use crate::checks;
use linkage_browser::samples::{FourBar, four_bar, sliders, written};
use linkage_browser::{Key, Page};

#[test]
fn a_four_bar() {
    let file = written(&four_bar("Crank-rocker", FourBar::TURNING), "four-bar");
    let Some(mut page) = Page::open(&file) else {
        return;
    };
    checks::all(&mut page, "four-bar");
    assert_eq!(
        page.number("document.querySelectorAll('#drawing .foot').length"),
        2.0
    );
    assert_eq!(
        page.number("document.querySelectorAll('#drawing .plate').length"),
        1.0
    );
    assert_eq!(
        page.number("document.querySelectorAll('#drawing .bar').length"),
        2.0
    );
}

#[test]
fn clicks_and_keys_trace_points() {
    let file = written(&four_bar("Traces", FourBar::TURNING), "traces");
    let Some(mut page) = Page::open(&file) else {
        return;
    };
    let traced =
        "[...document.querySelectorAll('[data-trace]')].map((t) => t.dataset.trace).join(' ')";
    assert_eq!(page.words(traced), "tracer");
    page.click("[data-point=b] .mark");
    assert_eq!(page.words(traced), "tracer b");
    page.click("[data-point=tracer] .mark");
    assert_eq!(page.words(traced), "b");
    page.value("document.querySelector('[data-point=a]').focus()");
    page.key(Key::Enter);
    assert_eq!(page.words(traced), "b a");
    assert_eq!(
        page.words("document.querySelector('[data-point=a]').getAttribute('aria-pressed')"),
        "true"
    );

    // The path of a is a circle of the crank's length about its pivot.
    let radii = page.value(
        "(() => { const path = document.querySelector('[data-trace=a]'); const view = document.querySelector('#drawing').dataset; \
         return [0, 0.2, 0.45, 0.9].map((part) => { const p = path.getPointAtLength(part * path.getTotalLength()); \
         return Math.hypot(p.x - view.originX, p.y - view.originY) / view.scale; }); })()",
    );
    for radius in radii.as_array().expect("four radii") {
        let radius = radius.as_f64().expect("a radius");
        assert!((radius - 50.0).abs() < 0.05, "{radius}");
    }
    page.assert_quiet();
}

#[test]
fn it_can_be_moved_and_made_larger() {
    let file = written(&four_bar("Size", FourBar::TURNING), "size");
    let Some(mut page) = Page::open(&file) else {
        return;
    };
    let report = checks::report(&mut page);
    let scale = "Number(document.querySelector('#drawing').dataset.scale)";
    let fitted = page.number(scale);
    let middle = page.middle("#drawing");
    page.wheel(middle, -300.0);
    page.wait(&format!("{scale} > {}", 1.2 * fitted));
    checks::points_stand_where_the_data_say(&mut page, &report, 0);
    let origin = page.number("Number(document.querySelector('#drawing').dataset.originX)");
    page.drag(middle, (middle.0 + 60.0, middle.1 + 20.0));
    let moved = page.number("Number(document.querySelector('#drawing').dataset.originX)") - origin;
    assert!((moved - 60.0).abs() < 1.0, "moved by {moved}");
    checks::points_stand_where_the_data_say(&mut page, &report, 0);
    page.click("#fit");
    assert_eq!(page.number(scale), fitted);
    page.assert_quiet();
}

#[test]
fn names_appear_on_demand() {
    let file = written(&four_bar("Names", FourBar::TURNING), "names");
    let Some(mut page) = Page::open(&file) else {
        return;
    };
    let shown = "[...document.querySelectorAll('#drawing .name')].filter((n) => getComputedStyle(n).visibility === 'visible').map((n) => n.textContent).join(' ')";
    assert_eq!(page.words(shown), "");
    let place = page.middle("[data-point=b] .mark");
    page.point_at(place);
    assert_eq!(page.words(shown), "b");
    page.click("#names");
    assert_eq!(page.words(shown), "pivot_a pivot_d a b tracer");
    page.shoot("names");
    // Space is for the button that has the focus, and does not play.
    page.key(Key::Space);
    assert!(page.holds("!document.querySelector('#figure').classList.contains('named')"));
    assert!(page.holds("document.querySelector('#play').getAttribute('aria-label') === 'Play'"));
    page.assert_quiet();
}

/// Blocks are on their guides' lines, wherever those are.
#[test]
fn slides() {
    let file = written(&sliders(), "sliders");
    let Some(mut page) = Page::open(&file) else {
        return;
    };
    checks::all(&mut page, "sliders");
    for row in [0, 37, 88] {
        checks::go_to(&mut page, row);
        for guide in ["s", "t"] {
            let away = page.number(&format!(
                "(() => {{ const ends = document.querySelector('[data-guide={guide}] .body').getAttribute('d').match(/-?[\\d.]+/g).map(Number); \
                 const box = document.querySelector('[data-slider={guide}] .block').getBBox(); \
                 const [x, y] = [box.x + box.width / 2 - ends[0], box.y + box.height / 2 - ends[1]]; \
                 const [u, v] = [ends[2] - ends[0], ends[3] - ends[1]]; \
                 return Math.abs(u * y - v * x) / Math.hypot(u, v); }})()"
            ));
            assert!(
                away < 0.1,
                "block {guide} is {away} pixels off its guide in row {row}"
            );
        }
    }
    assert_eq!(
        page.number("document.querySelectorAll('#drawing .rail').length"),
        1.0
    );
    // A point that only says where a guide is does not make the rest small: 0.165 m and more fill the drawing.
    let scale = page.number("Number(document.querySelector('#drawing').dataset.scale)");
    assert!(0.165 * scale > 250.0, "{scale} pixels for a metre");
}
