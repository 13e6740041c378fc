//! Pages of very many positions.

use crate::data::{json, numbers};
use crate::fixture::{PHI, Sweep, column, value};
use crate::once::series;
use crate::packed::page_data;
use linkage_report::Report;
use linkage_runtime::{Heading, Meaning};
use serde_json::Value;

const HEADING: Heading = Heading {
    function: "spiky",
    arguments: &["phi"],
    columns: &[
        value("p", "mm"),
        column(
            "v",
            "mm/rad",
            Meaning::Rate {
                order: 1,
                of: Some(0),
            },
        ),
        column(
            "a",
            "mm/rad^2",
            Meaning::Rate {
                order: 2,
                of: Some(0),
            },
        ),
    ],
    picture: None,
};

/// Peaks that are one row wide, and a gap.
fn spiky(count: usize) -> (Vec<f64>, Report) {
    let phi = PHI.positions(count);
    let row = |x: f64| (x / phi[1]).round() as usize;
    let sweep = Sweep::new(&HEADING, &phi, |x| match row(x) {
        12_346 => vec![9.0, 0.0, 0.0],
        23_458 => vec![-9.0, 0.0, 0.0],
        // Alone neither is an extreme, together they are at a speed.
        24_681 => vec![0.0, 0.49, 0.49],
        20_001..=20_004 => vec![f64::NAN; 3],
        _ => vec![x.sin(), 0.5 * x.cos(), -0.5 * x.sin()],
    });
    let report = Report::new("Spiky", &PHI, &phi)
        .table(&sweep)
        .speed(1.0, 1.0);
    (phi, report)
}

fn page(report: &Report) -> Value {
    page_data(&report.html().unwrap())
}

#[test]
fn pages_of_many_rows_keep_what_matters() {
    let (phi, report) = spiky(50_001);
    let page = page(&report);
    let there = numbers(&page["input"]["values"]);
    let count = there.len();
    assert!((19_000..=20_000).contains(&count), "{count}");
    assert_eq!(
        page["thinned"],
        serde_json::json!({ "rows": count, "of": 50_001 })
    );
    assert!(there.is_sorted());
    for row in [
        0, 50_000, 12_346, 23_458, 24_681, 20_000, 20_001, 20_004, 20_005,
    ] {
        assert!(there.contains(&phi[row]), "row {row} is missing");
    }
    // Nowhere far from one row to the next.
    let most = there
        .windows(2)
        .map(|pair| pair[1] - pair[0])
        .fold(0.0, f64::max);
    assert!(most < 4.0 * phi[1], "{}", most / phi[1]);
    // Files have all.
    let whole = json(&report);
    assert_eq!(numbers(&whole["input"]["values"]).len(), 50_001);
    assert_eq!(whole["thinned"], Value::Null);
    assert_eq!(report.csv("spiky").unwrap().lines().count(), 50_002);
    // Each row has its own numbers.
    let [all, some] = [&whole, &page].map(|json| {
        let of = |value: &Value| series(json, value);
        [
            of(&json["tables"][0]["columns"][0]["values"]),
            of(&json["true"][1]["values"]),
        ]
    });
    for (index, x) in there.iter().enumerate() {
        let row = phi.binary_search_by(|phi| phi.total_cmp(x)).unwrap();
        for (all, some) in all.iter().zip(&some) {
            assert_eq!(all[row].to_bits(), some[index].to_bits());
        }
    }
}

#[test]
fn pages_of_few_rows_have_all() {
    let (_, report) = spiky(20_000);
    assert_eq!(page(&report), json(&report));
}
