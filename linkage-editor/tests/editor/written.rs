//! Texts that are being written.

use linkage_editor::{Document, NameKind, formatted};

use crate::{after, template, text};

/// The names of the struct block that a text declares.
fn names(document: &Document) -> Vec<String> {
    let mechanisms = document.symbols().into_iter();
    let names = mechanisms.flat_map(|mechanism| mechanism.inner);
    let values = names.filter(|name| name.kind != NameKind::Function);
    values.map(|name| name.name).collect()
}

#[test]
fn an_item_that_is_broken_hides_no_other() {
    let whole = names(&template("slider"));
    let item = "let pin = polar(crank, phi);";
    for broken in [
        "let pin = polar(crank, phi;",
        "let pin = polar(crank, ",
        "let pin = ",
        "let pin = [polar(crank], phi);",
        "let pin = polar(crank, phi)",
        "let pin = 2° * \"crank;",
        "let pin = polar(crank, phi));",
        "let pin = /* polar(crank, phi);",
    ] {
        let mut document = template("slider");
        document.set_text(&text("slider").replace(item, broken));
        let found = names(&document);
        // A comment without an end hides all that follows.
        let expected = if broken.contains("/*") {
            &whole[..7]
        } else {
            &whole[..]
        };
        let shown = &found[..expected.len().min(found.len())];
        assert_eq!(shown, expected, "{broken}");
        assert!(!document.diagnostics().is_empty(), "{broken}");
    }
}

#[test]
fn every_beginning_has_answers() {
    for name in ["joints", "cam"] {
        let text = text(name);
        let mut document = Document::new("a.mech", "");
        for (end, _) in text.char_indices().step_by(41) {
            document.set_text(&text[..end]);
            let _ = (
                document.completions(end),
                document.hover(end),
                document.signature(end),
            );
            let _ = (
                document.actions(end..end),
                document.words(),
                document.hints(),
            );
            let _ = formatted(document.text());
        }
        document.set_text(&text);
        assert_eq!(document.diagnostics(), [], "{name}");
    }
}

#[test]
fn a_mark_in_front_moves_nothing() {
    let marked = format!("\u{feff}{}", text("slider"));
    let mut slider = Document::new("slider.mech", &marked);
    let place = after(&slider, "unknown slide");
    assert!(
        slider
            .hover(place)
            .is_some_and(|hover| hover.markdown.contains("`153."))
    );
    slider.set_text(&marked.replace("polar(crank", "polar(cank"));
    let [message] = slider.diagnostics() else {
        panic!("{:?}", slider.diagnostics())
    };
    assert_eq!(&slider.text()[message.range.clone()], "cank");
}

#[test]
fn places_of_a_name_that_is_declared_twice_are_one_message() {
    let document = Document::new(
        "a.mech",
        "struct A { unit mm; param r = 3mm; param r = 4mm; }",
    );
    let messages = document.diagnostics().iter();
    let found = messages.filter(|message| message.message.contains("defined twice"));
    let found: Vec<_> = found.collect();
    let [message] = &found[..] else {
        panic!("{found:?}")
    };
    assert_eq!(message.related[0].message, "`r` is first defined here");
    assert_eq!(message.related[0].range.end, after(&document, "param r"));
}
