//! Inputs: their values in the drawing, and ranges in which the mechanism stays together.

use crate::document::{Document, InputKind, SlotPath};
use crate::driven_motions::{DrivenMotion, driven_motions};
use crate::mobility;
use crate::number::plain;
use crate::wrapped::comment;

use super::drive::{Drive, inside, line, rounded};
use super::motors::{crank, following};
use super::spelling::Spelling;

/// The range to each side of the drawing that is written where none is known, as a part of the size.
const SMALL_PART: f64 = 0.05;

/// Returns the inputs, with warnings about those that cannot move.
pub(super) fn drives(document: &mut Document, spelling: &Spelling) -> Vec<Drive> {
    let ranges = mobility::ranges(document);
    if ranges.is_none() {
        explain(document);
    }
    let mut drives = Vec::new();
    for (number, motion) in driven_motions(document).iter().enumerate() {
        let range = ranges.as_ref().map(|ranges| ranges[number]);
        if range.is_some_and(|[low, high]| high - low < 1e-6) {
            document.warnings.push(format!(
                "`{}` cannot move from the drawing, or only by very little: set its range",
                spelling.inputs[motion.leader]
            ));
        }
        let leader = single(document, spelling, motion, range);
        for (follower, _) in &motion.followers {
            let follower = *follower;
            let drive = following(document, spelling, follower, motion, &leader);
            drives.extend(drive.map(|drive| (follower, drive)));
        }
        drives.push((motion.leader, leader));
    }
    drives.sort_by_key(|(index, _)| *index);
    drives.into_iter().map(|(_, drive)| drive).collect()
}

/// Adds comments about motors that run together, and about inputs that run by no speed.
pub(super) fn together(document: &Document, drives: &[Drive], text: &mut String) {
    let motions = driven_motions(document);
    if motions.len() < drives.len() {
        let words = "The motors run together, as in the file. To drive one of them alone, write it \
                     as an input.";
        comment(text, "    // ", words);
    }
    let has_speed = |motion: &&DrivenMotion| document.inputs[motion.leader].rate.is_some();
    if drives.len() > 1 && motions.iter().filter(has_speed).count() < motions.len() {
        let words = "Inputs without a rate move to and fro, or as the user of the program moves \
                     them: they are no functions of the time of the others.";
        comment(text, "    // ", words);
    }
}

/// An input, with the range of its motion.
fn single(
    document: &Document,
    spelling: &Spelling,
    motion: &DrivenMotion,
    range: Option<[f64; 2]>,
) -> Drive {
    let index = motion.leader;
    match document.inputs[index].kind {
        InputKind::Crank { link, pivot, base } => {
            crank(document, spelling, motion, [link, pivot, base], range)
        }
        InputKind::Length { link } => {
            let joints = &document.links[link].joints;
            let length = document.distance(joints[0], joints[1]);
            let ends = [joints[0], joints[1]].map(|joint| spelling.joints[joint].clone());
            let about = format!("the distance of {} and {}", ends[0], ends[1]);
            linear(document, spelling, index, length, range, &about)
        }
        InputKind::Position { slot } => {
            let position = position(document, slot);
            let pin = &spelling.joints[document.slots[slot].pin];
            let about = format!("the position of {pin} in its slot");
            linear(document, spelling, index, position, range, &about)
        }
    }
}

/// A warning for drawings whose mobility is not the number of their inputs.
fn explain(document: &mut Document) {
    let kinds: Vec<InputKind> = document.inputs.iter().map(|input| input.kind).collect();
    let warning = match mobility::mobility(document, &[]) {
        Some(0) => "nothing can move in the drawing: ranges of inputs are not known".to_owned(),
        Some(free) if free != kinds.len() => format!(
            "the drawing has the mobility {free} and {} inputs: ranges are not known",
            kinds.len()
        ),
        Some(_) => "the inputs do not determine the drawing, or it is at a dead point: ranges are \
                    not known"
            .to_owned(),
        None => "the drawing is too large for a search of ranges".to_owned(),
    };
    document.warnings.push(warning);
}

fn position(document: &Document, slot: usize) -> f64 {
    let slot = &document.slots[slot];
    match slot.path {
        SlotPath::Joints(first, second) => {
            let direction = document.direction(first, second);
            let to_pin = document.direction(first, slot.pin);
            document.distance(first, slot.pin) * (to_pin - direction).cos()
        }
        SlotPath::Direction(..) | SlotPath::Arc { .. } => 0.0,
    }
}

fn linear(
    document: &Document,
    spelling: &Spelling,
    index: usize,
    reference: f64,
    range: Option<[f64; 2]>,
    about: &str,
) -> Drive {
    let name = spelling.inputs[index].clone();
    let size = document.largest_distance().map_or(1.0, |largest| largest.2);
    let reference = rounded(reference, 1e-14 * size.max(1e-3));
    let (low, high) = match range {
        Some([low, high]) if high - low > 1e-9 * size => {
            let quantum = 10f64.powf(((high - low) * 1e-3).log10().floor());
            inside(reference + low, reference + high, reference, quantum)
        }
        _ => (reference - SMALL_PART * size, reference + SMALL_PART * size),
    };
    let unit = document.unit.name();
    let line = line(document, index, &name, [reference, low, high], unit, about);
    Drive {
        clause: name.clone(),
        name,
        line,
        kind: document.inputs[index].kind,
        leader: None,
        target: None,
        value: format!("{}{unit}", plain(reference)),
    }
}
