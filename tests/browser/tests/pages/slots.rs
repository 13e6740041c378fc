//! Curved slots.

use crate::checks;
use linkage_browser::Page;
use linkage_browser::samples::{slots, written};
use serde_json::Value;

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
