//! A document as text of the language: comments, one struct with joints and links, and functions.

use std::fmt::Write;

use crate::document::Document;
use crate::drawn::Drawn;
use crate::names::{in_comment, shown};
use crate::number::{short, short_length};

mod drive;
mod driven;
mod motors;
mod parts;
mod pose;
mod sizes;
mod spelling;

use crate::wrapped::{comment, item, warnings_as_comments};
use drive::Drive;
use spelling::Spelling;

/// Returns the text with its drawn pose, and adds warnings about ranges to those of the document.
pub(crate) fn text(document: &mut Document, name: &str, file: &str) -> (String, Drawn) {
    let spelling = Spelling::new(document);
    let drives = driven::drives(document, &spelling);
    confirm(document);
    let mut text = heading(document, file);
    let unit = document.unit.name();
    let _ = writeln!(text, "pub struct {name} {{\n    unit {unit};");
    for drive in &drives {
        let _ = writeln!(text, "    {}", drive.line);
    }
    driven::together(document, &drives, &mut text);
    text += "\n    // The joints where they are drawn.\n";
    parts::joints(document, &spelling, &mut text);
    text += "\n";
    sizes::about(document, &mut text);
    parts::links(document, &spelling, &drives, &mut text);
    parts::slots(document, &spelling, &drives, &mut text);
    parts::gears(document, &spelling, &mut text);
    parts::loads(document, &spelling, &drives, &mut text);
    text += "}\n";
    functions(document, &spelling, &drives, name, &mut text);
    (text, pose::drawn(document, &spelling, &drives))
}

/// The largest distance shows a wrong unit at once.
fn confirm(document: &mut Document) {
    if let Some((first, second, distance)) = document.largest_distance() {
        let [first, second] = [first, second].map(|joint| shown(&document.joints[joint].name));
        let unit = document.unit.name();
        document.warnings.push(format!(
            "the largest distance, of `{first}` and `{second}`, is {}{unit}: confirm it",
            short_length(distance)
        ));
    }
}

fn heading(document: &Document, file: &str) -> String {
    let mut text = String::new();
    let file = in_comment(&file.chars().take(60).collect::<String>());
    comment(
        &mut text,
        "// ",
        &format!("From {file}, {}.", document.origin),
    );
    if !document.name.is_empty() {
        let name = in_comment(&document.name);
        comment(
            &mut text,
            "// ",
            &format!("Its name in the file is {name}."),
        );
    }
    for remark in &document.remarks {
        comment(&mut text, "// ", &in_comment(remark));
    }
    if document.band > 0.0 {
        let band = short(document.band);
        let unit = document.unit.name();
        let note = format!("Each coordinate may be wrong by {band}{unit}: no length is exact.");
        comment(&mut text, "// ", &note);
    }
    warnings_as_comments(&mut text, &document.warnings);
    text
}

/// Functions for all joints that move, and for the drawing.
fn functions(
    document: &Document,
    spelling: &Spelling,
    drives: &[Drive],
    name: &str,
    text: &mut String,
) {
    let joints = 0..document.joints.len();
    let moving = joints.filter(|joint| !document.is_fixed(*joint));
    let moving: Vec<&str> = moving.map(|joint| &spelling.joints[joint][..]).collect();
    let inputs = drives.iter().filter(|drive| drive.leader.is_none());
    let inputs: Vec<&str> = inputs.map(|drive| &drive.name[..]).collect();
    let inputs = inputs.join(", ");
    let _ = writeln!(text, "\nimpl {name} {{");
    if !moving.is_empty() {
        let _ = writeln!(text, "    pub fn points({inputs}) -> Points {{");
        item(text, 8, &format!("{},", moving.join(", ")), 0);
        *text += "    }\n";
    }
    let _ = writeln!(
        text,
        "    pub fn shape({inputs}) -> Shape {{ shape: picture() }}\n}}"
    );
}
