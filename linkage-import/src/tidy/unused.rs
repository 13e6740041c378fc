//! Links and joints that do not matter for the motion are left out, and indices follow.

use crate::document::{Document, FRAME, InputKind, SlotPath};
use crate::names::shown;

/// Leaves out links with less than two joints.
pub(super) fn drop_short_links(document: &mut Document) {
    let count = document.links.len();
    let mut indices: Vec<Option<usize>> = vec![None; count];
    let mut kept = Vec::new();
    for (index, link) in std::mem::take(&mut document.links).into_iter().enumerate() {
        if index == FRAME || link.joints.len() > 1 {
            indices[index] = Some(kept.len());
            kept.push(link);
        } else if let [joint] = link.joints[..] {
            let joint = shown(&document.joints[joint].name);
            let name = shown(&link.name);
            document.remarks.push(format!(
                "`{name}` has only the joint `{joint}` and does not matter for the motion."
            ));
        }
    }
    document.links = kept;
    let new = |index: usize| indices[index];
    document.gears.retain_mut(|pair| {
        let links = [pair.wheels[0], pair.wheels[1], pair.arm].map(new);
        if let [Some(first), Some(second), Some(arm)] = links {
            pair.wheels = [first, second];
            pair.arm = arm;
            return true;
        }
        false
    });
    for slot in &mut document.slots {
        slot.guide = new(slot.guide).unwrap_or(FRAME);
        slot.block = slot.block.and_then(new);
    }
    document.inputs.retain_mut(|input| match &mut input.kind {
        InputKind::Crank { link, base, .. } => {
            let links = [*link, *base].map(new);
            if let [Some(new_link), Some(new_base)] = links {
                *link = new_link;
                *base = new_base;
            }
            links.iter().all(Option::is_some)
        }
        InputKind::Length { link } => {
            let index = new(*link);
            *link = index.unwrap_or(FRAME);
            index.is_some()
        }
        InputKind::Position { .. } => true,
    });
}

/// Leaves out joints that no link and no slot has.
pub(super) fn drop_unused_joints(document: &mut Document) {
    let mut is_used = vec![false; document.joints.len()];
    for link in &document.links {
        link.joints.iter().for_each(|joint| is_used[*joint] = true);
    }
    for slot in &document.slots {
        is_used[slot.pin] = true;
        match slot.path {
            SlotPath::Joints(first, second) => {
                is_used[first] = true;
                is_used[second] = true;
            }
            SlotPath::Arc { centre, .. } => is_used[centre] = true,
            SlotPath::Direction(_, _, Some(through)) => is_used[through] = true,
            SlotPath::Direction(_, _, None) => {}
        }
    }
    let mut indices = vec![0; document.joints.len()];
    let mut kept = Vec::new();
    let mut unused = Vec::new();
    for (index, joint) in std::mem::take(&mut document.joints).into_iter().enumerate() {
        if is_used[index] {
            indices[index] = kept.len();
            kept.push(joint);
        } else if !joint.is_derived {
            unused.push(shown(&joint.name));
        }
    }
    document.joints = kept;
    if !unused.is_empty() {
        let unused = unused.join(", ");
        document
            .remarks
            .push(format!("No link has the joints {unused}: left out."));
    }
    let new = |joint: &mut usize| *joint = indices[*joint];
    for link in &mut document.links {
        link.joints.iter_mut().for_each(new);
        if let Some(mass) = &mut link.mass {
            new(&mut mass.centre);
        }
    }
    for slot in &mut document.slots {
        new(&mut slot.pin);
        match &mut slot.path {
            SlotPath::Joints(first, second) => {
                new(first);
                new(second);
            }
            SlotPath::Arc { centre, .. } => new(centre),
            SlotPath::Direction(_, _, through) => through.iter_mut().for_each(new),
        }
    }
    for input in &mut document.inputs {
        if let InputKind::Crank { pivot, .. } = &mut input.kind {
            new(pivot);
        }
    }
}
