//! Plots: what they show, and what pointers do in them.

use crate::checks;
use linkage_browser::samples::{FourBar, four_bar, roundoff, sliders, spatial, written};
use linkage_browser::{DESKTOP, PHONE, Page};

fn page(name: &str) -> Option<Page> {
    Page::open(&written(&four_bar("Plots", FourBar::TURNING), name))
}

#[test]
fn a_click_moves_the_position() {
    let Some(mut page) = page("plot-click") else {
        return;
    };
    let place = page.middle(".plot");
    page.click_at(place);
    let row = page.row();
    // The cursor stands where the click was, to half a row.
    let cursor = page.number(
        "document.querySelector('.cursor:not(.pointer) path').getBoundingClientRect().left",
    );
    assert!(
        (cursor - place.0).abs() < 1.5,
        "the cursor is at {cursor}, the click was at {}",
        place.0
    );
    assert!(row > 100 && row < 260, "{row}");
    page.drag(place, (place.0 + 80.0, place.1));
    assert!(page.row() > row + 20);
    page.assert_quiet();
}

#[test]
fn pointing_shows_values() {
    let Some(mut page) = page("plot-hover") else {
        return;
    };
    let report = checks::report(&mut page);
    let place = page.middle(".plot");
    page.point_at(place);
    let said = page.words("document.querySelector('.legend caption').innerText");
    assert!(
        said.starts_with("Pointer: phi = ") && said.contains(" rad)"),
        "{said}"
    );
    let degrees = said["Pointer: phi = ".len()..]
        .split(' ')
        .next()
        .expect("degrees")
        .parse::<f64>();
    let row = degrees.expect("a number").round() as usize;
    let value = report["tables"][0]["columns"][0]["values"][row]
        .as_f64()
        .expect("a value");
    let shown = page
        .words("document.querySelector('[data-column^=\"motion||tracer.x\"] .value').innerText");
    let first = shown.split(' ').next().expect("a number");
    assert!(checks::is_short_for(first, value), "{value} is {shown}");
    assert!(
        shown.contains("worst case \u{b1} ") && shown.contains("statistical \u{b1} "),
        "{shown}"
    );
    assert_eq!(page.row(), 0, "pointing moves nothing");
    page.shoot("plot-hover");
    page.point_at((5.0, 5.0));
    assert!(
        page.words("document.querySelector('.legend caption').innerText")
            .starts_with("Position: ")
    );
    page.assert_quiet();
}

#[test]
fn quantities_are_chosen() {
    let Some(mut page) = page("plot-choice") else {
        return;
    };
    let curves = "document.querySelectorAll('.curve').length";
    let panels = "[...document.querySelectorAll('.panel')].map((p) => p.dataset.unit).join(' ')";
    let first = page.number(curves);
    assert_eq!(page.words(panels), "mm deg mm/s rad/s");
    page.click("#quantities summary");
    page.click("input[data-column='motion||e[crank].x|mm/mm']");
    assert_eq!(page.number(curves), first + 1.0);
    assert_eq!(page.words(panels), "mm deg mm/mm mm/s rad/s");
    page.click("input[data-column='motion||e[crank].x|mm/mm']");
    assert_eq!(page.number(curves), first);
    page.click("#apart");
    assert_eq!(
        page.number("document.querySelectorAll('.panel').length"),
        first
    );
    page.click("#apart");
    assert_eq!(page.words(panels), "mm deg mm/s rad/s");
    // True velocities are the analogues times the speed.
    let report = checks::report(&mut page);
    let speed = report["speed"]["omega"].as_f64().expect("a speed");
    let analogue = report["tables"][0]["columns"][3]["values"][50]
        .as_f64()
        .expect("an analogue");
    let velocity = report["true"][0]["values"][50]
        .as_f64()
        .expect("a velocity");
    assert!((velocity - speed * analogue).abs() <= 1e-12 * velocity.abs());
    page.shoot("plot-choice");
    page.screen(PHONE);
    page.middle("#quantities summary");
    page.shoot("plot-choice-phone");
    let wide = page.number("document.documentElement.scrollWidth");
    assert!(wide <= f64::from(PHONE.width), "{wide} pixels");
    page.assert_quiet();
}

