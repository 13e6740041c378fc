//! Signs of the drawing, and the view of mechanisms in space.

use crate::checks;
use linkage_browser::samples::{sliders, spatial, written};
use linkage_browser::{Page, entries};

// Signs of the drawing: gears, arrows at inputs, joints in space.

/// The middle of what an expression names, in the window.
fn middles(page: &mut Page, selector: &str) -> Vec<[f64; 2]> {
    let found = page.value(&format!(
        "[...document.querySelectorAll({selector:?})].map((node) => {{ const r = node.getBoundingClientRect(); return [r.left + r.width / 2, r.top + r.height / 2, r.width]; }})"
    ));
    let boxes = found.as_array().into_iter().flatten();
    let number = |value: &serde_json::Value| value.as_f64().unwrap_or(f64::NAN);
    boxes
        .map(|own| [number(&own[0]), number(&own[1])])
        .collect()
}

fn mark(page: &mut Page, point: &str) -> [f64; 2] {
    middles(page, &format!("[data-point={point:?}] .mark"))[0]
}

fn angle(from: [f64; 2], to: [f64; 2]) -> f64 {
    // Upwards is negative in the window.
    (from[1] - to[1]).atan2(to[0] - from[0])
}

fn wrapped(angle: f64) -> f64 {
    angle - std::f64::consts::TAU * (angle / std::f64::consts::TAU).round()
}

/// Wheels touch, their ratio is told, the arrow goes the way of the crank.
#[test]
fn gears_and_the_arrow_of_the_gallery() {
    let entries = entries();
    let Some(entry) = entries.iter().find(|entry| entry.name == "favorit") else {
        return;
    };
    let Some(mut page) = Page::open(&entry.page) else {
        return;
    };
    for row in [0, 130, 500] {
        checks::go_to(&mut page, row);
        let wheels = middles(&mut page, ".wheel");
        for (wheel, pivot) in wheels.iter().zip(["pivot_1", "pivot_7"]) {
            let pivot = mark(&mut page, pivot);
            assert!((wheel[0] - pivot[0]).hypot(wheel[1] - pivot[1]) < 0.1);
        }
        let radii = page.value(
            "[...document.querySelectorAll('.wheel')].map((wheel) => wheel.r.baseVal.value)",
        );
        let radii = [0, 1].map(|i| radii[i].as_f64().expect("a radius"));
        let apart = (wheels[0][0] - wheels[1][0]).hypot(wheels[0][1] - wheels[1][1]);
        assert!(
            (radii[0] + radii[1] - apart).abs() < 0.1,
            "{radii:?}, {apart} apart"
        );
        assert!((radii[1] / radii[0] - 2.0).abs() < 1e-3, "{radii:?}");
        assert_eq!(
            page.words("document.querySelector('.ratio').textContent"),
            "1 : -0.5"
        );
        // All of them is in sight.
        assert!(page.holds("[...document.querySelectorAll('.wheel')].every((wheel) => { const r = wheel.getBoundingClientRect(); const f = document.querySelector('#figure').getBoundingClientRect(); return r.left > f.left && r.right < f.right && r.top > f.top && r.bottom < f.bottom; })"));
        let pivot = mark(&mut page, "pivot_1");
        let before = angle(pivot, mark(&mut page, "p2"));
        let head = angle(pivot, middles(&mut page, ".drive .head")[0]);
        checks::go_to(&mut page, row + 1);
        let turned = wrapped(angle(pivot, mark(&mut page, "p2")) - before);
        assert!(
            turned * wrapped(head - before) > 0.0,
            "it turns by {turned}, the arrow ends at {head} and begins at {before}"
        );
    }
    page.assert_quiet();
}

