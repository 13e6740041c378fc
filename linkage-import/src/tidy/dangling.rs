//! Links that are held at one joint at most, and that nothing drives: their motion is free.

use crate::document::{Document, FRAME, InputKind, SlotPath};
use crate::names::shown;

use super::unused::{drop_short_links, drop_unused_joints};

/// Leaves out links with a free motion, and then those that only they held.
pub(crate) fn drop_dangling_links(document: &mut Document) {
    // Without an input every motion is free.
    if document.inputs.is_empty() {
        return;
    }
    let mut dropped = Vec::new();
    while let Some(link) = dangling_link(document) {
        let held_at = held_joints(document, link);
        let reason = match held_at.first() {
            Some(joint) => format!(
                "is held only at the joint `{}`",
                shown(&document.joints[*joint].name)
            ),
            None => "is held at no joint".to_owned(),
        };
        dropped.push(format!(
            "the link `{}` {reason}, so that its motion is free: it is left out",
            shown(&document.links[link].name)
        ));
        document.links[link].joints.clear();
        document.links[link].mass = None;
    }
    if dropped.is_empty() {
        return;
    }
    document.warnings.extend(dropped);
    drop_short_links(document);
    drop_unused_joints(document);
}

fn dangling_link(document: &Document) -> Option<usize> {
    let is_driven = |link: usize| {
        document.inputs.iter().any(|input| match input.kind {
            InputKind::Crank {
                link: turned, base, ..
            } => [turned, base].contains(&link),
            InputKind::Length { link: cylinder } => cylinder == link,
            InputKind::Position { .. } => false,
        })
    };
    let is_wheel = |link: usize| {
        let mut pairs = document.gears.iter();
        pairs.any(|pair| pair.wheels.contains(&link) || pair.arm == link)
    };
    let is_guided = |link: usize| {
        let mut slots = document.slots.iter();
        slots.any(|slot| slot.guide == link || slot.block == Some(link))
    };
    (FRAME + 1..document.links.len()).find(|link| {
        let is_there = document.links[*link].joints.len() > 1;
        is_there
            && !is_driven(*link)
            && !is_wheel(*link)
            && !is_guided(*link)
            && held_joints(document, *link).len() < 2
    })
}

/// Returns the joints of a link that another link or a slot has, too.
fn held_joints(document: &Document, link: usize) -> Vec<usize> {
    let is_held = |joint: &usize| {
        let mut slots = document.slots.iter();
        let is_in_slot = slots.any(|slot| {
            slot.pin == *joint
                || match slot.path {
                    SlotPath::Joints(first, second) => [first, second].contains(joint),
                    SlotPath::Arc { centre, .. } => centre == *joint,
                    SlotPath::Direction(..) => false,
                }
        });
        is_in_slot || document.links_of(*joint).iter().any(|other| *other != link)
    };
    let joints = document.links[link].joints.iter().copied();
    joints.filter(is_held).collect()
}
