//! The view of mechanisms in space.

use crate::checks;
use linkage_browser::Page;
use linkage_browser::samples::{spatial, written};

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
