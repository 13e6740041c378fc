//! What holds for every page.

use linkage_browser::{DESKTOP, Key, PHONE, Page, REPORT, SMALL_PHONE};
use serde_json::Value;

/// Everything that does not depend on what the page shows.
pub(crate) fn all(page: &mut Page, name: &str) {
    page.assert_quiet();
    vectors_are_whole(page);
    keys(page);
    slider(page);
    let report = report(page);
    if !report["picture"].is_null() {
        for row in rows(&report) {
            go_to(page, row);
            points_stand_where_the_data_say(page, &report, row);
        }
    }
    fits(page, name);
    page.assert_quiet();
}

/// The data of the page, with the numbers of the columns that they refer to.
pub(crate) fn report(page: &mut Page) -> Value {
    let mut report = page.value(REPORT);
    let tables = report["tables"].clone();
    resolve(&mut report, &tables);
    report
}

fn resolve(value: &mut Value, tables: &Value) {
    match value {
        Value::Object(members) => {
            let index = |name: &str| members.get(name).and_then(Value::as_u64);
            if let (Some(table), Some(column)) = (index("table"), index("column")) {
                *value = tables[table as usize]["columns"][column as usize]["values"].clone();
                return;
            }
            members.values_mut().for_each(|item| resolve(item, tables));
        }
        Value::Array(items) => items.iter_mut().for_each(|item| resolve(item, tables)),
        _ => {}
    }
}

/// Whether a number is shown with six significant digits, rounded and not cut.
pub(crate) fn is_short_for(shown: &str, value: f64) -> bool {
    let mantissa = shown.split('e').next().unwrap_or_default();
    let digits = mantissa
        .chars()
        .filter(char::is_ascii_digit)
        .collect::<String>();
    let digits = digits.trim_start_matches('0').len();
    let is_whole = value == value.trunc() && value.abs() < 1e9;
    let near = |shown: f64| (shown - value).abs() <= 5e-6 * value.abs();
    shown.parse().is_ok_and(near) && (digits <= 6 || is_whole)
}

/// Some rows, those at the ends among them.
pub(crate) fn rows(report: &Value) -> Vec<usize> {
    let last = report["input"]["values"].as_array().map_or(0, Vec::len) - 1;
    let mut rows = vec![0, last / 5, last / 2, 3 * last / 4, last];
    rows.dedup();
    rows
}

/// Goes to a row with keys alone.
pub(crate) fn go_to(page: &mut Page, row: usize) {
    page.key(Key::Home);
    for _ in 0..row / 10 {
        page.shift(Key::Right);
    }
    for _ in 0..row % 10 {
        page.key(Key::Right);
    }
    assert_eq!(page.row(), row);
}

/// Of a vector that is plotted at first no component is missing.
fn vectors_are_whole(page: &mut Page) {
    let halves = page.words(
        "(() => { const boxes = [...document.querySelectorAll('#chooser input[data-column]')]; \
           const vector = (box) => { const [table, kind, name, unit] = box.dataset.column.split('|'); \
             return [table, kind, name.replace(/\\.[xyz]$/, ''), unit].join('|'); }; \
           const whole = new Set(boxes.filter((box) => box.checked).map(vector)); \
           return boxes.filter((box) => whole.has(vector(box)) && !box.checked).map((box) => box.dataset.column).join(' '); })()",
    );
    assert_eq!(halves, "", "components that are missing");
}

fn keys(page: &mut Page) {
    let last = page.number("Number(document.querySelector('#position').max)") as usize;
    let steps = [
        (Key::Home, false, 0),
        (Key::Left, false, 0),
        (Key::Right, false, 1),
        (Key::Right, true, last.min(11)),
        (Key::Left, false, last.min(11) - 1),
        (Key::End, false, last),
        (Key::Right, true, last),
        (Key::Left, true, last.saturating_sub(10)),
    ];
    for (key, shift, row) in steps {
        if shift {
            page.shift(key);
        } else {
            page.key(key);
        }
        assert_eq!(page.row(), row, "after {key:?}");
    }
}

fn slider(page: &mut Page) {
    page.key(Key::Home);
    let last = page.number("Number(document.querySelector('#position').max)");
    page.middle("#position");
    let [left, top, width, height] = page.place("#position");
    for part in [0.25, 0.5, 0.8] {
        page.click_at((left + part * width, top + height / 2.0));
        let reached = page.row() as f64 / last;
        assert!(
            (reached - part).abs() < 0.05,
            "the slider at {part} of its length leads to {reached}"
        );
    }
    page.drag(
        (left + 0.8 * width, top + height / 2.0),
        (left + 0.1 * width, top + height / 2.0),
    );
    assert!((page.row() as f64 / last - 0.1).abs() < 0.05);
    // With the focus on the slider, its own keys and those of the page are one step, and not two.
    let row = page.row();
    page.key(Key::Right);
    page.key(Key::Up);
    assert_eq!(page.row(), row + 2);
}

