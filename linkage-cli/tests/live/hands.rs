//! What is done to dimensions: typed, pulled, undone, linked to.

use std::thread;
use std::time::Duration;

use linkage_browser::{Key, PHONE};

use crate::pages::{self, Live};

#[test]
fn fields_buttons_and_keys_change_and_bring_back() {
    let Some(mut live) = Live::golden("crank_rocker.mech") else {
        return;
    };
    let before = live.csv("motion");
    let crank = "input[data-dimension=crank]";
    let page = &mut live.page;
    page.value(&format!("(() => {{ const field = document.querySelector('{crank}'); field.focus(); field.select(); }})()"));
    page.type_text("45");
    page.key(Key::Enter);
    page.wait("location.hash === '#crank=45'");
    let changed = live.csv("motion");
    assert!(changed != before);
    live.page.value("document.getElementById('undo').click()");
    assert!(live.csv("motion") == before);
    live.page.wait("location.hash === ''");
    live.page.value("document.getElementById('redo').click()");
    assert!(live.csv("motion") == changed);
    live.page.value("document.getElementById('reset').click()");
    assert!(live.csv("motion") == before);
    assert!(live.page.holds("document.getElementById('reset').disabled"));
    live.page.assert_quiet();
}

const DRAWN: &str = "
    pub struct CrankRocker {
        unit mm;
        const pivot_a = (0mm, 0mm);
        param pivot_d = (140mm, 0mm);
        param crank   = 50mm;
        param coupler = 120mm;
        param rocker  = 100mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi   = 80deg;
        let a = pivot_a + polar(crank, phi);
        let b = a + polar(coupler, theta);
        loop b = pivot_d + polar(rocker, psi);
    }
    impl CrankRocker {
        pub fn motion(phi) -> Motion { psi, v: velocity(psi) }
        pub fn shape(phi) -> Shape { shape: picture() }
    }";

/// A pivot is pulled with the mouse; its dimensions follow, and everything else.
#[test]
fn pivots_and_bars_are_pulled() {
    let Some(mut live) = Live::text("pulled", DRAWN) else {
        return;
    };
    let scale = live
        .page
        .number("Number(document.getElementById('drawing').dataset.scale)");
    let place = |live: &mut Live, selector: &str| live.page.middle(selector);
    let (x, y) = place(&mut live, ".point.ground[data-point=pivot_d] .target");
    live.page.drag((x, y), (x + 20.0 * scale, y - 10.0 * scale));
    live.page.wait("location.hash.includes('pivot_d')");
    let mut value = |name: &str| {
        live.page.number(&format!(
            "Number(document.querySelector('input[data-dimension=\"{name}\"]').value)"
        ))
    };
    let (before_x, before_y) = (140.0, 0.0);
    assert!(
        (value("pivot_d.x") - before_x - 20.0).abs() < 1.0,
        "{}",
        value("pivot_d.x")
    );
    assert!(
        (value("pivot_d.y") - before_y - 10.0).abs() < 1.0,
        "{}",
        value("pivot_d.y")
    );
    live.page.value("document.getElementById('undo').click()");
    let (x, y) = place(&mut live, ".link.bar[data-link=crank]");
    let (a, _) = place(&mut live, ".point.ground[data-point=pivot_a] .target");
    let side = if x > a { 1.0 } else { -1.0 };
    live.page
        .drag((x + side * 5.0, y), (x + side * (5.0 + 4.0 * scale), y));
    live.page.wait("location.hash.startsWith('#crank=')");
    live.page.assert_quiet();
}

