//! Descriptions of words.

use linkage_editor::Document;

use crate::{after, template};

fn described(document: &Document, piece: &str) -> String {
    let hover = document.hover(after(document, piece) - 1);
    hover.map_or_else(String::new, |hover| hover.markdown)
}

#[test]
fn names_have_kind_type_value_range_cost_and_comment() {
    let slider = template("slider");
    let unknown = described(&slider, "unknown slide");
    for piece in [
        "unknown `slide`: a length",
        "`153.",
        "at the reference",
        "while `phi` is 0deg to 360deg",
        "operations: ",
        "place of the slider",
    ] {
        assert!(unknown.contains(piece), "{piece} in {unknown}");
    }
    let parameter = described(&slider, "param crank");
    assert!(parameter.contains("`40mm` at the reference"), "{parameter}");
    assert!(!parameter.contains("operations"), "{parameter}");
    assert!(
        !parameter.contains("while"),
        "a dimension does not move: {parameter}"
    );
}

#[test]
fn words_of_the_language_are_described() {
    let slider = template("slider");
    for (place, piece) in [
        ("    loop", "equation that the links close"),
        ("let pin = polar", "polar(length, angle)"),
        ("v: velocity", "velocity(quantity)"),
        ("= 40mm", "millimetre"),
        ("unit mm", "millimetre"),
    ] {
        let found = described(&slider, place);
        assert!(found.contains(piece), "{place}: {found}");
    }
}

#[test]
fn quantities_of_links_have_values() {
    let joints = template("joints");
    let length = described(&joints, "[rocker.length");
    assert!(length.contains("`106mm` at the reference"), "{length}");
}

#[test]
fn values_stay_while_the_text_has_mistakes() {
    let mut slider = template("slider");
    let broken = slider.text().replace("loop pin +", "loop pin + (");
    slider.set_text(&broken);
    let found = described(&slider, "unknown slide");
    assert!(found.contains("before the last mistakes"), "{found}");
    assert!(slider.hints().is_empty());
}
