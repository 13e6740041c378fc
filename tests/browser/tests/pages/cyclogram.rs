//! Cyclograms on pages that compute: they follow changed dimensions.

use linkage_analysis::cyclogram::Cyclogram;
use linkage_browser::samples::{written, yokes, yokes_cyclogram};
use linkage_browser::{DESKTOP, Page};
use serde_json::Value;

/// Roundoffs of a quantity over its slope at a bound, in radians.
const ROUNDING: f64 = 1e-13;

/// Changes dimensions as the address does, and gives what the page then saves as its data.
fn changed(page: &mut Page, address: &str) -> Value {
    let text = page.words(&format!(
        "(async () => {{ await new Promise((done) => {{ addEventListener('hashchange', () => setTimeout(done), {{ once: true }}); location.hash = '{address}'; }}); \
         const saved = []; URL.createObjectURL = (blob) => {{ saved.push(blob); return 'data:,'; }}; document.querySelector('button[data-file=\"data.json\"]').click(); \
         while (saved.length === 0) await new Promise((done) => setTimeout(done, 5)); return saved[0].text(); }})()"
    ));
    let data: Value = serde_json::from_str(&text).expect("JSON");
    data["cyclogram"].clone()
}

/// The same motions between the same angles as Rust finds with these dimensions, organ by organ.
fn assert_same(found: &Value, expected: &Cyclogram, organs: &[usize]) {
    let expected: Value = serde_json::from_str(&expected.json()).expect("JSON");
    for &organ in organs {
        let [found, expected] = [found, &expected].map(|own| &own["organs"][organ]);
        for (kind, words, numbers) in [
            ("events", ["ends", "begins"], ["at", "value"]),
            ("intervals", ["motion", "band"], ["from", "range"]),
        ] {
            let [found, expected] = [found, expected].map(|own| own[kind].as_array().expect(kind));
            assert_eq!(found.len(), expected.len(), "{found:?}");
            for (found, expected) in found.iter().zip(expected) {
                assert_eq!(words.map(|w| &found[w]), words.map(|w| &expected[w]));
                for name in numbers {
                    let [x, y] = [found, expected].map(|own| own[name].as_f64().expect(name));
                    let scale = if name == "value" { 200.0 } else { 1.0 };
                    assert!(
                        (x - y).abs() < scale * ROUNDING,
                        "{name}: {x} instead of {y}"
                    );
                }
            }
        }
    }
}

/// The same overlaps as Rust finds with these dimensions, those of organs that are not followed left out.
fn assert_overlaps(found: &Value, expected: &Cyclogram, followed: &[usize]) {
    let expected: Value = serde_json::from_str(&expected.json()).expect("JSON");
    let own = |all: &Value| {
        let all = all["overlaps"].as_array().expect("overlaps").clone();
        let is_followed = |own: &Value| {
            let organ = |k: usize| own["organs"][k].as_u64().expect("an organ") as usize;
            [0, 1].iter().all(|&k| followed.contains(&organ(k)))
        };
        all.into_iter().filter(is_followed).collect::<Vec<_>>()
    };
    let (found, expected) = (own(found), own(&expected));
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (found, expected) in found.iter().zip(&expected) {
        for word in ["organs", "motions", "bands"] {
            assert_eq!(found[word], expected[word]);
        }
        for name in ["from", "to", "range"] {
            let [x, y] = [found, expected].map(|own| own[name].as_f64().expect(name));
            assert!((x - y).abs() < 2.0 * ROUNDING, "{name}: {x} instead of {y}");
        }
    }
}

fn told(page: &mut Page) -> String {
    page.words("document.querySelector('#cyclogram p').textContent")
}