/// What is pulled has no more digits than a pixel tells, and all of them with shift.
#[test]
fn pulled_values_have_the_digits_of_pixels() {
    let Some(mut live) = Live::text("pulled_digits", DRAWN) else {
        return;
    };
    let scale = live
        .page
        .number("Number(document.getElementById('drawing').dataset.scale)");
    let step = 10_f64.powf((1.0 / scale).log10().floor());
    assert!(step < 1.0, "{step}");
    let is_whole = |value: f64| ((value / step).round() * step - value).abs() < 1e-9;
    let value = |live: &mut Live, name: &str| {
        live.page.number(&format!(
            "Number(document.querySelector('input[data-dimension=\"{name}\"]').value)"
        ))
    };
    let (x, y) = live
        .page
        .middle(".point.ground[data-point=pivot_d] .target");
    live.page.drag((x, y), (x + 17.0, y - 7.0));
    live.page.wait("location.hash.includes('pivot_d')");
    for (name, before, by) in [("pivot_d.x", 140.0, 17.0), ("pivot_d.y", 0.0, 7.0)] {
        let shown = value(&mut live, name);
        assert!(is_whole(shown), "{name} = {shown}");
        assert!(
            (shown - before - by / scale).abs() <= step,
            "{name} = {shown}"
        );
    }
    live.page.value("document.getElementById('reset').click()");
    let (x, y) = live
        .page
        .middle(".point.ground[data-point=pivot_d] .target");
    live.page.shift_drag((x, y), (x + 17.0, y - 7.0));
    live.page.wait("location.hash.includes('pivot_d')");
    let shown = value(&mut live, "pivot_d.x");
    assert!(
        !is_whole(shown) && (shown - 140.0 - 17.0 / scale).abs() < 1e-9,
        "{shown}"
    );
    // So has a slider, up to where the mechanism ends.
    live.page.value("document.getElementById('reset').click()");
    let slider = "input[data-slides=rocker]";
    let (x, y) = live.page.middle(slider);
    live.page.drag((x, y), (x + 13.0, y));
    live.page.wait("location.hash.startsWith('#rocker=')");
    let shown = value(&mut live, "rocker");
    assert!(
        shown > 100.5 && ((shown * 10.0).round() / 10.0 - shown).abs() < 1e-9,
        "{shown}"
    );
    live.page.value(&format!(
        "(() => {{ const slider = document.querySelector('{slider}'); slider.min = 5; slider.value = 10; for (const kind of ['input', 'change']) slider.dispatchEvent(new Event(kind)); }})()"
    ));
    live.page
        .wait("document.getElementById('says').textContent.startsWith('That far')");
    let shown = value(&mut live, "rocker");
    assert!(
        ((shown * 10.0).round() / 10.0 - shown).abs() < 1e-9,
        "{shown}"
    );
    let mut dimensions = live.mechanism.dimensions();
    let mut all = live.mechanism.parameters().iter();
    let place = all.position(|own| own.name == "rocker").expect("a rocker");
    dimensions[place] = shown;
    assert!(live.mechanism.assemble(&dimensions).is_ok(), "{shown}");
    dimensions[place] = shown - 1.0;
    assert!(live.mechanism.assemble(&dimensions).is_err(), "{shown}");
    live.page.assert_quiet();
}

/// On a phone the sliders of dimensions have a row each.
#[test]
fn sliders_have_a_row_on_a_phone() {
    let Some(mut live) = Live::golden_as("crank_rocker.mech", "phone") else {
        return;
    };
    let page = &mut live.page;
    page.screen(PHONE);
    page.value("document.getElementById('live').open = true");
    page.middle("input[data-slides=crank]");
    let [_, top, width, _] = page.place("input[data-slides=crank]");
    assert!(width > 300.0, "{width}");
    let [_, field, wide, tall] = page.place("input[data-dimension=crank]");
    assert!(
        field + tall <= top + 1.0 && wide > 100.0,
        "{field}, {tall}, {top}, {wide}"
    );
    page.shoot("phone-sliders");
    let wide = page.number("document.documentElement.scrollWidth");
    assert!(wide <= f64::from(PHONE.width), "{wide} pixels");
    page.assert_quiet();
}

