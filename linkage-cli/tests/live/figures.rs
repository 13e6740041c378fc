//! Figures of the cycle, and what is saved, after dimensions were changed. The pages are those of the gallery's example.

use std::fs;
use std::path::{Path, PathBuf};

use linkage_analysis::summary::Curve;
use linkage_browser::Page;
use linkage_engine::{Assembly, Mechanism};

use crate::pages;

/// The file of a page of the gallery. `None` without a gallery.
fn file_of(name: &str) -> Option<PathBuf> {
    let entries = linkage_browser::entries();
    if entries.is_empty() {
        return None;
    }
    let entry = entries.into_iter().find(|own| own.name == name);
    Some(
        entry
            .unwrap_or_else(|| panic!("the gallery has no {name}"))
            .page,
    )
}

/// Opens a page. `None` without a browser.
fn open(file: &Path) -> Option<Page> {
    let mut page = Page::open(file)?;
    page.value(pages::CATCH);
    Some(page)
}

fn gallery(name: &str) -> Option<Page> {
    open(&file_of(name)?)
}

/// The mechanism of an example.
fn example(name: &str) -> &'static Mechanism {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../mechanisms");
    pages::mechanism(&file.join(format!("{name}.rs")))
}

/// A row of the summary, which is no longer that of the report. The radians of an angle are below its degrees.
fn figure(page: &mut Page, quantity: &str, what: &str) -> f64 {
    page.number(&format!(
        "Number([...[...document.querySelectorAll('#summary tr')].find((row) => row.cells[0].textContent === '{quantity}' && row.cells[1].textContent === '{what}')\
         .querySelectorAll('[data-exact]')].pop().dataset.exact)"
    ))
}

/// The course of columns of a function: a quantity and its derivatives.
fn course<'a, const N: usize>(
    assembly: &'a Assembly<'a>,
    mechanism: &Mechanism,
    function: &str,
    names: [&str; N],
) -> Curve<N, impl Fn(f64) -> [f64; N] + use<'a, N>> {
    let functions = &mechanism.compiled().functions;
    let number = functions
        .iter()
        .position(|own| own.name == function)
        .expect("a function");
    let places = names.map(|name| {
        let mut columns = functions[number].columns.iter();
        columns
            .position(|own| own.name == name)
            .unwrap_or_else(|| panic!("no column {name}"))
    });
    let ends = mechanism.inputs()[0].ends();
    let at = move |x: f64| {
        let all = assembly.call(number, &[x]);
        places.map(|place| all[place])
    };
    Curve::new(ends, 720, at).expect("a course")
}

/// Sets dimensions by the address.
fn set(page: &mut Page, mechanism: &Mechanism, changes: &[(&str, f64)]) -> Vec<f64> {
    let parts: Vec<String> = changes
        .iter()
        .map(|(name, x)| format!("{name}={x}"))
        .collect();
    page.value(&format!("location.hash = '{}'", parts.join("&")));
    let (last, value) = changes[changes.len() - 1];
    page.wait(&format!(
        "document.querySelector('input[data-dimension=\"{last}\"]').value === '{value}'"
    ));
    let mut dimensions = mechanism.dimensions();
    for (name, x) in changes {
        let place = mechanism
            .parameters()
            .iter()
            .position(|own| own.name == *name);
        dimensions[place.expect("a dimension")] = *x;
    }
    dimensions
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * (1.0 + b.abs())
}

/// Time ratios are those that Rust finds with these dimensions.
#[test]
fn time_ratios_follow() {
    let mechanism = example("spatial_crank_rocker");
    let Some(mut page) = gallery("spatial_crank_rocker") else {
        return;
    };
    let names: Vec<&str> = mechanism.parameters().iter().map(|own| own.name).collect();
    for (index, part) in [(0, 1.03), (2, 0.97), (3, 1.02)] {
        let own = &mechanism.parameters()[index];
        assert!(own.nominal != 0.0 && own.unit != "rad", "{}", own.name);
        // As many digits as fields show.
        let changed = (own.nominal * part * 1e3).round() / 1e3;
        let dimensions = set(&mut page, mechanism, &[(own.name, changed)]);
        let assembly = mechanism.assemble(&dimensions).expect("it closes");
        let course = course(&assembly, mechanism, "motion", ["psi", "dpsi", "ddpsi"]);
        let times = course.time_ratio().expect("one stroke and its return");
        for (what, rust) in [
            ("rises in", times.rise),
            ("falls in", times.fall),
            ("time ratio", times.ratio()),
        ] {
            let js = figure(&mut page, "psi", what);
            assert!(
                near(js, rust),
                "{names:?} {index}, {what}: {js} on the page, {rust}"
            );
        }
    }
    page.assert_quiet();
}

