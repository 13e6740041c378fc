//! Declarations, uses and new names.

use linkage_editor::{Document, NameKind};

use crate::{after, template};

/// The text after all edits of a renaming.
fn renamed(document: &Document, offset: usize, name: &str) -> String {
    let mut edits = document.renamed(offset, name).expect("a name");
    edits.sort_by_key(|edit| std::cmp::Reverse(edit.range.start));
    let text = document.text().to_owned();
    edits.into_iter().fold(text, |text, edit| {
        Document::edit(&text, edit.range, &edit.text)
    })
}

#[test]
fn definitions_and_references() {
    let slider = template("slider");
    let use_of_pin = after(&slider, "loop pin");
    let definition = slider.definition(use_of_pin).expect("a name");
    assert_eq!(definition.end, after(&slider, "let pin"));
    assert_eq!(slider.references(use_of_pin, true).len(), 2);
    assert_eq!(slider.references(use_of_pin, false).len(), 1);
    assert_eq!(
        slider
            .definition(after(&slider, "impl SliderCrank"))
            .unwrap()
            .end,
        after(&slider, "struct SliderCrank")
    );
    assert_eq!(slider.definition(after(&slider, "= polar")), None);
}

#[test]
fn joints_of_links_are_names() {
    let joints = template("joints");
    assert_eq!(joints.references(after(&joints, "joint b"), true).len(), 4);
}

#[test]
fn renamed_texts_have_no_mistake() {
    for (name, piece) in [
        ("slider", "param crank"),
        ("slider", "unknown slide"),
        ("slider", "input phi"),
        ("slider", "struct SliderCrank"),
        ("slider", "fn stroke"),
        ("joints", "joint a"),
        ("joints", "link rocker"),
        ("joints", "at omega"),
        ("joints", "argument load"),
        ("clamp", "let spindle"),
    ] {
        let mut document = template(name);
        assert!(document.diagnostics().is_empty());
        let new = renamed(&document, after(&document, piece), "Renamed");
        document.set_text(&new);
        let found = document.diagnostics();
        assert!(found.is_empty(), "{name} {piece}: {found:?}\n{new}");
    }
}

#[test]
fn fields_keep_their_names() {
    let slider = template("slider");
    let new = renamed(&slider, after(&slider, "unknown slide"), "s");
    assert!(new.contains("Stroke { slide: s, v: velocity(s)"), "{new}");
}

#[test]
fn names_that_are_taken_are_refused() {
    let slider = template("slider");
    let pin = after(&slider, "let pin");
    assert_eq!(
        slider.renamed(pin, "rod").unwrap_err(),
        "there is another `rod`"
    );
    assert!(slider.renamed(pin, "2a").is_err());
    assert!(slider.renamed(pin, "loop").is_err());
    assert!(slider.renamed(after(&slider, "= polar"), "q").is_err());
}

#[test]
fn parts_lead_to_their_mechanisms() {
    let text =
        "struct Crank { unit mm; param r = 12mm; input phi = 0deg; let tip = polar(r, phi); }
        struct Machine { unit mm; input shaft = 0deg; part left: Crank { phi = shaft };
        let way = left.tip - left.tip; } impl Machine { fn f(shaft) -> F { way } }";
    let machine = Document::new("machine.mech", text);
    let found = machine
        .definition(after(&machine, "way = left.tip"))
        .expect("a name");
    assert_eq!(found.end, after(&machine, "let tip"));
    assert_eq!(
        machine.definition(after(&machine, "{ phi")).unwrap().end,
        after(&machine, "input phi")
    );
    assert_eq!(
        machine
            .definition(after(&machine, "left: Crank"))
            .unwrap()
            .end,
        after(&machine, "struct Crank")
    );
}

#[test]
fn symbols_are_a_tree() {
    let slider = template("slider");
    let symbols = slider.symbols();
    let [mechanism] = &symbols[..] else {
        panic!("one mechanism")
    };
    let kinds = |kind| {
        mechanism
            .inner
            .iter()
            .filter(|name| name.kind == kind)
            .count()
    };
    assert_eq!(
        [kinds(NameKind::Parameter), kinds(NameKind::Function)],
        [3, 3]
    );
    for inner in &mechanism.inner {
        assert!(mechanism.item.start <= inner.item.start && inner.item.end <= mechanism.item.end);
    }
}
