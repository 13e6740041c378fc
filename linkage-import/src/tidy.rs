//! Drawings of other programs in the terms of the language: a link has two joints or more, and
//! links on two fixed points are parts of the frame.

use crate::document::{Document, FRAME, Input, InputKind, SlotPath};
use crate::names::shown;
use crate::number::rounded;

mod dangling;
mod unused;

pub(crate) use dangling::drop_dangling_links;
use unused::{drop_short_links, drop_unused_joints};

/// Brings a document into these terms, with a remark or a warning for each change.
pub(crate) fn tidy(document: &mut Document) {
    check_cylinders(document);
    loop {
        let held = held_links(document);
        if held.is_empty() {
            break;
        }
        held.into_iter().for_each(|link| fold(document, link));
    }
    check_slots(document);
    place_lines(document);
    hold_wheels(document);
    mark_wheels(document);
    drop_short_links(document);
    drop_unused_joints(document);
}

fn is_cylinder(document: &Document, link: usize) -> bool {
    let mut inputs = document.inputs.iter();
    inputs.any(|input| input.kind == InputKind::Length { link })
}

/// Leaves out cylinders between two fixed points, and those without a length.
fn check_cylinders(document: &mut Document) {
    let mut kept = Vec::new();
    for input in std::mem::take(&mut document.inputs) {
        let InputKind::Length { link } = input.kind else {
            kept.push(input);
            continue;
        };
        let ends = document.links[link].joints.clone();
        let is_held = ends.iter().all(|joint| document.is_fixed(*joint));
        let is_short = ends.len() != 2 || document.distance(ends[0], ends[1]) == 0.0;
        if is_held || is_short {
            let name = shown(&document.links[link].name);
            document
                .warnings
                .push(format!("the cylinder `{name}` cannot move and is left out"));
            document.links[link].joints.clear();
        } else {
            kept.push(input);
        }
    }
    document.inputs = kept;
}

/// Returns links with two fixed points at different positions.
fn held_links(document: &Document) -> Vec<usize> {
    let mut is_fixed = vec![false; document.joints.len()];
    let fixed = document.links[FRAME].joints.iter();
    fixed.for_each(|joint| is_fixed[*joint] = true);
    let is_held = |link: &usize| {
        let joints = document.links[*link].joints.iter().copied();
        let mut fixed = joints.filter(|joint| is_fixed[*joint]);
        let first = fixed.next();
        let is_apart = |first| fixed.any(|joint| document.distance(first, joint) > 0.0);
        first.is_some_and(is_apart) && !is_cylinder(document, *link)
    };
    (1..document.links.len()).filter(is_held).collect()
}

/// Makes a link a part of the frame.
fn fold(document: &mut Document, link: usize) {
    let name = shown(&document.links[link].name);
    document.remarks.push(format!(
        "`{name}` is held at two fixed points: a part of the frame."
    ));
    if document.links[link].mass.take().is_some() {
        document
            .remarks
            .push(format!("The mass of `{name}` does not move."));
    }
    for joint in std::mem::take(&mut document.links[link].joints) {
        document.attach(joint, FRAME);
    }
    let replaced = |index: &mut usize| {
        if *index == link {
            *index = FRAME;
        }
    };
    for slot in &mut document.slots {
        replaced(&mut slot.guide);
        slot.block.iter_mut().for_each(replaced);
    }
    for pair in &mut document.gears {
        pair.wheels
            .iter_mut()
            .chain([&mut pair.arm])
            .for_each(replaced);
    }
    let mut kept: Vec<Input> = Vec::new();
    for mut input in std::mem::take(&mut document.inputs) {
        if let InputKind::Crank { link, base, .. } = &mut input.kind {
            replaced(link);
            replaced(base);
            if link == base {
                document
                    .warnings
                    .push(format!("a motor turns `{name}`, which is held: left out"));
                continue;
            }
        }
        kept.push(input);
    }
    document.inputs = kept;
}

