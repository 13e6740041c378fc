//! Velocities, accelerations and poles in the drawing, and the time as abscissa.

use crate::checks;
use linkage_browser::samples::{FourBar, four_bar, spatial, written};
use linkage_browser::{PHONE, Page};

/// The first or second derivative of the tracer by a step that leaves six digits.
fn derivative(row: usize, order: usize) -> [f64; 2] {
    const STEP: f64 = 1e-3;
    let phi = (row as f64).to_radians();
    let [before, here, after] =
        [-STEP, 0.0, STEP].map(|step| FourBar::TURNING.points(phi + step)[2]);
    [0, 1].map(|k| match order {
        1 => (after[k] - before[k]) / (2.0 * STEP),
        _ => (after[k] - 2.0 * here[k] + before[k]) / (STEP * STEP),
    })
}

/// An arrow on the screen, upwards positive, and the number in its title.
fn arrow(page: &mut Page, kind: &str) -> ([f64; 2], f64) {
    let found = page.value(&format!(
        "(() => {{ const own = document.querySelector('.{kind}[data-arrow=tracer]'); \
           const [a, b, c, d] = own.querySelector('.line').getAttribute('d').match(/-?[\\d.]+/g).map(Number); \
           return [c - a, b - d, Number(/: ([\\d.]+) mm/.exec(own.querySelector('title').textContent)[1])]; }})()"
    ));
    let [x, y, size] = [0, 1, 2].map(|k| found[k].as_f64().expect("a number"));
    ([x, y], size)
}

#[test]
fn arrows_are_the_derivatives() {
    let Some(mut page) = Page::open(&written(&four_bar("Arrows", FourBar::TURNING), "arrows"))
    else {
        return;
    };
    for kind in ["velocity", "acceleration"] {
        page.click(&format!("[data-vectors={kind}]"));
    }
    let mut scales = Vec::new();
    // At the ends the other end of the turn goes on.
    for row in [0, 77, 200, 360] {
        checks::go_to(&mut page, row);
        for (kind, order) in [("velocity", 1), ("acceleration", 2)] {
            let [x, y] = derivative(row, order);
            let ([u, v], size) = arrow(&mut page, kind);
            assert!(
                (size / x.hypot(y) - 1.0).abs() < 1e-3,
                "{kind} at {row}: {size}, {}",
                x.hypot(y)
            );
            let across = (u * y - v * x) / (u.hypot(v) * x.hypot(y));
            assert!(
                across.abs() < 0.02 && u * x + v * y > 0.0,
                "{kind} at {row}: {u}, {v} for {x}, {y}"
            );
            if kind == "velocity" {
                scales.push(u.hypot(v) / size);
            }
        }
    }
    // One scale for all positions.
    assert!(
        scales
            .iter()
            .all(|own| (own / scales[0] - 1.0).abs() < 0.02),
        "{scales:?}"
    );
    page.shoot("arrows");
    page.click("[data-vectors=velocity]");
    assert!(page.holds("document.querySelector('.velocity') === null && document.querySelector('.acceleration') !== null"));
    page.assert_quiet();
}

/// The coupler turns about the point in which crank and rocker meet.
#[test]
fn poles_are_where_links_are_at_rest() {
    let Some(mut page) = Page::open(&written(&four_bar("Poles", FourBar::TURNING), "poles")) else {
        return;
    };
    page.click("[data-vectors=poles]");
    for row in [30, 77, 300] {
        checks::go_to(&mut page, row);
        let [a, b, _] = FourBar::TURNING.points((row as f64).to_radians());
        let from = [b[0] - FourBar::TURNING.frame, b[1]];
        // The crank's line through the origin, and the rocker's.
        let along = (FourBar::TURNING.frame * from[1]) / (a[0] * from[1] - a[1] * from[0]);
        let expected = [along * a[0], along * a[1]];
        let found = page.value("(() => { const all = [...document.querySelectorAll('[data-pole]')]; return [all.length, ...['x', 'y'].map((own) => Number(all[0].dataset[own]))]; })()");
        // Crank and rocker turn about their pivots, which have no other mark.
        assert_eq!(found[0], 1, "{found}");
        for (k, expected) in expected.iter().enumerate() {
            let found = found[k + 1].as_f64().expect("a number");
            assert!(
                (found - expected).abs() < 1e-4 * expected.abs().max(100.0),
                "{row}: {found}, {expected}"
            );
        }
    }
    page.screen(PHONE);
    page.shoot("poles-phone");
    page.assert_quiet();
}

#[test]
fn arrows_in_space_and_next_to_gaps() {
    for (name, report) in [
        ("space", spatial()),
        ("swinging", four_bar("Arrows", FourBar::SWINGING)),
    ] {
        let Some(mut page) = Page::open(&written(&report, &format!("arrows-{name}"))) else {
            return;
        };
        for kind in ["velocity", "acceleration"] {
            page.click(&format!("[data-vectors={kind}]"));
        }
        assert_eq!(
            page.holds("document.querySelector('[data-vectors=poles]') === null"),
            name == "space"
        );
        let last = page.number("Number(document.querySelector('#position').max)") as usize;
        let mut arrows = 0.0;
        for row in [0, last / 4, last / 2, last] {
            checks::go_to(&mut page, row);
            arrows += page.number("document.querySelectorAll('.vectors [data-arrow]').length");
        }
        assert!(arrows > 0.0);
        assert!(page.holds("!document.querySelector('.vectors').innerHTML.includes('NaN')"));
        page.assert_quiet();
    }
}

