//! Bands and the table of accuracy.

use crate::fixture::{FourBar, PHI};
use crate::four_bar;
use linkage_report::Report;
use linkage_runtime::Table;
use serde_json::Value;

fn json(report: &Report) -> Value {
    serde_json::from_str(&report.json().unwrap()).unwrap()
}

/// Sensitivities of the tracer's x times tolerances, over the turn.
fn effects() -> Vec<[f64; 2]> {
    let sweep = FourBar::NOMINAL.accuracy(&PHI.positions(361));
    let pairs = sweep.column(2).iter().zip(sweep.column(4));
    pairs
        .map(|(crank, coupler)| [crank * 0.012, coupler * 0.02])
        .collect()
}

#[test]
fn bands_are_sums_of_effects() {
    let json = json(&four_bar(FourBar::NOMINAL));
    let bands = json["bands"].as_array().unwrap();
    let heads: Vec<_> = bands
        .iter()
        .map(|band| ["table", "column", "kind"].map(|key| band[key].as_str().unwrap()))
        .collect();
    assert_eq!(
        heads,
        [
            ["accuracy", "tracer.x", "worst case"],
            ["accuracy", "tracer.x", "statistical"],
            ["accuracy", "tracer.y", "worst case"],
            ["accuracy", "tracer.y", "statistical"],
        ]
    );
    for (row, [a, b]) in effects().into_iter().enumerate() {
        let half = |band: usize| bands[band]["half"][row].as_f64().unwrap();
        assert!((half(0) - (a.abs() + b.abs())).abs() < 1e-15, "row {row}");
        assert!((half(1) - a.hypot(b)).abs() < 1e-15, "row {row}");
    }
}

#[test]
fn the_worst_position_is_found_with_its_contributions() {
    let json = json(&four_bar(FourBar::NOMINAL));
    let accuracy = json["accuracy"].as_array().unwrap();
    let names: Vec<_> = accuracy
        .iter()
        .map(|row| row["quantity"].as_str().unwrap())
        .collect();
    assert_eq!(
        names,
        ["tracer.x", "tracer.y", "alone.x"],
        "also of quantities that the function does not give"
    );
    let effects = effects();
    let worst = |[a, b]: [f64; 2]| a.abs() + b.abs();
    let row = (0..effects.len())
        .max_by(|i, j| worst(effects[*i]).total_cmp(&worst(effects[*j])))
        .unwrap();
    for quantity in [&accuracy[0], &accuracy[2]] {
        assert_eq!(quantity["unit"], "mm");
        assert_eq!(quantity["at"], PHI.positions(361)[row]);
        assert!((quantity["worst"].as_f64().unwrap() - worst(effects[row])).abs() < 1e-15);
        let parts = quantity["contributions"].as_array().unwrap();
        assert_eq!(parts.len(), 2);
        let sum: f64 = parts
            .iter()
            .map(|part| part["amount"].as_f64().unwrap())
            .sum();
        assert!((sum - worst(effects[row])).abs() < 1e-15);
        assert!(
            parts[0]["amount"].as_f64() >= parts[1]["amount"].as_f64(),
            "the largest first"
        );
        let of = |part: &Value| match part["parameter"].as_str().unwrap() {
            "crank" => effects[row][0].abs(),
            "coupler" => effects[row][1].abs(),
            other => panic!("{other}"),
        };
        assert!(parts.iter().all(|part| part["amount"] == of(part)));
    }
}

#[test]
fn positions_in_a_gap_are_not_the_worst() {
    let accuracy = json(&four_bar(FourBar::GAPPED));
    for row in accuracy["accuracy"].as_array().unwrap() {
        assert!(row["worst"].as_f64().unwrap().is_finite(), "{row}");
    }
}

#[test]
fn without_dimensions_there_are_no_bands() {
    let phi = PHI.positions(73);
    let report = Report::new("none", &PHI, &phi).table(&FourBar::NOMINAL.accuracy(&phi));
    let json = json(&report);
    assert_eq!(
        (&json["bands"], &json["accuracy"]),
        (&serde_json::json!([]), &serde_json::json!([]))
    );
    assert!(report.plot_errors().unwrap().is_none());
}
