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

/// Words of links have the meaning that the item gives them.
#[test]
fn links_and_their_words_are_described() {
    let text = "pub struct Drawn {
    unit mm;
    argument load = 1N;
    input phi = 60deg in 0deg..360deg;
    joint a = (0mm, 0mm), d = (140mm, 0mm);
    joint b = (25mm, 43.30127mm), c = (115mm, 96.8mm), tracer = (85mm, 110mm);
    joint e = (25mm, -40mm), f = (100mm, -40mm);
    link frame: a, d, e, f;
    link crank: a, b at phi;
    link coupler: b, c, tracer;
    link rocker: d, c length 100mm;
    joint g = (60mm, -40mm);
    link rod: b, g;
    slider s: g on frame along e, f block rod;
    force (0N, -load) on coupler at tracer;
    let course = spline(phi, [(0deg, 0), (90deg, 1), (180deg, 0)], quintic);
}
";
    let document = Document::new("links.mech", text);
    for (place, pieces) in [
        (
            "link coupler",
            &["link `coupler`", "3 joints: `b`, `c`, `tracer`"][..],
        ),
        ("d, c length", &["distance of the first two joints"]),
        ("along e, f block", &["does not turn in the slot"]),
        ("    force", &["A force on a body at a point."]),
        ("crank: a, b at", &["direction from the first joint"]),
        ("0)], quintic", &["Four derivatives"]),
    ] {
        let found = described(&document, place);
        for piece in pieces {
            assert!(found.contains(piece), "{place}: {piece} in {found}");
        }
    }
}

#[test]
fn quantities_of_a_link_are_in_its_description() {
    let text = "pub struct Drawn {
    unit mm;
    input phi = 60deg in 0deg..360deg;
    joint a = (0mm, 0mm), d = (140mm, 0mm);
    joint b = (25mm, 43.30127mm), c = (115mm, 96.8mm);
    link frame: a, d;
    link crank: a, b at phi;
    link coupler: b, c;
    link rocker: d, c length 100mm;
}
";
    let document = Document::new("links.mech", text);
    let found = described(&document, "link rocker");
    for piece in [
        "2 joints: `d`, `c`",
        "`rocker.length` is `100mm` at the reference",
        "`rocker.angle` is `104.",
    ] {
        assert!(found.contains(piece), "{piece} in {found}");
    }
}

#[test]
fn functions_have_operations_and_fields_have_quantities() {
    let slider = template("slider");
    let shown = |piece: &str| {
        let hover = slider.hover(after(&slider, piece));
        hover.expect("a description").markdown
    };
    let function = shown("pub fn stroke");
    assert!(
        function.starts_with("function `stroke`\n\noperations: "),
        "{function}"
    );
    assert!(function.contains(" sqrt"), "{function}");
    assert!(
        shown("Stroke { slide, v")
            .starts_with("field `v`: derivative of `slide` by `phi`, in mm/rad")
    );
}
