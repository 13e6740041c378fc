//! Words that can be written.

use linkage_editor::Document;

use crate::{after, template};

fn labels(document: &Document, offset: usize) -> Vec<String> {
    let all = document.completions(offset).into_iter();
    all.map(|word| word.label).collect()
}

/// The labels after a text was put in the place of a piece, at its end.
fn written(name: &str, piece: &str, text: &str) -> Vec<String> {
    let mut document = template(name);
    let place = after(&document, piece);
    let new = Document::edit(document.text(), place - piece.len()..place, text);
    document.set_text(&new);
    labels(&document, place - piece.len() + text.len())
}

fn has(labels: &[String], wanted: &[&str]) {
    for word in wanted {
        assert!(
            labels.iter().any(|label| label == word),
            "{word} in {labels:?}"
        );
    }
}

fn has_not(labels: &[String], unwanted: &[&str]) {
    for word in unwanted {
        assert!(
            labels.iter().all(|label| label != word),
            "{word} in {labels:?}"
        );
    }
}

#[test]
fn names_and_functions_in_expressions() {
    let found = written("slider", "let pin = polar(crank, phi);", "let pin = p");
    has(&found, &["crank", "slide", "phi", "polar", "rise", "PI"]);
    has_not(&found, &["velocity", "param", "line"]);
}

#[test]
fn quantities_in_functions_only() {
    let found = written("slider", "v: velocity(slide)", "v: ");
    has(&found, &["velocity", "reaction", "slide", "polar"]);
    let found = written("slider", "stroke(phi)", "stroke(");
    assert_eq!(found, ["phi"]);
}

#[test]
fn words_of_items_at_their_beginning() {
    let found = written("slider", "let pin = polar(crank, phi);", "l");
    has(&found, &["let", "loop", "link", "param"]);
    has_not(&found, &["crank", "polar"]);
    assert!(written("slider", "let pin = polar(crank, phi);", "let p").is_empty());
}

#[test]
fn units_after_numbers() {
    let found = written("slider", "param crank  = 40mm", "param crank = 40m");
    has(&found, &["mm", "deg", "rpm"]);
    let found = written("slider", "unit mm", "unit ");
    assert_eq!(found, ["m", "mm", "cm", "um", "inch"]);
}

#[test]
fn members_of_links_and_vectors() {
    let found = written(
        "joints",
        "e: sensitivity(stroke, [rocker.length, rod.length])",
        "e: rocker.",
    );
    has(&found, &["length", "angle"]);
    has_not(&found, &["crank", "polar"]);
    let found = written(
        "slider",
        "let slider = (slide, offset);",
        "let slider = (slide, pin.",
    );
    assert_eq!(found, ["x", "y"]);
}

#[test]
fn laws_within_courses() {
    let found = written(
        "slider",
        "let slider = (slide, offset);",
        "let slider = (slide, rise(phi, ",
    );
    has(&found, &["line", "cycloidal", "crank"]);
}

#[test]
fn nothing_within_comments() {
    let slider = template("slider");
    assert!(labels(&slider, after(&slider, "// A slider")).is_empty());
}

/// A four-bar with a slider, as joints and links.
const LINKS: &str = "pub struct Drawn {
    unit mm;
    input phi = 60deg in 0deg..360deg;
    joint a = (0mm, 0mm), d = (140mm, 0mm);
    joint b = (25mm, 43.3mm), c = (115mm, 96.8mm);
    link frame: a, d;
    link crank: a, b at phi;
    link coupler: b, c ;
    link rocker: d, c;
    slider s: c on rocker ;
}
";

#[test]
fn clauses_of_links_and_sliders() {
    let document = Document::new("links.mech", LINKS);
    let found = labels(&document, after(&document, "link coupler: b, c "));
    has(&found, &["at", "length", "about", "mass", "a", "frame"]);
    has_not(&found, &["through", "teeth", "turns"]);
    let found = labels(&document, after(&document, "slider s: c on rocker "));
    has(
        &found,
        &["along", "through", "around", "radius", "block", "at"],
    );
    has_not(&found, &["mass", "teeth"]);
    for place in ["link coupler: b, c ", "slider s: c on rocker "] {
        let found = labels(&document, after(&document, place));
        let frames = found.iter().filter(|label| *label == "frame");
        assert_eq!(frames.count(), 1, "{found:?}");
    }
}
