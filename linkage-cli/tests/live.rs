//! Pages that compute: what they show for other dimensions is what the command computes for these.

#[path = "live/pages.rs"]
mod pages;

use linkage_browser::Key;
use linkage_random::Random;
use pages::Live;

/// How often dimensions are changed at random, for each mechanism; `LIVE_COUNT=2000` in the environment changes them more often.
const COUNT: usize = 6;

fn changes() -> usize {
    let wanted = std::env::var("LIVE_COUNT").ok();
    wanted.and_then(|text| text.parse().ok()).unwrap_or(COUNT)
}

#[test]
fn pages_show_what_the_command_computes() {
    let examples = [
        "favorit.rs",
        "eye_needle.rs",
        "spatial_crank_rocker.rs",
        "quick_return.rs",
        "geared_five_bar.rs",
    ];
    let mut random = Random::new(20);
    for example in examples {
        let Some(mut live) = Live::example(example) else {
            return;
        };
        let (mut reached, mut gaps) = (0, 0);
        for _ in 0..changes() {
            let part = *random.pick(&[0.002, 0.02, 0.1]);
            let own = live.mechanism.dimensions().into_iter();
            let dimensions: Vec<f64> = own
                .map(|x| x * (1.0 + random.between(-part, part)))
                .collect();
            live.set(&dimensions);
            match live.mechanism.assemble(&dimensions) {
                Ok(assembly) => {
                    let said = live.says();
                    assert!(!said.contains("no farther"), "{example}: {said}");
                    gaps += pages::compare(&mut live, &assembly, &[]);
                    reached += 1;
                }
                Err(error) => {
                    // What closes at the reference and ends within the range has rows up to there.
                    let said = live.says();
                    let ends = live.page.holds("!document.getElementById('gaps').hidden");
                    assert!(
                        said.starts_with("That far and no farther.") || ends,
                        "{example}: {said}, {error}"
                    );
                }
            }
        }
        println!(
            "{example}: {reached} of {} changes close, {gaps} positions without values",
            changes()
        );
        assert!(reached > changes() / 2);
        live.page.assert_quiet();
    }
}

#[test]
fn changes_are_shown_at_once() {
    // The limits of a quiet machine; here others may be at work, too.
    const PATIENCE: f64 = 6.0;
    for (mechanism, limit) in [("crank_rocker", 4.0), ("favorit", 16.0)] {
        let found = match mechanism {
            "favorit" => Live::example("favorit.rs"),
            _ => Live::golden("crank_rocker.mech"),
        };
        let Some(mut live) = found else {
            return;
        };
        let mut times = Vec::new();
        for step in 0..40 {
            let mut dimensions = live.mechanism.dimensions();
            for x in &mut dimensions {
                *x *= 1.0 + 1e-5 * f64::from(step + 1);
            }
            live.set(&dimensions);
            times.push(["computed", "shown"].map(|word| {
                live.page
                    .number(&format!("Number(document.body.dataset.{word})"))
            }));
        }
        let median = |k: usize| {
            let mut all: Vec<f64> = times.iter().map(|own| own[k]).collect();
            all.sort_by(f64::total_cmp);
            all[all.len() / 2]
        };
        println!(
            "{mechanism}: {:.2} ms computing, {:.2} ms showing",
            median(0),
            median(1)
        );
        assert!(median(0) + median(1) < PATIENCE * limit);
    }
}

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
    assert_eq!(live.page.words("location.hash"), "");
    live.page.value("document.getElementById('redo').click()");
    assert!(live.csv("motion") == changed);
    live.page.value("document.getElementById('reset').click()");
    assert!(live.csv("motion") == before);
    assert!(live.page.holds("document.getElementById('reset').disabled"));
    live.page.assert_quiet();
}