/// Leaves out slots whose pin is a joint of the guide, or lies on nothing.
fn check_slots(document: &mut Document) {
    let mut removed = Vec::new();
    for (index, slot) in document.slots.iter().enumerate() {
        let guide = &document.links[slot.guide];
        let is_short = match slot.path {
            SlotPath::Joints(first, second) => document.distance(first, second) == 0.0,
            SlotPath::Direction(..) => false,
            SlotPath::Arc { centre, .. } => document.distance(slot.pin, centre) == 0.0,
        };
        let is_lost = slot.guide != FRAME && guide.joints.is_empty();
        if guide.joints.contains(&slot.pin) || is_short || is_lost {
            let pin = shown(&document.joints[slot.pin].name);
            let guide = shown(&guide.name);
            document.warnings.push(format!(
                "the pin `{pin}` cannot slide on `{guide}`: the slot is left out"
            ));
            removed.push(index);
        }
    }
    let inputs = std::mem::take(&mut document.inputs);
    for mut input in inputs {
        if let InputKind::Position { slot } = &mut input.kind {
            if removed.contains(slot) {
                continue;
            }
            *slot -= removed.iter().filter(|index| **index < *slot).count();
        }
        document.inputs.push(input);
    }
    let mut index = 0;
    document.slots.retain(|_| {
        index += 1;
        !removed.contains(&(index - 1))
    });
    for slot in &mut document.slots {
        let guide = slot.guide;
        slot.block = slot
            .block
            .filter(|block| *block != guide && *block != FRAME);
    }
}

/// Gives moving guides a joint on the lines of their slots.
fn place_lines(document: &mut Document) {
    for index in 0..document.slots.len() {
        let (pin, guide) = (document.slots[index].pin, document.slots[index].guide);
        let SlotPath::Direction(_, _, through) = document.slots[index].path else {
            continue;
        };
        if guide == FRAME || through.is_some() {
            continue;
        }
        let name = format!("line_of_{}", document.joints[pin].name);
        let position = document.joints[pin].position;
        let joint = document.add_derived(name, position);
        document.attach(joint, guide);
        if let SlotPath::Direction(_, _, through) = &mut document.slots[index].path {
            *through = Some(joint);
        }
    }
}

/// A wheel that is fixed becomes a link that does not turn: the frame itself is no wheel.
fn hold_wheels(document: &mut Document) {
    let mut kept = Vec::new();
    for mut pair in std::mem::take(&mut document.gears) {
        let is_fixed = pair.wheels.map(|wheel| wheel == FRAME);
        if is_fixed == [false, false] {
            kept.push(pair);
            continue;
        }
        let mut joints = document.links[pair.arm].joints.iter();
        let pivot = joints.find(|joint| document.is_fixed(**joint)).copied();
        let (Some(pivot), true) = (pivot, is_fixed != [true, true] && pair.arm != FRAME) else {
            document
                .warnings
                .push("a pair of wheels cannot turn and is left out".to_owned());
            continue;
        };
        let name = format!("wheel_{}", document.joints[pivot].name);
        let link = document.add_link(name, vec![pivot]);
        document.links[link].is_held = true;
        let wheel = pair.wheels.iter_mut().find(|wheel| **wheel == FRAME);
        wheel.into_iter().for_each(|wheel| *wheel = link);
        kept.push(pair);
    }
    document.gears = kept;
}

/// Adds a point to wheels, cranks and guides that have only a pivot, so that they have a direction.
fn mark_wheels(document: &mut Document) {
    /// The part of the largest distance that the point is away.
    const PART: f64 = 0.1;
    let size = document.largest_distance().map_or(1.0, |largest| largest.2);
    let wheels = document.gears.iter().flat_map(|pair| pair.wheels);
    let cranks = document.inputs.iter().filter_map(|input| match input.kind {
        InputKind::Crank { link, .. } => Some(link),
        _ => None,
    });
    let bodies = document.slots.iter();
    let bodies = bodies
        .flat_map(|slot| [Some(slot.guide), slot.block])
        .flatten();
    let mut needing: Vec<usize> = wheels.chain(cranks).chain(bodies).collect();
    needing.sort_unstable();
    needing.dedup();
    for link in needing {
        let [pivot] = document.links[link].joints[..] else {
            continue;
        };
        if link == FRAME {
            continue;
        }
        let [x, y] = document.joints[pivot].position;
        let distance = if size > 0.0 { PART * size } else { 1.0 };
        let name = format!("mark_{}", document.links[link].name);
        let mark = document.add_derived(name, [rounded(x + distance, size * 1e-3), y]);
        document.attach(mark, link);
    }
}
