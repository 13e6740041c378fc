//! Declarations, uses and new names.

use std::ops::Range;

use linkage_editor::{Document, NameKind, Symbol};

use crate::{after, template, templates};

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

/// The names of symbols and those within them.
fn names(symbols: &[Symbol]) -> Vec<Range<usize>> {
    let names = symbols
        .iter()
        .flat_map(|symbol| std::iter::once(symbol.range.clone()).chain(names(&symbol.inner)));
    names.collect()
}

#[test]
fn renamed_texts_have_no_mistake() {
    let mut count = 0;
    for name in templates() {
        let original = template(&name);
        assert!(original.diagnostics().is_empty());
        for range in names(&original.symbols()) {
            let piece = &original.text()[range.clone()];
            let Ok(_) = original.renamed(range.end, "Renamed") else {
                assert_eq!(piece, "frame", "{name}");
                continue;
            };
            let new = renamed(&original, range.end, "Renamed");
            let document = Document::new("renamed.mech", &new);
            let found = document.diagnostics();
            assert!(found.is_empty(), "{name} {piece}: {found:?}\n{new}");
            count += 1;
        }
    }
    assert!(count > 200, "{count}");
}

#[test]
fn words_of_the_language_may_be_names() {
    let text = "struct Press { unit mm; param mass = 2kg; input at = 0deg in 0deg..360deg;
        unknown turns = 10deg; let pin = (10mm, 0mm); loop turns = at;
        body arm = pin on frame at pin, turns turns, mass mass at pin; }
        impl Press { fn f(at) -> F { turns, pin } }";
    for (piece, uses) in [
        ("param mass", 2),
        ("input at", 3),
        ("unknown turns", 4),
        ("let pin", 4),
    ] {
        let mut document = Document::new("press.mech", text);
        assert!(
            document.diagnostics().is_empty(),
            "{:?}",
            document.diagnostics()
        );
        let offset = after(&document, piece);
        assert_eq!(document.references(offset, true).len(), uses, "{piece}");
        let new = renamed(&document, offset, "other");
        document.set_text(&new);
        let found = document.diagnostics();
        assert!(found.is_empty(), "{piece}: {found:?}\n{new}");
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
fn the_frame_keeps_its_name() {
    let joints = template("joints");
    let frame = after(&joints, "link frame");
    assert_eq!(joints.renamable(frame), None);
    let refused = joints.renamed(frame, "ground").unwrap_err();
    assert!(refused.starts_with("`frame` is the link"), "{refused}");
    assert!(joints.renamable(after(&joints, "link rocker")).is_some());
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