#[test]
fn joints_in_space_differ() {
    let Some(mut page) = Page::open(&written(&spatial(), "signs-space")) else {
        return;
    };
    let kinds = "[...document.querySelectorAll('[data-joint]')].map((sign) => `${sign.closest('.point').dataset.point} ${sign.dataset.joint}`).join(', ')";
    assert_eq!(
        page.words(kinds),
        "shaft pin, pivot pin, p ball, q universal"
    );
    checks::go_to(&mut page, 33);
    page.shoot("signs-space");
    // Along its axis a sleeve is seen from its end, across it at its full length.
    let width = "document.querySelector('[data-point=shaft] .sleeve').getBBox()";
    page.click("[data-view='x-y']");
    let end = [
        page.number(&format!("{width}.width")),
        page.number(&format!("{width}.height")),
    ];
    page.click("[data-view='x-z']");
    let side = [
        page.number(&format!("{width}.width")),
        page.number(&format!("{width}.height")),
    ];
    assert!((end[0] - end[1]).abs() < 0.1, "{end:?}");
    assert!(side[1] > 2.0 * side[0], "{side:?}");
    for sign in ["p", "q"] {
        let [joint, socket] = [
            mark(&mut page, sign),
            middles(&mut page, &format!("[data-point={sign}] .socket"))[0],
        ];
        assert!((joint[0] - socket[0]).hypot(joint[1] - socket[1]) < 0.1);
    }
    // A ball is full, others are rings.
    let fill = |page: &mut Page, point: &str| {
        page.words(&format!(
            "getComputedStyle(document.querySelector('[data-point={point}] .mark')).fill"
        ))
    };
    assert_ne!(fill(&mut page, "p"), fill(&mut page, "q"));
    page.assert_quiet();
}

#[test]
fn arrows_tell_what_the_input_moves() {
    let Some(mut page) = Page::open(&written(&sliders(), "signs-drives")) else {
        return;
    };
    // The crank turns to the left, the slider's arrow goes along its guide.
    let pivot = mark(&mut page, "main");
    let heads = middles(&mut page, ".drive .head");
    let crank = angle(pivot, mark(&mut page, "big"));
    assert!(wrapped(angle(pivot, heads[0]) - crank) > 0.3);
    let slider = mark(&mut page, "small");
    assert!(
        heads[1][0] > slider[0] + 8.0 && heads[1][1] < slider[1] - 8.0,
        "{heads:?}, {slider:?}"
    );
    page.shoot("signs-drives");
    page.assert_quiet();
}

// The view of mechanisms in space.

/// Places of all points on the screen.
fn seen(page: &mut Page) -> Vec<[f64; 2]> {
    let found = page.value(
        "[...document.querySelectorAll('#drawing .mark')].map((m) => [Number(m.getAttribute('cx')), Number(m.getAttribute('cy'))])",
    );
    let points = found.as_array().expect("points");
    points
        .iter()
        .map(|p| [0, 1].map(|i| p[i].as_f64().expect("a place")))
        .collect()
}

#[test]
fn dragging_turns_it() {
    let file = written(&spatial(), "space");
    let Some(mut page) = Page::open(&file) else {
        return;
    };
    checks::all(&mut page, "space");
    let before = seen(&mut page);
    let middle = page.middle("#drawing");
    let from = (middle.0 - 120.0, middle.1 + 90.0);
    page.drag(from, (from.0 + 80.0, from.1 - 30.0));
    let after = seen(&mut page);
    // Turned and not only moved: on the screen, points change their places relative to the first.
    let changed = |i: usize, c: usize| (after[i][c] - after[0][c]) - (before[i][c] - before[0][c]);
    let turned = (1..before.len()).map(|i| changed(i, 0).hypot(changed(i, 1)));
    let turned = turned.fold(0.0, f64::max);
    assert!(turned > 10.0, "points moved by {turned} pixels");
    page.shoot("space-turned");
    page.assert_quiet();
}

/// Along an axis, what is seen are two components of the data by the drawing's scale.
#[test]
fn views_along_axes_are_to_scale() {
    let file = written(&spatial(), "views");
    let Some(mut page) = Page::open(&file) else {
        return;
    };
    let report = checks::report(&mut page);
    checks::go_to(&mut page, 40);
    for (view, across, up) in [("x-y", 0, 1), ("x-z", 0, 2), ("y-z", 1, 2)] {
        page.click(&format!("[data-view={view}]"));
        let scale = page.number("Number(document.querySelector('#drawing').dataset.scale)");
        let origin = ["X", "Y"].map(|a| {
            page.number(&format!(
                "Number(document.querySelector('#drawing').dataset.origin{a})"
            ))
        });
        let points = report["picture"]["points"].as_array().expect("points");
        for (point, [x, y]) in points.iter().zip(seen(&mut page)) {
            let at = |i: usize| point["at"][i][40].as_f64().expect("a component");
            let expected = [origin[0] + scale * at(across), origin[1] - scale * at(up)];
            assert!(
                (x - expected[0]).abs() < 0.1 && (y - expected[1]).abs() < 0.1,
                "{view}, {}: {x}, {y}, not {expected:?}",
                point["name"]
            );
        }
    }
    page.assert_quiet();
}
