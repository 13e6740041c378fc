//! Whether a range closes, and where its gaps are: every border from both sides.

use crate::fixture::{PHI, Sweep, pictured, value};
use crate::picture::{classed, corners, lines, number, words};
use linkage_report::{Plot, Report};
use linkage_runtime::{Column, Heading, Input};
use roxmltree::Document;
use serde_json::{Value, json};
use std::f64::consts::TAU;

const LENGTH: Heading = heading(&[value("s", "mm")]);
const ANGLE: Heading = heading(&[value("psi", "rad")]);
const PICTURED: Heading = heading(&[value("s", "mm"), pictured("p.x", "mm")]);

const fn heading(columns: &'static [Column]) -> Heading {
    Heading {
        function: "motion",
        arguments: &["phi"],
        columns,
        picture: None,
    }
}

fn data(input: &Input, heading: &'static Heading, rows: &[(f64, &[f64])]) -> Value {
    let positions: Vec<f64> = rows.iter().map(|row| row.0).collect();
    let row = |x: f64| rows.iter().find(|row| row.0 == x).unwrap().1.to_vec();
    let report = Report::new("Cycle", input, &positions);
    let report = report.table(&Sweep::new(heading, &positions, row));
    serde_json::from_str(&report.json().unwrap()).unwrap()
}

fn closes(input: &Input, heading: &'static Heading, rows: &[(f64, &[f64])]) -> bool {
    data(input, heading, rows)["input"]["periodic"] == true
}

/// Whether a turn closes that begins and ends with these numbers.
fn turn(heading: &'static Heading, first: &[f64], last: &[f64]) -> bool {
    closes(&PHI, heading, &[(0.0, first), (3.0, first), (TAU, last)])
}

#[test]
fn a_turn_closes_to_within_rounding() {
    // Up to a length of 1 in its unit, then in proportion.
    for size in [0.0, 1e-3, 1.0, 1e6] {
        let more = |share: f64| turn(&LENGTH, &[size], &[size + share * size.max(1.0)]);
        assert!(more(0.0) && more(0.9e-9), "{size}");
        assert!(!more(1.1e-9) && !more(1e-6) && !more(1e-3), "{size}");
    }
    // The largest value counts, wherever it is.
    let large = [(0.0, [1.0]), (2.0, [-1e6]), (TAU, [1.0005])];
    assert!(closes(
        &PHI,
        &LENGTH,
        &large.each_ref().map(|(x, s)| (*x, s.as_slice()))
    ));
    assert!(!turn(&LENGTH, &[1.0], &[f64::NAN]));
}

#[test]
fn angles_close_apart_from_whole_turns() {
    for turns in [-2.0, 1.0, 3.0] {
        assert!(turn(&ANGLE, &[0.3], &[0.3 + TAU * turns]));
        assert!(!turn(&ANGLE, &[0.3], &[0.3 + TAU * (turns + 0.5)]));
    }
    assert!(!turn(&LENGTH, &[0.3], &[0.3 + TAU]));
}

#[test]
fn the_input_must_be_an_angle_that_turns() {
    let range = |input: &Input, last: f64| closes(input, &LENGTH, &[(0.0, &[1.0]), (last, &[1.0])]);
    assert!(range(&PHI, TAU) && range(&PHI, 3.0 * TAU) && range(&PHI, -TAU));
    assert!(range(&PHI, TAU * (1.0 + 0.9e-9)) && !range(&PHI, TAU * (1.0 + 1.1e-9)));
    assert!(!range(&PHI, 0.5 * TAU) && !range(&PHI, 1e-12));
    let slide = Input { unit: "mm", ..PHI };
    assert!(!range(&slide, TAU));
}

#[test]
fn what_is_drawn_must_close_too() {
    assert!(turn(&PICTURED, &[1.0, 2.0], &[1.0, 2.0]));
    assert!(!turn(&PICTURED, &[1.0, 2.0], &[1.0, 3.0]));
}

#[test]
fn each_gap_is_from_its_first_to_its_last_position() {
    const MISSING: [f64; 1] = [f64::NAN];
    const THERE: [f64; 1] = [1.0];
    let gaps = |missing: [bool; 7]| {
        let rows: Vec<(f64, &[f64])> = (0..7)
            .map(|row| {
                let values: &[f64] = if missing[row] { &MISSING } else { &THERE };
                (row as f64, values)
            })
            .collect();
        data(&PHI, &LENGTH, &rows)["gaps"].clone()
    };
    let (no, on) = (false, true);
    assert_eq!(gaps([no; 7]), json!([]));
    assert_eq!(gaps([on; 7]), json!([{ "from": 0.0, "to": 6.0 }]));
    assert_eq!(
        gaps([on, on, no, on, no, no, on]),
        json!([{ "from": 0.0, "to": 1.0 }, { "from": 3.0, "to": 3.0 }, { "from": 6.0, "to": 6.0 }])
    );
}

#[test]
fn a_gap_is_shaded_half_way_to_its_neighbours() {
    const GAP: f64 = f64::NAN;
    let x = [0.0, 1.0, 3.0, 4.0, 7.0, 8.0, 10.0];
    let y = [GAP, 1.0, GAP, GAP, 1.0, 1.0, GAP];
    let plot = Plot::new("x", "mm", &x).curve("y", "N", &y);
    let svg = plot.curve("z", "N", &[1.0; 7]).svg().unwrap();
    let svg = Document::parse(&svg).unwrap();
    let line = lines(&svg, "curve");
    let line = corners(
        line.iter()
            .find(|line| corners(**line).len() == 7)
            .unwrap()
            .to_owned(),
    );
    let scale = (line[6][0] - line[0][0]) / 10.0;
    let shaded: Vec<[f64; 2]> = classed(&svg, "gap")
        .into_iter()
        .map(|gap| {
            let from = (number(gap, "x") - line[0][0]) / scale;
            [from, from + number(gap, "width") / scale]
        })
        .collect();
    let expected = [[0.0, 0.5], [2.0, 5.5], [9.0, 10.0]];
    assert_eq!(shaded.len(), expected.len());
    for (found, expected) in shaded.iter().flatten().zip(expected.iter().flatten()) {
        assert!((found - expected).abs() < 1e-3, "{shaded:?}");
    }
}

#[test]
fn four_gaps_are_listed_more_are_counted() {
    let note = |gaps: usize| {
        let x: Vec<f64> = (0..2 * gaps + 1).map(|row| row as f64).collect();
        let y: Vec<f64> = (0..x.len())
            .map(|row| if row % 2 == 1 { f64::NAN } else { 1.0 })
            .collect();
        let svg = Plot::new("x", "mm", &x).curve("y", "N", &y).svg().unwrap();
        words(&Document::parse(&svg).unwrap(), "note")[0].to_owned()
    };
    let why = "mm: the mechanism cannot be assembled there, or a value is infinite.";
    assert_eq!(note(4), format!("Gaps at x = 1, 3, 5, 7 {why}"));
    assert_eq!(note(5), format!("Gaps at x = 1, 3, 5, 7, and 1 more {why}"));
}
