//! A changed number exchanges the numbers of the page, and its elements stay.

use serde_json::json;

use crate::page::{FRAME, Shown};

/// Everything that the page shows, as text: elements with their attributes in order, words, states
/// of fields. Names of points depend on where they were before, so their places are left out.
const SHOWN: &str = "(async () => { \
     for (const fold of FRAME.querySelectorAll('details')) fold.open = true; \
     await new Promise((done) => setTimeout(done, 100)); \
     const written = (node) => { \
       if (node.nodeType !== 1) return node.textContent; \
       if (node.matches('.name, .leader')) return node.textContent; \
       const attributes = [...node.attributes].map(({ name, value }) => `${name}=${value}`).sort(); \
       const state = ['value', 'checked', 'disabled', 'open', 'hidden'].map((name) => String(node[name])); \
       return `<${node.localName} ${attributes} ${state}>${[...node.childNodes].map(written).join('')}</>`; \
     }; \
     return written(FRAME.body.querySelector('main')); })()";

/// Replaces words of the text.
fn replace(shown: &mut Shown, before: &str, after: &str) {
    let text = shown.text();
    assert!(text.contains(before), "{before}");
    let changed = json!(text.replacen(before, after, 1));
    shown.after(|page| page.value(&format!("playground.editor.replace({changed})")));
}

/// The elements are the same ones before and after a change.
fn mark(shown: &mut Shown) {
    shown.page.value(&format!(
        "{FRAME}.querySelector('#panels .panel').isMarked = true"
    ));
}

fn is_marked(shown: &mut Shown) -> bool {
    let marked = format!("{FRAME}.querySelector('#panels .panel').isMarked === true");
    shown.page.holds(&marked)
}

/// The surroundings of the first difference of two pages.
fn first_difference(renewed: &str, new: &str) -> Option<[String; 2]> {
    let same = renewed.chars().zip(new.chars());
    let same = same.take_while(|(left, right)| left == right).count();
    let near = |page: &str| {
        page.chars()
            .skip(same.saturating_sub(200))
            .take(300)
            .collect()
    };
    (renewed != new).then(|| [near(renewed), near(new)])
}

#[test]
fn renewed_pages_are_as_new_ones() {
    const CHANGES: [(&str, &str, &str); 6] = [
        ("four-bar", "coupler = 120mm", "coupler = 117mm"),
        ("four-bar", "across = 45mm", "across = 38.5mm"),
        // A range with gaps, and their reason.
        ("four-bar", "crank   = 50mm", "crank   = 66mm"),
        ("joints", "k = (60mm, 110mm)", "k = (64mm, 112mm)"),
        ("quick-return", "crank  = 80mm", "crank  = 78mm"),
        ("hook-needle", "l910 = 122.5mm", "l910 = 121mm"),
    ];
    let Some(mut shown) = Shown::open() else {
        return;
    };
    let all = SHOWN.replace("FRAME", FRAME);
    for (example, before, after) in CHANGES {
        shown.choose(example);
        mark(&mut shown);
        replace(&mut shown, before, after);
        assert!(is_marked(&mut shown), "{example}: {after}");
        let renewed = shown.page.words(&all);
        shown.page.value("playground.view.forget()");
        shown.after(|page| page.value("void playground.analyses.want()"));
        assert!(!is_marked(&mut shown));
        let new = shown.page.words(&all);
        let at = first_difference(&renewed, &new);
        assert_eq!(at, None, "{example}: {after}");
    }
    shown.page.assert_quiet();
}

/// Other functions, columns and names need other elements.
#[test]
fn other_structures_are_made_anew() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    for (before, after) in [
        ("Swing { psi,", "Swing { psi, theta,"),
        ("param across", "param offset = 3mm; param across"),
        ("A crank turns", "A crank rotates"),
        ("0deg..360deg", "10deg..300deg"),
    ] {
        shown.choose("four-bar");
        mark(&mut shown);
        replace(&mut shown, before, after);
        assert!(!is_marked(&mut shown), "{after}");
    }
    shown.page.assert_quiet();
}