/// Dwells are the longest ones within the band of the report.
#[test]
fn dwells_follow() {
    let mechanism = example("eye_needle");
    let Some(mut page) = gallery("eye_needle") else {
        return;
    };
    let band = figure(&mut page, "phi75", "dwell, band");
    for changes in [
        [("l34", 81.02), ("l12", 50.0)],
        [("l34", 81.0), ("l12", 50.05)],
        [("l34", 80.0), ("l12", 51.0)],
        [("l46", 105.0), ("l12", 49.0)],
    ] {
        let dimensions = set(&mut page, mechanism, &changes);
        let assembly = mechanism.assemble(&dimensions).expect("it closes");
        let course = course(&assembly, mechanism, "rocker", ["phi75", "v", "a"]);
        let dwell = course.longest_dwell(band).expect("a dwell");
        // Where an interval passes through the band its place is as good as roundoff lets a flat extreme be known.
        for (what, rust, tolerance) in [
            ("dwell, from", dwell.interval.from, 1e-6),
            ("dwell, to", dwell.interval.to, 1e-6),
            ("dwell, range", dwell.interval.range, 1e-9),
            ("dwell, band", dwell.highest - dwell.lowest, 1e-12),
            ("dwell, ripple", dwell.ripple, 1e-12),
        ] {
            let js = figure(&mut page, "phi75", what);
            assert!(
                (js - rust).abs() < tolerance,
                "{changes:?}, {what}: {js} on the page, {rust}"
            );
        }
    }
    page.assert_quiet();
}

/// Figures that a report was given have any names: what nothing computes stays as it is, also if its name begins as that of a dwell.
#[test]
fn figures_of_any_name_stay() {
    let Some(written) = file_of("eye_needle") else {
        return;
    };
    let html = fs::read_to_string(written).expect("a page");
    let row = |quantity: &str, what: &str| {
        format!(r#"{{"at":null,"quantity":"{quantity}","unit":"","value":7.25,"what":"{what}"}},"#)
    };
    let figures = [
        ("margin", "dwell, from"),
        ("margin", "dwell, mean"),
        ("phi75", "dwell, mean"),
    ];
    let rows = figures.map(|(quantity, what)| row(quantity, what));
    let list = "\"summary\":[";
    let own = html.replacen(list, &(list.to_owned() + &rows.concat()), 1);
    assert_ne!(own, html);
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("any_name.html");
    fs::write(&file, own).expect("a file");
    let Some(mut page) = open(&file) else {
        return;
    };
    let before = figure(&mut page, "phi75", "dwell, from");
    set(&mut page, example("eye_needle"), &[("l34", 80.5)]);
    for (quantity, what) in figures {
        let shown = figure(&mut page, quantity, &format!("{what} (as in the report)"));
        assert_eq!(shown, 7.25, "{quantity}, {what}");
    }
    assert_ne!(figure(&mut page, "phi75", "dwell, from"), before);
    page.assert_quiet();
}

/// What is saved of a changed page is of its mechanism, and says so; of another one it is the report.
#[test]
fn saved_data_are_those_of_the_page() {
    let mechanism = example("eye_needle");
    let Some(mut page) = gallery("eye_needle") else {
        return;
    };
    page.value("window.names = []; HTMLAnchorElement.prototype.click = function () { window.names.push(this.download); }; 0");
    let saved = pages::saved_file;
    let report = saved(&mut page, "data.json");
    set(&mut page, mechanism, &[("l34", 80.5)]);
    let changed = saved(&mut page, "data.json");
    let [report, changed]: [serde_json::Value; 2] =
        [report, changed].map(|text| serde_json::from_str(&text).expect("JSON"));
    assert_eq!(report.get("changed"), None);
    assert_eq!(
        changed["changed"],
        serde_json::json!({ "dimensions": { "l34": 80.5 }, "given": {} })
    );
    let keys = |own: &serde_json::Value| -> Vec<String> {
        let all = own.as_object().expect("an object").keys();
        all.filter(|key| *key != "changed").cloned().collect()
    };
    assert_eq!(keys(&changed), keys(&report));
    let named = |list: &serde_json::Value| {
        let all = list.as_array().expect("dimensions").clone();
        all.into_iter()
            .find(|own| own["name"] == "l34")
            .expect("it is one")
    };
    assert_eq!(named(&changed["dimensions"])["value"], 80.5);
    assert_eq!(named(&report["dimensions"])["value"], 81.0);
    let csv = saved(&mut page, "rocker.csv");
    let second = csv.lines().nth(3).expect("rows").split(',').nth(1);
    let second: f64 = second.expect("a value").parse().expect("a number");
    let tables = changed["tables"].as_array().expect("tables");
    let rocker = tables.iter().find(|own| own["function"] == "rocker");
    assert_eq!(
        rocker.expect("it is there")["columns"][0]["values"][1],
        second
    );
    let summary = changed["summary"].as_array().expect("figures");
    assert!(summary.iter().any(|row| row["what"] == "dwell, from"));
    assert_eq!(
        page.words("window.names.join()"),
        "data.json,data_changed.json,rocker_changed.csv"
    );
    page.assert_quiet();
}

/// Figures of the cycle are those of the changed mechanism: a slider-crank's stroke is twice its crank.
#[test]
fn figures_of_the_cycle_follow() {
    let Some(mut page) = gallery("beyond_reach") else {
        return;
    };
    page.value("location.hash = 'crank=20'");
    page.wait("document.querySelector('#summary').textContent.includes('stroke')");
    let row = |page: &mut Page, what: &str| {
        page.number(&format!(
            "Number([...document.querySelectorAll('#summary tr')].find((row) => row.cells[1].textContent === '{what}').querySelector('[data-exact]').dataset.exact)"
        ))
    };
    let [low, high, stroke] = ["lowest", "highest", "stroke"].map(|what| row(&mut page, what));
    assert_eq!(stroke, high - low);
    // Rows are half a degree apart: the height beside an extreme falls by no more than this between two of them.
    let csv = pages::saved_file(&mut page, "motion.csv");
    let heights = csv.lines().skip(2).map(|line| {
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