/// What lies out of reach stops at the last dimensions that close.
#[test]
fn what_cannot_be_assembled_is_as_near_as_possible() {
    let Some(mut live) = Live::golden("crank_rocker.mech") else {
        return;
    };
    live.page.value("location.hash = 'rocker=10'");
    live.page
        .wait("document.getElementById('says').textContent !== ''");
    let said = live.says();
    assert!(said.starts_with("That far and no farther. CrankRocker: the RRR group of theta, psi (loop 1) cannot be closed: "), "{said}");
    // There the triangle is flat.
    let mut dimensions = live.mechanism.dimensions();
    let place = live
        .mechanism
        .parameters
        .iter()
        .position(|own| own.name == "rocker")
        .expect("it has one");
    let shown = live
        .page
        .number("Number(document.querySelector('input[data-dimension=rocker]').value)");
    dimensions[place] = shown;
    assert!(live.mechanism.assemble(&dimensions).is_ok());
    dimensions[place] = shown - 1e-4;
    assert!(live.mechanism.assemble(&dimensions).is_err(), "{shown}");
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
    live.page.value("location.reload()");
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

/// Another input has its own slider.
#[test]
fn other_inputs_are_changed_too() {
    let Some(mut live) = Live::golden("shaper.mech") else {
        return;
    };
    let unit = &live.mechanism.unit;
    let second = &unit.inputs[1];
    let moved = second.reference + 0.01 * unit.longest;
    let name = second.name.as_str();
    live.page.value(&format!(
        "(() => {{ const slider = document.querySelector('input[data-slides={name}]'); slider.value = {moved:?}; for (const kind of ['input', 'change']) \
         slider.dispatchEvent(new Event(kind)); }})()"
    ));
    live.page
        .wait(&format!("location.hash.startsWith('#{name}=')"));
    let shown: f64 = live
        .page
        .words("location.hash.split('=')[1]")
        .parse()
        .expect("a number");
    assert!(
        (shown - moved).abs() < 1e-3 * unit.longest,
        "{shown}, {moved}"
    );
    let assembly = live
        .mechanism
        .assemble(&live.mechanism.dimensions())
        .expect("it closes");
    let gaps = pages::compare(&mut live, &assembly, &[(name, shown)]);
    println!("{gaps} positions without values");
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
            .parameters
            .iter()
            .any(|own| own.name == format!("{name}.x"))
    });
    let pivot = pivot.expect("a pivot that is a dimension").to_owned();
    // At the first row the rocker's end lies over its pivot in one of the views.
    live.page.value("(() => { const slider = document.getElementById('position'); slider.value = 150; slider.dispatchEvent(new Event('input')); })()");
    let part = 0.02 * live.mechanism.unit.longest;
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
                .parameters
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

/// Figures of the cycle are those of the changed mechanism: a slider-crank's stroke is twice its crank.
#[test]
fn figures_of_the_cycle_follow() {
    // The gallery's reports have figures; it is written by the example.
    let Some(entry) = linkage_browser::entries()
        .into_iter()
        .find(|own| own.name == "beyond_reach")
    else {
        return;
    };
    let Some(mut page) = linkage_browser::Page::open(&entry.page) else {
        return;
    };
    page.value(pages::CATCH);
    page.value("location.hash = 'crank=20'");
    page.wait("document.querySelector('#summary').textContent.includes('stroke')");
    let row = |page: &mut linkage_browser::Page, what: &str| {
        page.number(&format!(
            "Number([...document.querySelectorAll('#summary tr')].find((row) => row.cells[1].textContent === '{what}').querySelector('[data-exact]').dataset.exact)"
        ))
    };
    let [low, high, stroke] = ["lowest", "highest", "stroke"].map(|what| row(&mut page, what));
    assert_eq!(stroke, high - low);
    // Rows are half a degree apart: the height beside an extreme falls by no more than this between two of them.
    let csv = page.words(&format!(
        "(async () => {{ {} }})()",
        pages::SAVED.replace("NAME", "motion")
    ));
    let heights = csv.lines().skip(1).map(|line| {
        line.split(',')
            .nth(2)
            .and_then(|word| word.parse().ok())
            .expect("a height")
    });
    let heights: Vec<f64> = heights.collect();
    let [lowest, highest] =
        [f64::min, f64::max].map(|pick| heights.iter().copied().reduce(pick).expect("rows"));
    assert!(
        high >= highest && high - highest < 1e-3,
        "{high}, {highest}"
    );
    assert!(low <= lowest && lowest - low < 1e-3, "{low}, {lowest}");
    assert!(stroke > 20.0, "{stroke}");
    assert!(page.holds("document.getElementById('gaps').hidden"));
    page.assert_quiet();
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
    let file = pages::beside("rssr", "broken.html", &broken);
    live.page.load(&file);
    live.page.wait("!document.getElementById('old').hidden");
}