/// The copied address opened anew shows the same design, and modes are part of it.
#[test]
fn the_address_is_the_design() {
    let Some(mut live) = Live::golden("crank_rocker.mech") else {
        return;
    };
    live.page
        .value("location.hash = 'crank=43.25&pivot_d.y=7&assembly%20modes=1'");
    live.page
        .wait("document.querySelector('input[data-dimension=crank]').value === '43.25'");
    let shown = live.csv("motion");
    // What is waited for is not the page that goes, which cannot be asked while it does.
    live.page
        .value("delete document.body.dataset.ready; setTimeout(() => location.reload()); 0");
    thread::sleep(Duration::from_secs(1));
    live.page.wait("document.body.dataset.ready === 'true'");
    live.page.value(pages::CATCH);
    assert!(live.csv("motion") == shown);
    live.page
        .value("location.hash = 'crank=43.25&size=3&crank=much'");
    live.page
        .wait("document.getElementById('says').textContent.startsWith('The address')");
    assert_eq!(
        live.says(),
        "The address says what this mechanism does not have: size=3, crank=much"
    );
    live.page.assert_quiet();
}

/// In a view of space a pivot is pulled in the plane that is seen.
#[test]
fn pivots_in_space_are_pulled_in_each_view() {
    let Some(mut live) = Live::golden("rssr.mech") else {
        return;
    };
    let pivots = live.page.words(
        "[...document.querySelectorAll('.point.ground')].map((own) => own.dataset.point).join()",
    );
    let pivot = pivots.split(',').find(|name| {
        live.mechanism
            .parameters()
            .iter()
            .any(|own| own.name == format!("{name}.x"))
    });
    let pivot = pivot.expect("a pivot that is a dimension").to_owned();
    // At the first row the rocker's end lies over its pivot in one of the views.
    live.page.value("(() => { const slider = document.getElementById('position'); slider.value = 150; slider.dispatchEvent(new Event('input')); })()");
    let part = 0.02 * live.mechanism.compiled().longest;
    for (view, axes) in [
        ("x-y", ["x", "y"]),
        ("x-z", ["x", "z"]),
        ("y-z", ["y", "z"]),
    ] {
        live.page.value("document.getElementById('reset').click()");
        live.page.click(&format!("[data-view={view}]"));
        let scale = live
            .page
            .number("Number(document.getElementById('drawing').dataset.scale)");
        let (x, y) = live
            .page
            .middle(&format!(".point.ground[data-point={pivot}] .target"));
        live.page
            .drag((x, y), (x + 4.0 * part * scale, y - 3.0 * part * scale));
        live.page.wait("location.hash !== ''");
        let mut change = |axis: &str| {
            let name = format!("{pivot}.{axis}");
            let own = live
                .mechanism
                .parameters()
                .iter()
                .find(|own| own.name == name)
                .expect("a component");
            live.page.number(&format!(
                "Number(document.querySelector('input[data-dimension=\"{name}\"]').value)"
            )) - own.nominal
        };
        let [right, up] = axes.map(&mut change);
        assert!(
            (right / part - 4.0).abs() < 0.5 && (up / part - 3.0).abs() < 0.5,
            "{view}: {right}, {up}, {part}: {}",
            live.says()
        );
    }
    live.page.assert_quiet();
}

/// A browser that cannot read the script says a sentence; nothing is asked of the network.
#[test]
fn old_browsers_and_networks() {
    let Some(mut live) = Live::golden("rssr.mech") else {
        return;
    };
    let refused = live.page.words(
        "new Promise((done) => { document.addEventListener('securitypolicyviolation', (event) => done(event.effectiveDirective)); fetch('http://localhost:9/').catch(() => {}); })",
    );
    assert_eq!(refused, "connect-src");
    let html = pages::html("rssr");
    let broken = html.replacen("\"use strict\";", "\"use strict\"; let let = 1;", 1);
    assert_ne!(html, broken);
    let file = pages::beside("rssr", "live", "broken.html", &broken);
    live.page.load(&file);
    live.page.wait("!document.getElementById('old').hidden");
}