#[test]
fn cyclograms_follow_changed_dimensions() {
    let Some(mut page) = Page::open(&written(&yokes(false), "yokes")) else {
        return;
    };
    page.screen(DESKTOP);
    let bars = "[...document.querySelectorAll('#cyclogram [data-organ=\"hook\"] .dwell')].map((b) => b.getAttribute('width')).join(' ')";
    let rows = "[...document.querySelectorAll('[data-table=cyclogram] tbody tr')].map((r) => [...r.cells].map((c) => c.textContent).join(' ')).join('; ')";
    let both = rows.replace("=cyclogram", "=overlaps");
    let (first_bars, first_rows) = (page.words(bars), page.words(rows));
    let first_both = page.words(&both);
    assert_eq!(told(&mut page), "");
    for [crank, rod, lead] in [
        [40.0, 130.0, 0.7 + 1e-9],
        [36.5, 130.0, 0.7],
        [40.0, 124.25, -2.5],
        [47.0, 141.0, 6.0],
    ] {
        let found = changed(&mut page, &format!("crank={crank}&rod={rod}&lead={lead}"));
        let expected = yokes_cyclogram([crank, rod, lead]);
        assert_same(&found, &expected, &[0, 1]);
        assert_overlaps(&found, &expected, &[0, 1]);
        // All events of all organs, in order, once round.
        let order = found["order"].as_array().expect("an order");
        let moments: Vec<f64> = order
            .iter()
            .filter_map(|own| own["after"].as_f64())
            .collect();
        assert_eq!(moments.len(), expected.moments().len());
        for (after, moment) in moments.iter().zip(expected.moments()) {
            assert!((after - moment.after).abs() < 2.0 * ROUNDING);
        }
        for (k, moment) in order.iter().enumerate() {
            let before = &order[(k + order.len() - 1) % order.len()];
            for word in ["organ", "event"] {
                assert_eq!(moment["follows"][word], before[word]);
            }
        }
        assert_eq!(
            told(&mut page),
            "sinker is as in the report: no table that is computed here has its quantity and the derivative of that."
        );
    }
    for (dark, colours) in [(false, "light"), (true, "dark")] {
        page.dark(dark);
        page.shoot(&format!("yokes-{colours}"));
        page.value("document.querySelector('#overlaps').scrollIntoView({ block: 'center', behavior: 'instant' })");
        page.shoot(&format!("yokes-overlaps-{colours}"));
        page.value("scrollTo(0, 0)");
    }
    assert_ne!(page.words(bars), first_bars);
    let changed = page.words(&both);
    assert!(
        changed != first_both && changed.contains("sinker (as in the report)"),
        "{changed}"
    );
    let now = page.words(rows);
    assert!(
        now != first_rows && now.contains("sinker (as in the report)"),
        "{now}"
    );
    page.click("#reset");
    assert_eq!(
        (page.words(bars), page.words(rows)),
        (first_bars, first_rows)
    );
    assert_eq!(page.words(&both), first_both);
    assert_eq!(told(&mut page), "");
    page.assert_quiet();
}

/// Bands that do not fit the motion any more are told with the numbers, and the rest of the machine is as it is.
#[test]
fn an_organ_without_a_cycle_says_why() {
    let Some(mut page) = Page::open(&written(&yokes(true), "yokes-mistakes")) else {
        return;
    };
    // The rod of 200 mm lifts the press beyond its band.
    let found = changed(&mut page, "rod=200");
    assert_eq!(
        found["organs"][1]["events"].as_array().map(Vec::len),
        Some(0)
    );
    let said = told(&mut page);
    assert!(
        said.contains(
            "press: nothing reaches the band -140 to -120: the motion is from -240 to -160."
        ),
        "{said}"
    );
    let found = changed(&mut page, "crank=3");
    assert!(
        told(&mut page)
            .contains("hook: the bands top 3 and bottom 4 overlap: the motion is from 127 to 133.")
    );
    assert_eq!(
        found["organs"][0]["intervals"].as_array().map(Vec::len),
        Some(0)
    );
    // The hook and its twin are one only as long as `more` is nothing.
    let found = changed(&mut page, "crank=41");
    assert_same(&found, &yokes_cyclogram([41.0, 130.0, 0.7]), &[0, 1]);
    let found = changed(&mut page, "crank=41&more=0.01");
    assert_same(&found, &yokes_cyclogram([40.0, 130.0, 0.7]), &[0]);
    assert!(told(&mut page).contains("hook is as in the report: several quantities are the same in the report, and are no longer."));
    page.assert_quiet();
}