/// Every tick stands where its number is: read off the axis, the curve has the data's values.
#[test]
fn axes_are_true() {
    let Some(mut page) = page("plot-axes") else {
        return;
    };
    let report = checks::report(&mut page);
    let axes = page.value(
        "(() => { const plot = document.querySelector('.plot'); \
         const texts = [...plot.querySelectorAll('.axes text:not(.title)')]; \
         const numbers = (anchor, at) => texts.filter((t) => t.getAttribute('text-anchor') === anchor).map((t) => [Number(t.textContent), Number(t.getAttribute(at))]); \
         const path = plot.querySelector('.curve').getAttribute('d').match(/-?[\\d.]+/g).map(Number); \
         return { x: numbers('middle', 'x'), y: numbers('end', 'y').map(([v, y]) => [v, y - 4]), path }; })()",
    );
    let read = |axis: &str, pixels: f64| {
        let ticks = axes[axis].as_array().expect("ticks");
        let number = |tick: usize, i: usize| ticks[tick][i].as_f64().expect("a number");
        let last = ticks.len() - 1;
        assert!(last >= 2, "{ticks:?}");
        number(0, 0)
            + (pixels - number(0, 1)) / (number(last, 1) - number(0, 1))
                * (number(last, 0) - number(0, 0))
    };
    for row in [0_usize, 77, 200, 360] {
        let value = report["tables"][0]["columns"][0]["values"][row]
            .as_f64()
            .expect("a value");
        let (x, y) = (
            axes["path"][2 * row].as_f64().expect("x"),
            axes["path"][2 * row + 1].as_f64().expect("y"),
        );
        assert!(
            (read("x", x) - row as f64).abs() < 0.1,
            "row {row}: {}",
            read("x", x)
        );
        assert!(
            (read("y", y) - value).abs() < 0.05,
            "row {row}: {} instead of {value}",
            read("y", y)
        );
    }
    let titles = page.words("[...document.querySelectorAll('.panel:nth-child(2) .axes .title')].map((t) => t.textContent).join(' ')");
    assert_eq!(titles, "phi [deg] psi [deg]");
}

/// Bands that are drawn wider are so by the factor that is chosen, and the numbers stay what they are.
#[test]
fn bands_can_be_widened() {
    let Some(mut page) = page("plot-bands") else {
        return;
    };
    let band = "document.querySelector('.band.worst')";
    let said = page.words("document.querySelector('.legend .value').innerText");
    let widths = page.value(&format!(
        "(() => {{ const r = {band}.getBBox(); return [r.width, r.height]; }})()"
    ));
    assert!(widths[0].as_f64().expect("a width") > 400.0, "{widths}");
    let half = |page: &mut Page| {
        page.number(&format!(
            "(() => {{ const n = {band}.getAttribute('d').match(/-?[\\d.]+/g).map(Number); \
             return (n[n.length - 1] - n[1]) / 2; }})()"
        ))
    };
    assert!(half(&mut page) < 0.1);
    page.value(
        "(() => { const s = document.querySelector('#widening'); s.value = '100'; s.dispatchEvent(new Event('change')); })()",
    );
    let report = checks::report(&mut page);
    let value = report["bands"][0]["half"][0]
        .as_f64()
        .expect("half a width");
    let ticks = page.value(
        "[...document.querySelectorAll('.plot:first-child .axes text[text-anchor=end]')].map((t) => [Number(t.textContent), Number(t.getAttribute('y'))])",
    );
    let tick = |i: usize, j: usize| ticks[i][j].as_f64().expect("a tick");
    let scale = (tick(0, 1) - tick(1, 1)) / (tick(1, 0) - tick(0, 0));
    let drawn = half(&mut page) / scale;
    assert!(
        (drawn - 100.0 * value).abs() < 0.02 * drawn,
        "{drawn} instead of {value} times 100"
    );
    assert_eq!(
        page.words("document.querySelector('.legend .value').innerText"),
        said
    );
    page.shoot("plot-bands");
    page.assert_quiet();
}

