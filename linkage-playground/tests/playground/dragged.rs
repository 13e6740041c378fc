//! Joints and dimensions that are dragged in the drawing: the text changes with them.

use linkage_browser::{Key, Page};

use crate::page::{FRAME, Shown};

/// The coordinates of a joint in a text, as they are written.
fn written<'t>(text: &'t str, joint: &str) -> &'t str {
    let (_, after) = text.split_once(&format!("{joint} = (")).expect("the joint");
    after.split_once(')').expect("its end").0
}

fn drag(page: &mut Page, from: (f64, f64), way: (f64, f64)) {
    page.hold(from);
    for step in 1..=5 {
        let part = f64::from(step) / 5.0;
        page.pull((from.0 + part * way.0, from.1 + part * way.1));
    }
}

#[test]
fn a_drawn_joint_is_dragged() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    let text = shown.text();
    let height = "document.getElementById('frame').clientHeight";
    let room = shown.page.number(height);
    shown.page.click("#shape");
    // The remark below takes no room from the drawing: joints stay under the pointer.
    assert_eq!(shown.page.number(height), room);
    // Joints that can be dragged are marked.
    let width = format!(
        "parseFloat(getComputedStyle({FRAME}.querySelector('[data-point=\"k\"] .mark')).strokeWidth)"
    );
    assert_eq!(shown.page.number(&width), 3.0);
    let from = shown.point("k");
    drag(&mut shown.page, from, (30.0, -20.0));
    shown.page.wait(&format!(
        "!playground.editor.text().includes('k = ({})')",
        written(&text, "k")
    ));
    shown.after(|page| page.release((from.0 + 30.0, from.1 - 20.0)));
    let moved = shown.text();
    assert_ne!(written(&moved, "k"), written(&text, "k"));
    assert_eq!(written(&moved, "b"), written(&text, "b"));
    // It is under the pointer, with the size that the picture had, and near to the place that is
    // written: the given length of another link moves the plate a little.
    let there = shown.point("k");
    let way = (there.0 - from.0, there.1 - from.1);
    assert!(
        (way.0 - 30.0).abs() < 3.0 && (way.1 + 20.0).abs() < 3.0,
        "{way:?} from {from:?}"
    );
    let shown_at =
        |axis: &str| format!("Number({FRAME}.querySelector('[data-point=\"k\"]').dataset.{axis})");
    let [x, y] = ["x", "y"].map(|axis| shown.page.number(&shown_at(axis)));
    let numbers = written(&moved, "k").split(", ").map(|part| {
        part.trim_end_matches("mm")
            .parse::<f64>()
            .expect("a number")
    });
    assert!(
        numbers
            .zip([x, y])
            .all(|(written, shown)| (written - shown).abs() < 2.0),
        "{x} {y}"
    );
    // One step of undo for the whole drag.
    shown.undo();
    assert_eq!(shown.text(), text);
    shown.page.assert_quiet();
}

#[test]
fn the_joint_of_a_driven_link_takes_the_reference_along() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    // A text that was typed: its steps of undo are before those of the drag.
    let example = shown.text();
    shown.after(|page| {
        page.value("playground.editor.replace('// typed\\n' + playground.editor.text())")
    });
    let text = shown.text();
    shown.page.click("#shape");
    let from = shown.point("b");
    drag(&mut shown.page, from, (-8.0, 0.0));
    shown.page.wait(&format!(
        "!playground.editor.text().includes('b = ({})')",
        written(&text, "b")
    ));
    shown.after(|page| page.release((from.0 - 8.0, from.1)));
    let moved = shown.text();
    let reference = |text: &str| {
        let (_, after) = text.split_once("input ").expect("an input");
        after.split(" in ").next().expect("a reference").to_owned()
    };
    assert_ne!(reference(&moved), reference(&text));
    assert_eq!(shown.messages(), "");
    shown.undo();
    assert_eq!(shown.text(), text);
    shown.undo();
    assert_eq!(shown.text(), example);
    shown.page.assert_quiet();
}

#[test]
fn arrow_keys_move_a_joint() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    let text = shown.text();
    shown.page.click("#shape");
    let focus = |page: &mut Page| {
        page.value(&format!(
            "{FRAME}.querySelector('[data-point=\"k\"]').focus()"
        ))
    };
    shown.page.value("document.getElementById('frame').focus()");
    focus(&mut shown.page);
    shown.after(|page| page.key(Key::Right));
    let once = shown.text();
    let x = |text: &str| {
        written(text, "k")
            .split("mm")
            .next()
            .expect("a number")
            .parse::<f64>()
            .expect("a number")
    };
    assert!(x(&once) > x(&text), "{}", written(&once, "k"));
    // The joint still has the focus.
    shown.after(|page| page.key(Key::Right));
    assert!(x(&shown.text()) > x(&once));
    shown.page.assert_quiet();
}

#[test]
fn a_pulled_pivot_changes_its_dimension() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    shown.choose("clamp");
    let text = shown.text();
    let from = shown.point("arm_pivot");
    drag(&mut shown.page, from, (4.0, 0.0));
    shown.page.wait(&format!(
        "!playground.editor.text().includes('arm_pivot = ({})')",
        written(&text, "arm_pivot")
    ));
    shown.after(|page| page.release((from.0 + 4.0, from.1)));
    assert_ne!(shown.text(), text);
    assert!(
        !shown
            .page
            .holds(&format!("{FRAME}.body.classList.contains('changed')"))
    );
    shown.undo();
    assert_eq!(shown.text(), text);
    shown.page.assert_quiet();
}

/// Points that follow from dimensions cannot be moved: the reason and the way are shown.
#[test]
fn a_text_without_joints_gets_advice() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    let status = "document.getElementById('status').textContent";
    let pressed = "document.getElementById('shape').getAttribute('aria-pressed') === 'true'";
    shown.choose("four-bar");
    shown.page.click("#shape");
    assert!(shown.page.words(status).contains("`joint name = (x, y)`"));
    assert!(!shown.page.holds(pressed));
    shown.choose("needle-drive");
    shown.page.click("#shape");
    assert!(shown.page.words(status).contains("in space"));
    assert!(!shown.page.holds(pressed));
    shown.page.assert_quiet();
}
