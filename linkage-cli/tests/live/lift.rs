//! The page of the scissor lift: its functions, its forces, and positions that no force holds.

use linkage_browser::{DESKTOP, PHONE, Page};

use crate::pages::Live;

const LIFT: &str = include_str!("../../src/templates/scissors.mech");
const SUSPENSION: &str = include_str!("../../src/templates/suspension.mech");

fn remarks(page: &mut Page) -> String {
    page.words("(() => { const own = document.getElementById('gaps'); return own.hidden ? '' : own.textContent; })()")
}

/// The arms are level there: loops close, and forces grow without bound.
#[test]
fn singular_positions_are_remarked() {
    let text = LIFT.replace("in 560mm..760mm", "in 469mm..760mm");
    let Some(mut live) = Live::text("lift_singular", &text) else {
        return;
    };
    assert_eq!(
        remarks(&mut live.page),
        "Forces grow without bound at singular positions, which the mechanism passes: centre.x at length = 470 mm."
    );
    // Arrows elsewhere are as long as they are without it.
    live.page.click("[data-vectors=force]");
    live.page.value("(() => { const own = document.getElementById('position'); own.value = 200; own.dispatchEvent(new Event('input')); return 0; })()");
    let length = live
        .page
        .number("document.querySelector('.force[data-arrow=centre] .line').getTotalLength()");
    assert!(length > 10.0, "{length} pixels");
    // With a foot that is nearer to the head the arms are level below the range.
    let mut dimensions = live.mechanism.dimensions();
    let names = live.mechanism.parameters().iter();
    let foot = names.map(|own| own.name).position(|name| name == "foot.x");
    let foot = foot.expect("the foot");
    for (x, place) in [(380.0, None), (345.0, Some("475 mm"))] {
        dimensions[foot] = x;
        live.set(&dimensions);
        let found = remarks(&mut live.page);
        match place {
            None => assert_eq!(found, ""),
            Some(place) => assert!(
                found.ends_with(&format!("centre.x at length = {place}.")),
                "{found}"
            ),
        }
    }
    live.page.assert_quiet();
}

#[test]
fn forces_that_stay_finite_are_not_remarked() {
    let Some(mut live) = Live::text("lift_above", LIFT) else {
        return;
    };
    assert_eq!(remarks(&mut live.page), "");
    live.page.assert_quiet();
}

/// One click shows all values of a function, the next one none.
#[test]
fn functions_have_switches() {
    let Some(mut live) = Live::text("lift_functions", LIFT) else {
        return;
    };
    let page = &mut live.page;
    let state = |page: &mut Page| {
        page.words("[...document.querySelectorAll('[data-function]')].map((own) => `${own.textContent} ${own.ariaPressed}`).join()")
    };
    let plotted = |page: &mut Page| {
        page.words("[...document.querySelectorAll('.curve:not(.kept)')].map((own) => own.dataset.column.split('|')[2]).sort().join()")
    };
    assert_eq!(state(page), "height true,force mixed");
    assert_eq!(plotted(page), "alpha,f,h,ratio");
    page.click("[data-function=force]");
    assert_eq!(state(page), "height true,force true");
    assert_eq!(
        plotted(page),
        "alpha,centre.x,centre.y,f,h,pivot.x,pivot.y,ratio,wheel.x,wheel.y"
    );
    assert!(page.holds("document.querySelector('[data-column=\"force||wheel.y|N\"]').checked"));
    page.click("[data-function=height]");
    assert_eq!(state(page), "height false,force true");
    page.click("[data-function=force]");
    assert_eq!(plotted(page), "");
    assert_eq!(
        page.words("document.querySelector('#quantities .count').textContent.split(' ')[0]"),
        "0"
    );
    page.assert_quiet();
}

/// Angles are in degrees where quantities are chosen, as they are in plots.
#[test]
fn quantities_have_the_units_of_plots() {
    let Some(mut live) = Live::text("lift_units", LIFT) else {
        return;
    };
    let unit = "document.querySelector('[data-column=\"height||alpha|rad\"]').parentNode.querySelector('small').textContent";
    assert_eq!(live.page.words(unit), " deg");
}

#[test]
fn force_arrows_have_names() {
    let Some(mut live) = Live::text("lift_forces", LIFT) else {
        return;
    };
    let page = &mut live.page;
    page.click("[data-vectors=force]");
    for screen in [DESKTOP, PHONE] {
        page.screen(screen);
        page.settle();
        let names = page.words("[...document.querySelectorAll('.force text')].filter((own) => own.getBBox().width > 0).map((own) => own.textContent).sort().join()");
        assert_eq!(names, "centre,pivot,wheel");
        let outside = page.words(
            "(() => { const frame = document.getElementById('drawing').getBoundingClientRect(); \
               return [...document.querySelectorAll('.force text')].filter((own) => { const box = own.getBoundingClientRect(); \
                 return box.left < frame.left || box.right > frame.right || box.top < frame.top || box.bottom > frame.bottom; }).map((own) => own.textContent).join(); })()",
        );
        assert_eq!(outside, "", "on a {}", screen.name);
        page.shoot(&format!("lift-forces-{}", screen.name));
    }
    page.assert_quiet();
}