/// The data of the drawn points are the report's, to the last bit, and in the plane the circles on the screen are there by
/// the drawing's scale, to a pixel's fraction.
pub(crate) fn points_stand_where_the_data_say(page: &mut Page, report: &Value, row: usize) {
    let picture = &report["picture"];
    let drawn = page.value(
        "(() => { const view = document.querySelector('#drawing'); const at = view.getBoundingClientRect(); \
         const { scale, originX, originY } = view.dataset; \
         return { scale: Number(scale), origin: [at.left + Number(originX), at.top + Number(originY)], \
           points: [...view.querySelectorAll('[data-point]')].map((p) => { \
             const r = p.querySelector('.mark').getBoundingClientRect(); \
             return { name: p.dataset.point, hidden: getComputedStyle(p).display === 'none', \
               at: [p.dataset.x, p.dataset.y, p.dataset.z].map((c) => c === undefined ? null : Number(c)), \
               seen: [r.left + r.width / 2, r.top + r.height / 2] }; }) }; })()",
    );
    let points = drawn_points(picture);
    assert_eq!(drawn["points"].as_array().map(Vec::len), Some(points.len()));
    for (point, seen) in points
        .iter()
        .zip(drawn["points"].as_array().into_iter().flatten())
    {
        assert_eq!(point["name"], seen["name"]);
        let place: Vec<Option<f64>> = point["at"]
            .as_array()
            .expect("components")
            .iter()
            .map(|c| c[row].as_f64())
            .collect();
        let Some(place) = place.into_iter().collect::<Option<Vec<f64>>>() else {
            assert_eq!(
                seen["hidden"], true,
                "{} does not exist in row {row}",
                point["name"]
            );
            continue;
        };
        let data: Vec<f64> = (0..place.len())
            .map(|i| seen["at"][i].as_f64().unwrap_or(f64::NAN))
            .collect();
        assert_eq!(data, place, "{} in row {row}", point["name"]);
        if picture["dimension"] == 2 {
            on_screen(&place, seen, &drawn);
        }
    }
}

/// The points of a picture without those that only say where a guide is.
pub(crate) fn drawn_points(picture: &Value) -> Vec<&Value> {
    let points = picture["points"].as_array().expect("points");
    points
        .iter()
        .filter(|point| point["kind"] != "construction")
        .collect()
}

fn on_screen(place: &[f64], seen: &Value, drawn: &Value) {
    let number = |value: &Value| value.as_f64().unwrap_or(f64::NAN);
    let scale = number(&drawn["scale"]);
    let expected = [
        number(&drawn["origin"][0]) + scale * place[0],
        number(&drawn["origin"][1]) - scale * place[1],
    ];
    for (i, expected) in expected.into_iter().enumerate() {
        let found = number(&seen["seen"][i]);
        assert!(
            (found - expected).abs() < 0.1,
            "{}: on the screen at {found}, not {expected}",
            seen["name"]
        );
    }
}

/// Nothing is wider than the window, controls are in it, on desktop and phones; with pictures of both, light and dark.
fn fits(page: &mut Page, name: &str) {
    for screen in [DESKTOP, PHONE, SMALL_PHONE] {
        page.screen(screen);
        page.value("window.scrollTo(0, 0)");
        for (dark, colours) in [(false, "light"), (true, "dark")] {
            page.dark(dark);
            page.shoot(&format!("{name}-{}-{colours}", screen.name));
        }
        page.dark(false);
        let wide = page.number("document.documentElement.scrollWidth");
        assert!(
            wide <= f64::from(screen.width),
            "{name} is {wide} pixels wide on a {}: {}",
            screen.name,
            beyond(page)
        );
        assert_eq!(
            covered(page),
            "",
            "buttons of {name} that something else covers on a {}",
            screen.name
        );
        for control in ["#play", "#position", "#speed"] {
            let [left, top, width, height] = page.place(control);
            let inside = left >= 0.0
                && top >= 0.0
                && left + width <= f64::from(screen.width)
                && top + height <= f64::from(screen.height);
            assert!(
                inside,
                "{control} of {name} is out of sight on a {}: {:?}",
                screen.name,
                [left, top, width, height]
            );
        }
    }
    page.screen(DESKTOP);
}

/// What reaches beyond the window.
fn beyond(page: &mut Page) -> String {
    page.words(
        "[...document.querySelectorAll('body *')].filter((item) => item.getBoundingClientRect().right > innerWidth) \
         .map((item) => `${item.tagName}#${item.id}.${item.getAttribute('class')} ${item.textContent.slice(0, 20)}`).slice(0, 8).join('; ')",
    )
}

/// Buttons above the plots that cannot be hit in their middle.
fn covered(page: &mut Page) -> String {
    page.words(
        "[...document.querySelectorAll('header button, #figure button, #controls button, #controls select')].filter((button) => { \
           const box = button.getBoundingClientRect(); \
           return box.width > 0 && !button.contains(document.elementFromPoint(box.left + box.width / 2, box.top + box.height / 2)) \
         }).map((button) => button.id || button.textContent).join(' ')",
    )
}
