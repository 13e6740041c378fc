//! Parts of plots, what they are against, and their extremes. The cam's lift is `8 sin phi`, its force `5 cos phi`.

use linkage_browser::samples::{falling, many, roundoff, written};
use linkage_browser::{PHONE, Page};

const LIFT: &str = ".panel[data-unit=mm] .plot";

fn page(name: &str) -> Option<Page> {
    Page::open(&written(&many(361), name))
}

/// The numbers at an axis of the lift's panel, with their places on it in the window.
fn ticks(page: &mut Page, anchor: &str) -> Vec<[f64; 2]> {
    let at = if anchor == "middle" { "x" } else { "y" };
    let found = page.value(&format!(
        "(() => {{ const plot = document.querySelector('{LIFT}'); const box = plot.getBoundingClientRect(); \
           return [...plot.querySelectorAll('.axes text:not(.title)')].filter((t) => t.getAttribute('text-anchor') === '{anchor}') \
             .map((t) => [Number(t.textContent), Number(t.getAttribute('{at}')) + ('{at}' === 'x' ? box.left : box.top - 4)]); }})()"
    ));
    let pair = |tick: &serde_json::Value| [0, 1].map(|i| tick[i].as_f64().expect("a number"));
    found.as_array().expect("ticks").iter().map(pair).collect()
}