/// With a speed of the report the time is that of the machine.
#[test]
fn time_is_an_abscissa() {
    let Some(mut page) = Page::open(&written(&four_bar("Time", FourBar::TURNING), "plot-time"))
    else {
        return;
    };
    page.value("(() => { const own = document.getElementById('abscissa'); own.value = 'time'; own.dispatchEvent(new Event('change')); })()");
    assert_eq!(
        page.words("document.querySelector('.plot .axes .title').textContent"),
        "t [s]"
    );
    assert!(page.holds("document.getElementById('turning').disabled && document.getElementById('turning').value === '600'"));
    let ticks = page.words("[...document.querySelectorAll('.panel:first-child .axes text[text-anchor=middle]:not(.title)')].map((own) => own.textContent).join(' ')");
    assert_eq!(ticks, "0 0.02 0.04 0.06 0.08 0.1");
    // Half the time is half the turn.
    let [left, top, wide, tall] = page.place(".plot .frame");
    page.middle(".plot");
    let [_, moved, ..] = page.place(".plot .frame");
    page.click_at((left + wide / 2.0, moved + tall / 2.0));
    assert!(
        (page.row() as f64 - 180.0).abs() <= 1.0,
        "{} from {top}",
        page.row()
    );
    page.shoot("plot-time");
    page.assert_quiet();
}

/// At the ends of a range, and next to a gap, rows of one side are enough.
#[test]
fn arrows_at_ends_of_ranges() {
    let file = written(&four_bar("Ends", FourBar::SWINGING), "arrows-ends");
    let Some(mut page) = Page::open(&file) else {
        return;
    };
    page.click("[data-vectors=velocity]");
    let report = checks::report(&mut page);
    let there = |row: usize| report["tables"][0]["columns"][0]["values"][row].is_f64();
    let edge = (1..361).find(|&row| there(row) != there(row - 1));
    let edge = edge.expect("a gap");
    let row = if there(edge) { edge } else { edge - 1 };
    checks::go_to(&mut page, row);
    let (_, size) = arrow(&mut page, "velocity");
    assert!(size > 0.0);
    // Near a dead point the velocity changes fast: some rows away from it differences are good.
    let row = if there(edge) { edge + 12 } else { edge - 13 };
    checks::go_to(&mut page, row);
    let (_, size) = arrow(&mut page, "velocity");
    let phi = (row as f64).to_radians();
    let [before, after] = [-1e-5, 1e-5].map(|step| FourBar::SWINGING.points(phi + step)[2]);
    let exact = (after[0] - before[0]).hypot(after[1] - before[1]) / 2e-5;
    assert!((size / exact - 1.0).abs() < 1e-3, "{size}, {exact}");
    page.assert_quiet();
}

/// Vectors of a table as forces at points, all in one scale.
#[test]
fn forces_are_arrows_in_one_scale() {
    let report = four_bar("Forces", FourBar::TURNING).force("tracer", "v");
    let Some(mut page) = Page::open(&written(&report, "arrows-forces")) else {
        return;
    };
    page.click("[data-vectors=force]");
    let mut scales = Vec::new();
    for row in [0, 77, 200] {
        checks::go_to(&mut page, row);
        let [x, y] = derivative(row, 1);
        let found = page.value(
            "(() => { const own = document.querySelector('.force[data-arrow=v]'); \
               const [a, b, c, d] = own.querySelector('.line').getAttribute('d').match(/-?[\\d.]+/g).map(Number); \
               return [c - a, b - d, own.querySelector('title').textContent]; })()",
        );
        let [u, v] = [0, 1].map(|k| found[k].as_f64().expect("a number"));
        let across = (u * y - v * x) / (u.hypot(v) * x.hypot(y));
        assert!(
            across.abs() < 0.02 && u * x + v * y > 0.0,
            "{row}: {u}, {v}"
        );
        scales.push(u.hypot(v) / x.hypot(y));
        let title = found[2].as_str().expect("a title");
        assert!(
            title.starts_with("force of v: ") && title.ends_with(" mm/rad"),
            "{title}"
        );
    }
    assert!(
        scales
            .iter()
            .all(|scale| (scale / scales[0] - 1.0).abs() < 0.02),
        "{scales:?}"
    );
    page.assert_quiet();
    // Without forces there is no button for them.
    let file = written(&four_bar("Forces", FourBar::TURNING), "arrows-no-forces");
    let Some(mut page) = Page::open(&file) else {
        return;
    };
    assert!(page.holds("document.querySelector('[data-vectors=force]') === null"));
}
