//! Forces that grow without bound at a singular position, where all loops close.

use std::fs;
use std::path::Path;

use crate::{folder, linkage, printed};

/// Writes the scissor lift with another lower end of its cylinder's range.
fn lift(folder: &Path, lowest: &str) {
    if !folder.join("lift.mech").exists() {
        printed(folder, &["new", "lift.mech", "--from", "scissors"]);
    }
    let text = fs::read_to_string(folder.join("lift.mech")).expect("the mechanism");
    let other = text.replace("in 560mm..", &format!("in {lowest}.."));
    assert!(other.contains(lowest));
    fs::write(folder.join("other.mech"), other).expect("it can be written");
}

/// Returns the messages of a command that succeeds.
fn said(folder: &Path, arguments: &[&str]) -> String {
    let output = linkage(folder, arguments);
    assert!(output.status.success(), "{arguments:?}");
    String::from_utf8(output.stderr).expect("a text")
}

/// The arms of the lift are level there: their pins and the foot are in one line.
const MESSAGE: &str = "ScissorLift: `centre.x` of `force` grows without bound at `length = 470 mm`: the mechanism passes a singular position\n";

#[test]
fn a_check_and_a_table_name_singular_positions() {
    let folder = folder("unbounded");
    lift(&folder, "468mm");
    let checked = said(&folder, &["check", "other.mech"]);
    assert_eq!(checked.matches("warning: ").count(), 1, "{checked}");
    assert!(
        checked.starts_with(&format!("warning: {MESSAGE}help: ")),
        "{checked}"
    );
    let table = ["table", "other.mech", "force"];
    assert_eq!(said(&folder, &table), format!("note: {MESSAGE}"));
    // Few positions, on both sides or on one.
    for steps in ["9", "30"] {
        let few = [&table[..], &["--to", "480mm", "--steps", steps]].concat();
        assert_eq!(said(&folder, &few), format!("note: {MESSAGE}"), "{steps}");
    }
    let json = [&table[..], &["--json"]].concat();
    assert_eq!(said(&folder, &json), format!("note: {MESSAGE}"));
}

#[test]
fn large_forces_and_forces_through_zero_are_no_singular_positions() {
    let folder = folder("unbounded_not");
    // Near to the singular position, and not over it.
    lift(&folder, "470.5mm");
    assert_eq!(said(&folder, &["check", "other.mech"]), "");
    assert_eq!(said(&folder, &["table", "other.mech", "force"]), "");
    // The force of the wheel changes its sign above the range.
    let table = ["table", "other.mech", "force", "--to", "900mm"];
    assert_eq!(said(&folder, &table), "");
    printed(&folder, &["new", "press.mech", "--from", "toggle-press"]);
    for steps in ["5", "9", "361"] {
        let table = ["table", "press.mech", "forces", "--steps", steps];
        assert_eq!(said(&folder, &table), "", "{steps}");
    }
}