/// With a speed that is typed the time is the abscissa, and derivatives are those with respect to time.
#[test]
fn a_speed_makes_time() {
    let Some(mut live) = Live::golden_as("crank_rocker.mech", "time") else {
        return;
    };
    let page = &mut live.page;
    let shown =
        "document.querySelector('.legend tr[data-column^=\"motion||v.x\"] .value').innerText";
    let before = page.words(shown);
    let number = |text: &str, unit: &str| -> f64 {
        let (number, found) = text.split_once(' ').expect("a unit");
        assert_eq!(found, unit);
        number.parse().expect("a number")
    };
    assert!(page.holds("document.getElementById('timed').hidden"));
    page.value("(() => { const own = document.getElementById('abscissa'); own.value = 'time'; own.dispatchEvent(new Event('change')); })()");
    let turning = |page: &mut linkage_browser::Page, text: &str| {
        page.value(&format!("(() => {{ const own = document.getElementById('turning'); own.value = '{text}'; own.dispatchEvent(new Event('change')); }})()"));
    };
    turning(page, "1500,5");
    let speed = 1500.5 * std::f64::consts::PI / 30.0;
    let after = page.words(shown);
    let ratio = number(&after, "mm/s") / number(&before, "mm/rad");
    assert!((ratio / speed - 1.0).abs() < 1e-4, "{before}, {after}");
    let units = page
        .words("[...document.querySelectorAll('.panel')].map((own) => own.dataset.unit).join(' ')");
    assert!(
        units.contains("mm/s mm/s^2") && !units.contains("rad^2"),
        "{units}"
    );
    turning(page, "fast");
    assert!(
        page.holds("document.getElementById('turning').getAttribute('aria-invalid') === 'true'")
    );
    assert_eq!(page.words(shown), after);
    // Curves follow other dimensions.
    page.value("location.hash = 'arm=35'");
    page.wait(&format!("{shown} !== '{after}'"));
    page.value("(() => { const own = document.getElementById('abscissa'); own.value = ''; own.dispatchEvent(new Event('change')); })()");
    number(&page.words(shown), "mm/rad");
    page.assert_quiet();
}

/// A design that is kept is dotted in plots and drawing, beside the one that is changed.
#[test]
fn a_design_is_kept_for_comparison() {
    let Some(mut live) = Live::text("kept", DRAWN) else {
        return;
    };
    let page = &mut live.page;
    let paths = |page: &mut linkage_browser::Page, selector: &str| {
        page.words(&format!("[...document.querySelectorAll('{selector}')].map((own) => own.getAttribute('d')).join('|')"))
    };
    let value =
        "document.querySelector('.legend tr[data-column^=\"motion||psi\"] .value').innerText";
    page.value("location.hash = 'crank=45'");
    page.wait("document.getElementById('changes').textContent !== ''");
    let before = page.words(value);
    page.value("document.getElementById('keep').click()");
    let kept = paths(page, ".curve.kept");
    assert!(kept.len() > 2000);
    assert_eq!(
        kept,
        paths(page, ".curve:not(.kept)"),
        "nothing differs yet"
    );
    let ghost = paths(page, ".ghost path");
    page.value("location.hash = 'crank=45&rocker=110'");
    page.wait("document.getElementById('changes').textContent.includes('rocker')");
    assert_ne!(paths(page, ".curve.kept"), paths(page, ".curve:not(.kept)"));
    assert_eq!(
        paths(page, ".ghost path"),
        ghost,
        "the drawing keeps it, too"
    );
    let after = page.words(value);
    assert!(
        after.ends_with(&format!("dotted {before}")),
        "{before}, {after}"
    );
    assert_eq!(
        page.words("document.getElementById('kept').textContent"),
        "Dotted: crank = 45 mm (50)"
    );
    let svg = live.file("plots.svg");
    assert!(
        svg.contains("(50), rocker = 110 mm (100); Dotted: crank = 45 mm (50)"),
        "the saved plots name both"
    );
    assert!(!live.file("motion.csv").contains("Dotted"));
    let page = &mut live.page;
    page.shoot("kept");
    page.value("document.getElementById('keep').click()");
    assert!(page.holds("document.querySelector('.kept, #kept') === null"));
    assert_ne!(
        paths(page, ".ghost path"),
        ghost,
        "that of the report again"
    );
    page.assert_quiet();
}
