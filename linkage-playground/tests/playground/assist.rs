//! Calls and values next to names, as the language server has them.

use linkage_browser::Key;

use crate::page::{EDITOR, Shown};

#[test]
fn the_call_around_the_caret_is_described() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    shown.choose("four-bar");
    shown.type_after("polar(crank", ", ");
    let active = format!("{EDITOR}.querySelector('.signature strong').textContent");
    shown.page.wait(&format!("{active} === 'angle'"));
    // Out of the call again.
    shown
        .page
        .value("playground.editor.view.dispatch({ selection: { anchor: 0 } })");
    shown
        .page
        .wait(&format!("!{EDITOR}.querySelector('.signature')"));
    shown.page.assert_quiet();
}

#[test]
fn values_are_next_to_names() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    shown.choose("four-bar");
    let hints = format!("[...{EDITOR}.querySelectorAll('.hint')].map((hint) => hint.textContent)");
    shown.page.wait(&format!("{hints}.length > 0"));
    let first = shown.page.words(&format!("{hints}[0]"));
    assert!(first.starts_with(" = "), "{first}");
    // Other dimensions, other values.
    shown.after(|page| {
        page.value("playground.editor.replace(playground.editor.text().replace(/param crank += \\d+mm/, 'param crank = 33mm'))")
    });
    shown.page.wait(&format!(
        "{hints}.length > 0 && {hints}[0] !== {}",
        serde_json::json!(first)
    ));
    shown.page.assert_quiet();
}

/// Words of the language are those of the compiler.
#[test]
fn words_have_the_colours_of_the_compiler() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    shown.choose("four-bar");
    let colour = |word: &str| {
        format!(
            "getComputedStyle([...{EDITOR}.querySelectorAll('.cm-line span')].find((span) => span.textContent === '{word}')).color"
        )
    };
    let [keyword, function] = ["param", "polar"].map(|word| shown.page.words(&colour(word)));
    assert_ne!(keyword, function);
    for word in ["unit", "loop", "unknown", "struct", "input"] {
        assert_eq!(shown.page.words(&colour(word)), keyword, "{word}");
    }
    // A name of the text, which is a word of the language in a joint.
    let pin = format!("{EDITOR}.querySelector('.declared')");
    shown.page.wait(&format!("{pin}?.textContent === 'along'"));
    let name = format!("getComputedStyle({pin}.querySelector('span') ?? {pin}).color");
    assert_ne!(shown.page.words(&name), keyword);
    shown.page.assert_quiet();
}

/// Lines are indented by their braces, and no bracket is written twice.
#[test]
fn a_block_is_written_as_it_is_typed() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    shown.after(|page| page.value("playground.editor.replace('')"));
    shown.page.value("playground.editor.view.focus()");
    for line in [
        "struct Crank {",
        "unit mm;",
        "let tip = polar(2mm, 30deg);",
        "}",
    ] {
        // Letter by letter, as brackets are answered.
        for letter in line.chars() {
            shown.page.type_text(&letter.to_string());
        }
        shown.page.key(Key::Enter);
    }
    assert_eq!(
        shown.text(),
        "struct Crank {\n    unit mm;\n    let tip = polar(2mm, 30deg);\n}\n"
    );
    shown.page.assert_quiet();
}