/// Spring and damper are drawn, with a piston rod that is wide enough to be seen.
#[test]
fn the_strut_of_a_suspension_is_drawn() {
    let Some(mut live) = Live::text("strut", SUSPENSION) else {
        return;
    };
    let page = &mut live.page;
    for row in [0, 180, 360] {
        page.value(&format!("(() => {{ const own = document.getElementById('position'); own.value = {row}; own.dispatchEvent(new Event('input')); return 0; }})()"));
        let rod = page.value(
            "(() => { const own = document.querySelector('.cylinder'); \
               const numbers = (part) => own.querySelector(part).getAttribute('d').match(/-?[\\d.]+/g).map(Number); \
               const [a, b, c, d] = numbers('.body'); const barrel = numbers('.barrel'); \
               const mouth = [(barrel[2] + barrel[4]) / 2, (barrel[3] + barrel[5]) / 2]; \
               return [Math.hypot(c - mouth[0], d - mouth[1]) / Math.hypot(c - a, d - b), parseFloat(getComputedStyle(own.querySelector('.body')).strokeWidth)]; })()",
        );
        let [share, width] = [0, 1].map(|k| rod[k].as_f64().expect("a number"));
        assert!(share > 0.15, "{row}: {share} of the rod is outside");
        // Plates and bars are below it.
        assert!(page.holds("[...document.querySelectorAll('.link')].at(-1).matches('.cylinder')"));
        assert!(width >= 5.0, "{row}: {width} pixels");
    }
    page.assert_quiet();
}

/// Names of dimensions are not broken within their words, and the groups of the structure are whole.
#[test]
fn names_and_groups_are_whole_on_a_phone() {
    let Some(mut live) = Live::text("strut_phone", SUSPENSION) else {
        return;
    };
    let page = &mut live.page;
    for screen in [DESKTOP, PHONE] {
        page.screen(screen);
        page.value("document.querySelectorAll('details').forEach((own) => { own.open = true; })");
        page.settle();
        let broken = page.words(
            "[...document.querySelectorAll('.dimension .name')].filter((own) => [...own.childNodes].some((part) => { \
               const range = document.createRange(); range.selectNode(part); \
               return part.nodeType === Node.TEXT_NODE && range.getClientRects().length > 1; })).map((own) => own.textContent).join()",
        );
        assert_eq!(broken, "", "on a {}", screen.name);
    }
    let cut = page.words(
        "(() => { const box = document.querySelector('[data-table=groups]').parentNode.getBoundingClientRect(); \
           return [...document.querySelectorAll('[data-table=groups] td')].filter((own) => own.getBoundingClientRect().right > box.right + 1).map((own) => own.textContent).join('; '); })()",
    );
    assert_eq!(cut, "");
    assert_eq!(
        page.words("(() => { const own = document.querySelector('[data-table=groups] td:last-child'); return getComputedStyle(own, '::before').content; })()"),
        "\"method\""
    );
    page.value("document.querySelector('[data-table=groups]').scrollIntoView()");
    page.shoot("structure-phone");
    page.assert_quiet();
}

/// A label that is not beside its point has a line to it.
#[test]
fn labels_of_extremes_belong_to_their_points() {
    let four_bar = include_str!("../../src/templates/four-bar.mech");
    let Some(mut live) = Live::text("labels_phone", four_bar) else {
        return;
    };
    let page = &mut live.page;
    page.screen(PHONE);
    page.value("document.querySelectorAll('[data-function]:not([aria-pressed=true])').forEach((own) => own.click())");
    page.settle();
    let found = page.value(
        "(() => { const all = [...document.querySelectorAll('[data-extreme]')].filter((own) => own.querySelector('text')); \
           const away = (own) => { const [box, circle] = ['text', 'circle'].map((part) => own.querySelector(part).getBBox()); \
             const [x, y] = [circle.x + circle.width / 2, circle.y + circle.height / 2]; \
             return Math.hypot(Math.max(box.x - x, 0, x - box.x - box.width), Math.max(box.y - y, 0, y - box.y - box.height)); }; \
           const lines = all.filter((own) => own.querySelector('path')); \
           return [all.length, lines.length, Math.max(...all.filter((own) => !own.querySelector('path')).map(away))]; })()",
    );
    let [all, lines, farthest] = [0, 1, 2].map(|k| found[k].as_f64().expect("a number"));
    assert!(lines >= 1.0 && all > lines, "{all} labels, {lines} lines");
    assert!(farthest < 14.0, "{farthest} pixels without a line");
    page.assert_quiet();
}