/// What stands at a place of an axis; which place a number has.
fn number_at(ticks: &[[f64; 2]], place: f64) -> f64 {
    let [a, b] = [ticks[0], ticks[ticks.len() - 1]];
    a[0] + (place - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
}

fn place_of(ticks: &[[f64; 2]], number: f64) -> f64 {
    let [a, b] = [ticks[0], ticks[ticks.len() - 1]];
    a[1] + (number - a[0]) / (b[0] - a[0]) * (b[1] - a[1])
}

/// The ends of the abscissa and the ordinate of the lift.
fn ends(page: &mut Page) -> [[f64; 2]; 2] {
    let frame = page.place(&format!("{LIFT} .frame"));
    let (x, y) = (ticks(page, "middle"), ticks(page, "end"));
    let [left, top, wide, tall] = frame;
    [
        [left, left + wide].map(|place| number_at(&x, place)),
        [top + tall, top].map(|place| number_at(&y, place)),
    ]
}

fn near(found: [f64; 2], expected: [f64; 2], by: f64) {
    let apart = [0, 1].map(|i| (found[i] - expected[i]).abs());
    assert!(
        apart[0] < by && apart[1] < by,
        "{found:?} instead of {expected:?}"
    );
}

#[test]
fn a_rectangle_fills_the_panel() {
    let Some(mut page) = page("parts-rectangle") else {
        return;
    };
    page.middle(LIFT);
    let (x, y) = (ticks(&mut page, "middle"), ticks(&mut page, "end"));
    let corner = |a: f64, b: f64| (place_of(&x, a), place_of(&y, b));
    page.shift_drag(corner(45.0, 2.0), corner(135.0, 6.0));
    let [wide, tall] = ends(&mut page);
    near(wide, [45.0, 135.0], 1.0);
    near(tall, [2.0, 6.0], 0.1);
    assert_eq!(page.row(), 0, "the position stays");
    // The other panel has the same abscissa, and the ordinate of what is seen there: 5 cos of 45 to 135 degrees.
    let force = ".panel[data-unit=N] .axes text[text-anchor=end]";
    let labels = page.words(&format!(
        "[...document.querySelectorAll('{force}')].map((t) => t.textContent).join(' ')"
    ));
    assert!(labels.contains('2') && !labels.contains('5'), "{labels}");
    page.shoot("parts-rectangle");
    let place = page.middle(LIFT);
    page.double_click(place);
    let [wide, tall] = ends(&mut page);
    near(wide, [0.0, 360.0], 0.5);
    assert!(tall[0] < -8.0 && tall[1] > 8.0, "{tall:?}");
    page.assert_quiet();
}

#[test]
fn wheel_keys_and_buttons_zoom() {
    let Some(mut page) = page("parts-wheel") else {
        return;
    };
    page.middle(LIFT);
    let x = ticks(&mut page, "middle");
    let place = (place_of(&x, 90.0), page.middle(LIFT).1);
    page.control_wheel(place, -200.0);
    page.settle();
    let [wide, _] = ends(&mut page);
    assert!(wide[1] - wide[0] < 250.0, "{wide:?}");
    let zoomed = ticks(&mut page, "middle");
    assert!(
        (number_at(&zoomed, place.0) - 90.0).abs() < 1.0,
        "what is under the pointer stays"
    );
    // Without a key the wheel scrolls the page.
    page.wheel(place, 100.0);
    page.settle();
    near(ends(&mut page)[0], wide, 1e-9);
    page.value(&format!("document.querySelector('{LIFT}').focus()"));
    page.letter("0");
    near(ends(&mut page)[0], [0.0, 360.0], 0.5);
    // About the position, here the first one; the panel keeps the focus.
    page.letter("+");
    page.letter("+");
    near(ends(&mut page)[0], [0.0, 160.0], 0.5);
    page.letter("-");
    near(ends(&mut page)[0], [0.0, 240.0], 0.5);
    page.click("#part-all");
    near(ends(&mut page)[0], [0.0, 360.0], 0.5);
    page.screen(PHONE);
    page.click("#part-less");
    near(ends(&mut page)[0], [0.0, 240.0], 0.5);
    page.middle("#part-less");
    page.shoot("parts-phone");
    let wide = page.number("document.documentElement.scrollWidth");
    assert!(wide <= f64::from(PHONE.width), "{wide} pixels");
    page.assert_quiet();
}

#[test]
fn one_quantity_against_another() {
    let Some(mut page) = page("parts-against") else {
        return;
    };
    page.value(
        "(() => { const s = document.querySelector('#abscissa'); s.value = 'cam||force|N'; s.dispatchEvent(new Event('change')); })()",
    );
    page.middle(LIFT);
    let title = format!(
        "[...document.querySelectorAll('{LIFT} .axes .title')].map((t) => t.textContent).join(' ')"
    );
    assert_eq!(page.words(&title), "force [N] lift [mm]");
    // An ellipse: the way there and back.
    let path = page.words(&format!(
        "document.querySelector('{LIFT} .curve').getAttribute('d')"
    ));
    let [left, top, ..] = page.place(LIFT);
    let (x, y) = (ticks(&mut page, "middle"), ticks(&mut page, "end"));
    let corners: Vec<f64> = path
        .split(['M', 'L', ' '])
        .filter_map(|part| part.parse().ok())
        .collect();
    assert_eq!(corners.len(), 2 * 361);
    for row in [0_usize, 60, 135, 300] {
        let phi = (row as f64).to_radians();
        let seen = [
            number_at(&x, left + corners[2 * row]),
            number_at(&y, top + corners[2 * row + 1]),
        ];
        near(seen, [5.0 * phi.cos(), 8.0 * phi.sin()], 0.1);
    }
    // A click goes to the nearest place of the curve, above and below.
    for (row, force, lift) in [(60, 2.5, 6.93), (300, 2.5, -6.93)] {
        page.click_at((place_of(&x, force), place_of(&y, lift)));
        assert!(
            page.row().abs_diff(row) <= 2,
            "{} instead of {row}",
            page.row()
        );
    }
    page.shoot("parts-against");
    page.assert_quiet();
}

#[test]
fn extremes_are_marked() {
    let Some(mut page) = page("parts-extremes") else {
        return;
    };
    let marks = "[...document.querySelectorAll('[data-extreme]')].map((m) => [m.dataset.extreme, m.dataset.of, m.dataset.row].join(' ')).join('; ')";
    assert_eq!(
        page.words(marks),
        "lowest cam||lift|mm 270; highest cam||lift|mm 90; lowest cam||force|N 180; highest cam||force|N 0"
    );
    let words = "[...document.querySelectorAll('[data-extreme] text')].map((t) => t.textContent).join('; ')";
    assert_eq!(
        page.words(words),
        "-8 at 270 deg; 8 at 90 deg; -5 at 180 deg; 5 at 0 deg"
    );
    // They stand on the curve, and the labels within the frame.
    let apart = page.number(&format!(
        "(() => {{ const d = document.querySelector('{LIFT} .curve').getAttribute('d').match(/-?[\\d.]+/g).map(Number); \
           const c = document.querySelector('{LIFT} [data-row=\"90\"] circle'); \
           return Math.hypot(Number(c.getAttribute('cx')) - d[180], Number(c.getAttribute('cy')) - d[181]); }})()"
    ));
    assert!(apart < 0.02, "{apart}");
    let outside = "[...document.querySelectorAll('[data-extreme] text')].filter((t) => { \
        const [a, b] = [t, t.closest('svg').querySelector('.frame')].map((n) => n.getBoundingClientRect()); \
        return a.left < b.left || a.right > b.right || a.top < b.top - 1 || a.bottom > b.bottom + 1; }).length";
    assert_eq!(page.number(outside), 0.0);
    // Of a part, those of the part.
    page.value(&format!("document.querySelector('{LIFT}').focus()"));
    page.letter("+");
    page.letter("+");
    let found = page.words(marks);
    assert!(
        found.starts_with("lowest cam||lift|mm 0; highest cam||lift|mm 90;"),
        "{found}"
    );
    page.click("#extremes");
    assert_eq!(page.words(marks), "");
    page.assert_quiet();
    let mut constant = Page::open(&written(&roundoff(), "parts-constant")).expect("as before");
    assert_eq!(constant.words(marks), "", "roundoff has no extremes");
}

/// Positions that fall are on an axis that rises, as any other, and are played from the first to the last.
#[test]
fn positions_may_fall() {
    let Some(mut page) = Page::open(&written(&falling(361), "parts-falling")) else {
        return;
    };
    page.middle(LIFT);
    near(ends(&mut page)[0], [0.0, 360.0], 0.5);
    let (x, y) = (ticks(&mut page, "middle"), ticks(&mut page, "end"));
    page.click_at((place_of(&x, 90.0), place_of(&y, 0.0)));
    assert!(page.row().abs_diff(270) <= 1, "{}", page.row());
    page.shift_drag(
        (place_of(&x, 45.0), place_of(&y, -2.0)),
        (place_of(&x, 135.0), place_of(&y, 8.5)),
    );
    near(ends(&mut page)[0], [45.0, 135.0], 1.0);
    page.click("#play");
    page.wait("Number(document.querySelector('#position').value) > 275");
    page.assert_quiet();
}
