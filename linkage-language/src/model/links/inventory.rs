//! The inventory of joints and links for messages: numbers of links and joints, and the names that
//! unknowns stand for.

use std::collections::{BTreeMap, BTreeSet};

use super::drawing::Drawing;
use super::linkage::{FRAME, Linkage, is_fixed, is_spatial};
use super::locations::is_cylinder;
use super::reaction_hints::reaction_hints;
use super::rigid_bodies::Bodies;
use crate::syntax::{Item, JointCount, LinkInventory, LinkLoop};

/// Returns the inventory of a linkage, which stands for these items.
pub(super) fn inventory(
    linkage: &Linkage,
    bodies: &Bodies,
    drawing: &Drawing,
    items: &[Item],
) -> LinkInventory {
    let spatial = is_spatial(linkage);
    let cylinders = cylinders(linkage, drawing);
    let (links, mut joints) = if spatial {
        (linkage.links.len(), joints_of_space(linkage))
    } else {
        let arcs = linkage.links.iter().filter(|link| link.is_arc()).count();
        (bodies.list.len() - arcs, joints_of_plane(linkage, bodies))
    };
    joints.push(JointCount {
        noun: "telescopic joint",
        count: cylinders.len(),
        held: if spatial { 5 } else { 2 },
    });
    joints.retain(|kind| kind.count > 0);
    let rods = linkage.links[FRAME + 1..].iter();
    let rods = rods.filter(|link| link.about.is_none() && link.joints.len() == 2);
    LinkInventory {
        spatial,
        bodies: links + cylinders.len(),
        joints,
        idle: if spatial { rods.count() } else { 0 },
        driven: driven(linkage, cylinders),
        moved: moved(linkage),
        members: members(linkage),
        pivots: pivots(linkage),
        reactions: reaction_hints(linkage, drawing, items),
        drawn_lengths: drawn_lengths(linkage, drawing),
    }
}

/// Returns the links whose length is an input or computed.
fn cylinders(linkage: &Linkage, drawing: &Drawing) -> Vec<String> {
    let links = linkage.links.iter();
    let computed = links.filter(|link| is_cylinder(link, drawing));
    computed.map(|link| link.name.to_string()).collect()
}

fn joints_of_plane(linkage: &Linkage, bodies: &Bodies) -> Vec<JointCount> {
    let pins = (0..linkage.joints.len()).map(|joint| {
        let holders = bodies.list.iter();
        // The arc of a curved slot is no body.
        let holders = holders
            .filter(|body| !linkage.links[body.lead()].is_arc() && body.joints.contains(&joint));
        let on_frame = is_fixed(linkage, joint) && !bodies.list[FRAME].joints.contains(&joint);
        (holders.count() + usize::from(on_frame)).saturating_sub(1)
    });
    let (blocks, pins_in_slots): (Vec<_>, Vec<_>) = linkage
        .sliders
        .iter()
        .partition(|slider| slider.block.is_some());
    let arcs = linkage.links.iter().filter(|link| link.is_arc()).count();
    let count = |noun, count, held| JointCount { noun, count, held };
    let (gears, belts): (Vec<_>, Vec<_>) = linkage.wheels.iter().partition(|pair| pair.reverses);
    vec![
        count("pin", pins.sum(), 2),
        count("sliding block", blocks.len(), 2),
        count("sliding pin", pins_in_slots.len() + arcs, 1),
        count("gear pair", gears.len(), 1),
        count("belt", belts.len(), 1),
    ]
}

fn joints_of_space(linkage: &Linkage) -> Vec<JointCount> {
    let hinges = linkage.links.iter().filter(|link| link.about.is_some());
    let hinges = hinges.count();
    let ends = (0..linkage.joints.len()).map(|joint| {
        let holders = linkage.links.iter();
        let holders = holders.filter(|link| link.joints.contains(&joint)).count();
        let on_frame = is_fixed(linkage, joint) && !linkage.links[FRAME].joints.contains(&joint);
        (holders + usize::from(on_frame)).saturating_sub(1)
    });
    let ends: usize = ends.sum();
    let count = |noun, count, held| JointCount { noun, count, held };
    vec![
        count("hinge", hinges, 5),
        count("ball joint", ends.saturating_sub(hinges), 3),
    ]
}

/// Returns the links and sliders whose motion is given, cylinders among them.
fn driven(linkage: &Linkage, cylinders: Vec<String>) -> Vec<String> {
    let links = linkage.links.iter().filter(|link| link.at.is_some());
    let links = links.map(|link| link.name.to_string());
    let sliders = linkage.sliders.iter().filter(|slider| slider.at.is_some());
    let sliders = sliders.map(|slider| slider.name.to_string());
    links.chain(cylinders).chain(sliders).collect()
}

/// Returns the names of links, sliders and joints that unknowns can have, with their kinds.
fn moved(linkage: &Linkage) -> BTreeMap<String, String> {
    let links = linkage.links[FRAME + 1..].iter().map(|link| {
        let kind = if link.is_arc() { "slider " } else { "" };
        (link.name.to_string(), format!("{kind}`{}`", link.name))
    });
    let sliders = linkage.sliders.iter().map(|slider| {
        let name = slider.name.to_string();
        let text = format!("slider `{name}`");
        (name, text)
    });
    let joints = linkage.joints.iter().filter(|joint| joint.drawn.is_some());
    let joints = joints.map(|joint| {
        let name = joint.name.to_string();
        let text = format!("joint `{name}`");
        (name, text)
    });
    joints.chain(sliders).chain(links).collect()
}

/// Returns the joints of each link.
fn members(linkage: &Linkage) -> BTreeMap<String, Vec<String>> {
    let links = linkage.links.iter();
    let links = links.map(|link| {
        let joints = link.joints.iter();
        let joints = joints.map(|joint| linkage.joints[*joint].name.to_string());
        (link.name.to_string(), joints.collect())
    });
    links.collect()
}

/// Returns the joints of links that have no other one.
fn pivots(linkage: &Linkage) -> BTreeSet<String> {
    let links = linkage.links[FRAME + 1..].iter();
    let pivots = links.filter_map(|link| match link.joints[..] {
        [joint] => Some(linkage.joints[joint].name.to_string()),
        _ => None,
    });
    pivots.collect()
}

/// Returns the drawn distance in metres for each length that is given otherwise.
fn drawn_lengths(linkage: &Linkage, drawing: &Drawing) -> BTreeMap<String, f64> {
    let links = linkage.links.iter().filter(|link| link.length.is_some());
    let lengths = links.filter_map(|link| {
        let [first, second, ..] = link.joints[..] else {
            return None;
        };
        let drawn = drawing.distance(first, second)?;
        Some((format!("{}.{}", link.name, link.length_word), drawn))
    });
    lengths.collect()
}

/// Returns the joint in which a link closes a loop. `joints` are those of its body.
pub(super) fn closed_joint(
    linkage: &Linkage,
    link: usize,
    joints: &[usize],
    joint: usize,
) -> LinkLoop {
    let link = &linkage.links[link];
    if link.is_arc() {
        return LinkLoop::Slider(link.name.to_string());
    }
    let named = |joint: usize| linkage.joints[joint].name.to_string();
    LinkLoop::Joint {
        link: link.name.to_string(),
        joint: named(joint),
        ends: match joints {
            [first, second] => Some([*first, *second].map(named)),
            _ => None,
        },
    }
}