/// What is constant but for the last bit is a straight line in the middle of an axis with ticks.
#[test]
fn roundoff_is_no_motion() {
    let Some(mut page) = Page::open(&written(&roundoff(), "roundoff")) else {
        return;
    };
    let panels = page.value(
        "[...document.querySelectorAll('.plot')].map((plot) => ({ \
           ticks: [...plot.querySelectorAll('.axes text[text-anchor=end]')].map((t) => Number(t.textContent)), \
           height: plot.querySelector('.curve').getBBox().height }))",
    );
    let panels = panels.as_array().expect("panels");
    assert_eq!(panels.len(), 3);
    for (panel, constant) in panels.iter().zip([8.0, 0.5, 0.0]) {
        let ticks: Vec<f64> = panel["ticks"]
            .as_array()
            .expect("ticks")
            .iter()
            .filter_map(serde_json::Value::as_f64)
            .collect();
        assert!((3..=7).contains(&ticks.len()), "{ticks:?}");
        assert!(ticks.contains(&constant), "{ticks:?} without {constant}");
        assert_eq!(panel["height"].as_f64(), Some(0.0), "{panel}");
    }
    page.shoot("roundoff");
    page.assert_quiet();
}

/// Labels of extremes that lie on a curve, on each other or beyond the frame, and how many extremes have no label.
const COVERED: &str = "(() => {
    const bad = [];
    let [marks, labels] = [0, 0];
    for (const plot of document.querySelectorAll('.plot')) {
        const frame = plot.querySelector('.frame').getBBox();
        const texts = [...plot.querySelectorAll('.extremes text')].map((own) => ({ text: own.textContent, box: own.getBBox() }));
        marks += plot.querySelectorAll('.extremes circle').length;
        labels += texts.length;
        // Ascent and descent have no ink of digits.
        const inner = ({ x, y, width, height }) => [x + 1, y + 3, x + width - 1, y + height - 3];
        const curves = [...plot.querySelectorAll('.curve')];
        const places = curves.flatMap((curve) => Array.from({ length: Math.ceil(curve.getTotalLength()) }, (_, at) => curve.getPointAtLength(at)));
        texts.forEach(({ text, box }, k) => {
            const [left, top, right, bottom] = inner(box);
            if (places.some(({ x, y }) => x > left && x < right && y > top && y < bottom)) bad.push(`${text} on a curve`);
            if (left < frame.x || right > frame.x + frame.width || top < frame.y || bottom > frame.y + frame.height) bad.push(`${text} beyond the frame`);
            for (const other of texts.slice(k + 1)) {
                const [a, b, c, d] = inner(other.box);
                if (left < c && a < right && top < d && b < bottom) bad.push(`${text} on ${other.text}`);
            }
        });
    }
    return { bad: bad.join('; '), marks, labels };
})()";

#[test]
fn labels_of_extremes_are_clear() {
    let reports = [
        ("four-bar", four_bar("Labels", FourBar::TURNING)),
        ("swinging", four_bar("Labels", FourBar::SWINGING)),
        ("sliders", sliders()),
        ("space", spatial()),
    ];
    let [mut marks, mut labels] = [0.0, 0.0];
    for (name, report) in reports {
        let Some(mut page) = Page::open(&written(&report, &format!("labels-{name}"))) else {
            return;
        };
        for screen in [DESKTOP, PHONE] {
            page.screen(screen);
            let found = page.value(COVERED);
            assert_eq!(found["bad"], "", "{name} on a {}", screen.name);
            marks += found["marks"].as_f64().expect("a number");
            labels += found["labels"].as_f64().expect("a number");
        }
        page.assert_quiet();
    }
    println!("{labels} labels of {marks} extremes");
    assert!(labels > 0.8 * marks, "{labels} labels of {marks} extremes");
}
