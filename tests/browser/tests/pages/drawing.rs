//! The drawing in the plane, with curved slots.

use crate::checks;
use linkage_browser::samples::{FourBar, four_bar, sliders, slots, written};
use linkage_browser::{Key, Page};
use serde_json::Value;

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

// Curved slots.

/// The line of a slot: its places on the screen, that of its pin, and pixels for a millimetre.
const LINE: &str = "(guide, pin) => { \
     const numbers = document.querySelector(`[data-guide=${guide}] .gap`).getAttribute('d').match(/-?[\\d.]+/g).map(Number); \
     const line = numbers.flatMap((x, k) => (k % 2 ? [] : [[x, numbers[k + 1]]])); \
     const mark = document.querySelector(`[data-point=${pin}] .mark`); \
     return { line, pin: ['cx', 'cy'].map((name) => Number(mark.getAttribute(name))), scale: Number(document.querySelector('#drawing').dataset.scale) }; }";

fn pair(value: &Value) -> [f64; 2] {
    [0, 1].map(|k| value[k].as_f64().expect("a number"))
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The lengths of lines, the distances of pins from them, and the radii, at some rows.
fn assert_lines(page: &mut Page) {
    for row in [0, 37, 88] {
        checks::go_to(page, row);
        for (guide, pin, radius, span) in [
            ("slot", "pin", 60.0, 1.0),
            ("way", "die", 80.0, 0.8),
            ("ring", "runner", 25.0, std::f64::consts::TAU),
        ] {
            let found = page.value(&format!("({LINE})('{guide}', '{pin}')"));
            let scale = found["scale"].as_f64().expect("a scale");
            let line: Vec<_> = found["line"]
                .as_array()
                .expect("a line")
                .iter()
                .map(pair)
                .collect();
            let length: f64 = line.windows(2).map(|ends| distance(ends[0], ends[1])).sum();
            let wanted = span * radius * scale;
            assert!(
                (length - wanted).abs() < 3e-3 * wanted,
                "{guide} is {length} pixels long, not {wanted}, in row {row}"
            );
            let pin = pair(&found["pin"]);
            let away = line.iter().map(|at| distance(*at, pin));
            let away = away.fold(f64::INFINITY, f64::min);
            assert!(away < 0.04 * radius * scale, "{guide}: {away} pixels");
        }
    }
}

#[test]
fn slots_have_their_pins() {
    let Some(mut page) = Page::open(&written(&slots(), "slots")) else {
        return;
    };
    checks::all(&mut page, "slots");
    assert_lines(&mut page);
    // One with its plate in the colour of the lever, two hatched ones of the frame.
    let count = |selector: &str| format!("document.querySelectorAll('#drawing {selector}').length");
    assert_eq!(page.number(&count(".link.arc .body")), 1.0);
    assert_eq!(page.number(&count(".guide.arc .hatching")), 2.0);
    assert_eq!(page.number(&count("[data-slider]")), 0.0);
    let colours = "(() => { const of = (name) => document.querySelector(name).style.getPropertyValue('--colour'); \
         return of('[data-guide=slot]') === of('[data-link=lever]'); })()";
    assert!(page.holds(colours));
    // Slots are in their plates, and below the rods of their pins.
    let order = "[...document.querySelectorAll('#drawing .bodies > g')].map((g) => g.dataset.guide ?? g.dataset.link).join(' ')";
    assert_eq!(page.words(order), "way ring lever slot rod");
    // All of the slots is in sight, although no point is where the plate ends.
    let inside = "(() => { const sheet = document.querySelector('#drawing').getBoundingClientRect(); \
         return [...document.querySelectorAll('#drawing .arc')].every((arc) => { const box = arc.getBoundingClientRect(); \
         return box.left > sheet.left && box.right < sheet.right && box.top > sheet.top && box.bottom < sheet.bottom; }); })()";
    for row in [0, 30, 60, 90] {
        checks::go_to(&mut page, row);
        assert!(page.holds(inside), "row {row}");
    }
    page.assert_quiet();
}

/// Seen from the lever its slot rests, and the frame's slots move with the frame.
#[test]
fn slots_are_seen_from_links() {
    let Some(mut page) = Page::open(&written(&slots(), "slots-seen")) else {
        return;
    };
    page.value("(() => { const seen = document.querySelector('#seen'); seen.value = [...seen.options].find((o) => o.textContent === 'lever').value; seen.dispatchEvent(new Event('change')); })()");
    assert_lines(&mut page);
    let lines = |page: &mut Page| {
        ["slot", "way"].map(|guide| {
            page.words(&format!(
                "document.querySelector('[data-guide={guide}] .gap').getAttribute('d')"
            ))
        })
    };
    checks::go_to(&mut page, 20);
    let before = lines(&mut page);
    checks::go_to(&mut page, 70);
    let after = lines(&mut page);
    assert_eq!(before[0], after[0]);
    assert_ne!(before[1], after[1]);
    page.assert_quiet();
}
