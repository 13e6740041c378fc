//! Items of the struct: joints, links, sliders and gears.

use std::fmt::Write;

use crate::document::{Document, FRAME, InputKind, Load, PlacedLoad, SlotPath};
use crate::number::plain;
use crate::wrapped::item;

use super::drive::Drive;
use super::sizes;
use super::spelling::Spelling;

/// Adds a line for each joint.
pub(super) fn joints(document: &Document, spelling: &Spelling, text: &mut String) {
    let unit = document.unit.name();
    for (index, name) in spelling.joints.iter().enumerate() {
        let joint = &document.joints[index];
        let [x, y] = joint.position.map(plain);
        let note = match sizes::whole_position(document, joint.position) {
            _ if joint.is_derived => " // not in the file".to_owned(),
            Some([x, y]) => format!(" // ({}{unit}, {}{unit}) is within", plain(x), plain(y)),
            None => String::new(),
        };
        let start = if joins_nothing(document, index) {
            "// Joins nothing: "
        } else {
            ""
        };
        let _ = writeln!(
            text,
            "    {start}joint {name} = ({x}{unit}, {y}{unit});{note}"
        );
    }
}

/// Returns true for fixed points that nothing turns about or slides along.
fn joins_nothing(document: &Document, joint: usize) -> bool {
    let mut slots = document.slots.iter();
    document.links_of(joint) == [FRAME]
        && !slots.any(|slot| {
            slot.pin == joint
                || match slot.path {
                    SlotPath::Joints(first, second) => first == joint || second == joint,
                    SlotPath::Direction(_, _, through) => through == Some(joint),
                    SlotPath::Arc { centre, .. } => centre == joint,
                }
        })
}

/// Adds a line for each link, with its lengths behind it.
pub(super) fn links(document: &Document, spelling: &Spelling, drives: &[Drive], text: &mut String) {
    for (index, link) in document.links.iter().enumerate() {
        let joints = ordered(document, drives, index);
        if joints.is_empty() {
            continue;
        }
        let mut clauses = String::new();
        for drive in drives {
            match drive.kind {
                InputKind::Crank { link, .. } if link == index => {
                    let _ = write!(clauses, " at {}", drive.clause);
                }
                InputKind::Length { link } if link == index => {
                    let _ = write!(clauses, " length {}", drive.clause);
                }
                _ => {}
            }
        }
        if link.is_held {
            clauses += " at 0deg";
        }
        if let Some(mass) = &link.mass {
            let centre = &spelling.joints[mass.centre];
            let _ = write!(clauses, " mass {} at {centre}", mass.mass);
            if let Some(inertia) = &mass.inertia {
                let _ = write!(clauses, ", inertia {inertia}");
            }
        }
        let names: Vec<&str> = joints
            .iter()
            .map(|joint| &spelling.joints[*joint][..])
            .collect();
        let name = &spelling.links[index];
        item(
            text,
            4,
            &format!("link {name}: {}{clauses};", names.join(", ")),
            0,
        );
        if index != FRAME {
            sizes::of_link(document, spelling, &joints, text);
        }
    }
}

/// Returns the joints of a link as they are written: a crank begins at its pivot.
pub(super) fn ordered(document: &Document, drives: &[Drive], index: usize) -> Vec<usize> {
    let mut joints = document.links[index].joints.clone();
    joints.retain(|joint| index != FRAME || !joins_nothing(document, *joint));
    for drive in drives {
        match drive.kind {
            InputKind::Crank { link, pivot, .. } if link == index => {
                first(&mut joints, drive.target.unwrap_or(pivot));
                first(&mut joints, pivot);
            }
            InputKind::Crank { .. } | InputKind::Length { .. } | InputKind::Position { .. } => {}
        }
    }
    joints
}

/// Adds a line for each force.
pub(super) fn loads(document: &Document, spelling: &Spelling, drives: &[Drive], text: &mut String) {
    for PlacedLoad { link, joint, load } in &document.loads {
        let Load {
            vector,
            unit,
            turns,
        } = load;
        let joints = ordered(document, drives, *link);
        let name = &spelling.links[*link];
        let point = &spelling.joints[*joint];
        let components = |[x, y]: [f64; 2]| format!("({}{unit}, {}{unit})", plain(x), plain(y));
        let force = match joints[..] {
            [first, second, ..] if *turns => {
                let (sin, cos) = document.direction(first, second).sin_cos();
                let [x, y] = *vector;
                let along = [cos * x + sin * y, cos * y - sin * x];
                format!("rotate({}, {name}.angle)", components(along))
            }
            _ => components(*vector),
        };
        let _ = writeln!(text, "    force {force} on {name} at {point};");
    }
}

/// Moves a joint to the front.
fn first(joints: &mut Vec<usize>, joint: usize) {
    joints.retain(|other| *other != joint);
    joints.insert(0, joint);
}

/// Adds a line for each slot.
pub(super) fn slots(document: &Document, spelling: &Spelling, drives: &[Drive], text: &mut String) {
    for (index, slot) in document.slots.iter().enumerate() {
        let name = &spelling.slots[index];
        let pin = &spelling.joints[slot.pin];
        let guide = &spelling.links[slot.guide];
        let path = match &slot.path {
            SlotPath::Joints(first, second) => {
                let [first, second] = [first, second].map(|joint| &spelling.joints[*joint]);
                format!("along {first}, {second}")
            }
            SlotPath::Direction(_, direction, None) => format!("along {direction}"),
            SlotPath::Direction(_, direction, Some(joint)) => {
                format!("along {direction} through {}", spelling.joints[*joint])
            }
            SlotPath::Arc { centre, .. } => format!("around {}", spelling.joints[*centre]),
        };
        let block = slot.block.map_or_else(String::new, |block| {
            format!(", block {}", spelling.links[block])
        });
        let mut drives = drives.iter();
        let drive = drives.find(|drive| drive.kind == InputKind::Position { slot: index });
        let drive = drive.map_or_else(String::new, |drive| format!(" at {}", drive.clause));
        let _ = writeln!(
            text,
            "    slider {name}: {pin} on {guide} {path}{block}{drive};"
        );
        sizes::of_slot(document, slot, text);
    }
}

/// Adds a line for each pair of wheels.
pub(super) fn gears(document: &Document, spelling: &Spelling, text: &mut String) {
    for pair in &document.gears {
        let word = if pair.is_chain { "belt" } else { "gears" };
        let [first, second] = pair.wheels.map(|wheel| &spelling.links[wheel]);
        let arm = &spelling.links[pair.arm];
        let is_whole = pair.sizes.iter().all(|size| size.fract() == 0.0);
        let unit = document.unit.name();
        let sizes = pair.sizes.map(plain);
        let sizes = if is_whole {
            format!("teeth {}, {}", sizes[0], sizes[1])
        } else {
            format!("radii {}{unit}, {}{unit}", sizes[0], sizes[1])
        };
        let _ = writeln!(text, "    {word} {first}, {second} on {arm} {sizes};");
    }
}
