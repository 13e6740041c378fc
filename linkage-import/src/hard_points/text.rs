//! The text of a suspension: joints and links in columns.

use std::fmt::Write;

use super::suspension::{LinkLine, Suspension};
use crate::number::{banded, plain};
use crate::placement::{Vector, difference, length};
use crate::wrapped::item;

/// Adds the items of the struct.
pub(super) fn items(suspension: &Suspension, input: &str, band: f64, text: &mut String) {
    let unit = suspension.unit;
    let _ = writeln!(text, "    unit {unit};\n\n    {input}");
    for line in &suspension.parameters {
        let _ = writeln!(text, "    {line}");
    }
    text.push_str("\n    // The joints where they are drawn: forward, left, up.\n");
    joints(suspension, text);
    text.push_str(
        "\n    // Links: lengths are those of the drawing, with the bands of their rounding.\n",
    );
    item(
        text,
        4,
        &format!("link frame: {};", suspension.frame.join(", ")),
        0,
    );
    for link in &suspension.links {
        let LinkLine {
            name,
            joints,
            clause,
            ..
        } = link;
        let line = format!("link {name}: {}{clause};", joints.join(", "));
        item(text, 4, &line, 0);
        lengths(suspension, link, band, text);
    }
    for lines in [&suspension.loops, &suspension.lets] {
        if !lines.is_empty() {
            text.push('\n');
        }
        for line in lines {
            let _ = writeln!(text, "    {line}");
        }
    }
}

/// Adds the functions.
pub(super) fn functions(suspension: &Suspension, name: &str, text: &mut String) {
    let _ = writeln!(
        text,
        "\nimpl {name} {{\n    /// Points, and what depends on the travel of the wheel.\n    pub fn motion(travel) -> Motion {{"
    );
    item(text, 8, &suspension.quantities.join(", "), 0);
    text.push_str(
        "    }\n\n    /// The links, for the drawing.\n    pub fn shape(travel) -> Shape { shape: picture() }\n}\n",
    );
}

/// A line for each joint, in columns; points that the file does not have are longer.
fn joints(suspension: &Suspension, text: &mut String) {
    let unit = suspension.unit;
    let cells: Vec<[String; 3]> = suspension
        .joints
        .iter()
        .map(|joint| joint.at.map(|value| format!("{}{unit}", plain(value))))
        .collect();
    let of_file = suspension.joints.iter().zip(&cells);
    let of_file = of_file.filter(|(joint, _)| joint.is_of_file);
    let width = |axis: usize| of_file.clone().map(|(_, cells)| cells[axis].len()).max();
    let widths = [0, 1, 2].map(|axis| width(axis).unwrap_or(0));
    let names = suspension.joints.iter().map(|joint| joint.name.len());
    let longest = names.max().unwrap_or(0);
    for (joint, [x, y, z]) in suspension.joints.iter().zip(&cells) {
        let [of_x, of_y, of_z] = widths;
        let note = match joint.note.is_empty() {
            true => String::new(),
            false => format!("    // {}", joint.note),
        };
        let _ = writeln!(
            text,
            "    joint {:longest$} = ({x:>of_x$}, {y:>of_y$}, {z:>of_z$});{note}",
            joint.name
        );
    }
}

/// The lengths that a link keeps, as comments.
fn lengths(suspension: &Suspension, link: &LinkLine, band: f64, text: &mut String) {
    for [from, to] in &link.lengths {
        let at = |name: &str| -> Option<Vector> { suspension.position(name) };
        let (Some(start), Some(end)) = (at(from), at(to)) else {
            continue;
        };
        let apart = difference(end, start);
        let distance = length(apart);
        // Both ends may be off by the band in all coordinates.
        let sum: f64 = apart.iter().map(|component| component.abs()).sum();
        let error = match distance > 0.0 {
            true => 2.0 * band * sum / distance,
            false => 2.0 * band * 3f64.sqrt(),
        };
        let banded = banded(distance, error, suspension.unit);
        let _ = writeln!(text, "    //   {from} to {to} {banded}");
    }
}
