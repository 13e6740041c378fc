//! The text of a suspension: joints and links in columns.

use std::fmt::Write;

use super::suspension::{LinkLine, Suspension};
use crate::number::{banded, plain};
use crate::robots::{Vector, difference, length};
use crate::wrapped::COLUMNS;

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
    listed(text, "link frame: ", &suspension.frame, "");
    for link in &suspension.links {
        listed(
            text,
            &format!("link {}: ", link.name),
            &link.joints,
            &link.clause,
        );
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
    let mut line = String::new();
    for quantity in &suspension.quantities {
        if !line.is_empty() && line.len() + quantity.len() + 10 > COLUMNS {
            let _ = writeln!(text, "        {}", line.trim_end());
            line.clear();
        }
        let _ = write!(line, "{quantity}, ");
    }
    let _ = writeln!(
        text,
        "        {}\n    }}\n\n    /// The links, for the drawing.\n    pub fn shape(travel) -> Shape {{ shape: picture() }}\n}}",
        line.trim_end()
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

/// A link in lines of the width of comments.
fn listed(text: &mut String, start: &str, names: &[String], clause: &str) {
    let mut line = format!("    {start}");
    for (index, name) in names.iter().enumerate() {
        let end = if index + 1 == names.len() { "" } else { ", " };
        if line.len() + name.len() + end.len() > COLUMNS {
            let _ = writeln!(text, "{}", line.trim_end());
            line = " ".repeat(8);
        }
        let _ = write!(line, "{name}{end}");
    }
    let _ = writeln!(text, "{line}{clause};");
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
