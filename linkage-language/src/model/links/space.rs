//! Joints and links of space: hinges, and links that ball joints hold.

use super::ball_links::{write_body, write_rod};
use super::drawing::Drawing;
use super::linkage::{FRAME, Linkage};
use super::locations::{angle, point};
use super::nodes::{call, difference, ident, sum};
use super::space_progress::{Progress, on_link, put, vector_on_link};
use crate::diagnostic::Diagnostics;
use crate::model::types::Function;
use crate::syntax::{Item, ItemName, NamedItem, UnknownItem};

/// Returns the items of a linkage of space.
pub(super) fn items(
    linkage: &Linkage,
    drawing: &Drawing,
    fixed: Vec<Item>,
    diagnostics: &mut Diagnostics,
) -> Vec<Item> {
    refuse_items_of_the_plane(linkage, diagnostics);
    let mut progress = Progress {
        linkage,
        drawing,
        seats: vec![None; linkage.joints.len()],
        turns: vec![None; linkage.links.len()],
        items: fixed,
    };
    for (index, joint) in linkage.joints.iter().enumerate() {
        if joint.drawn.is_none() || linkage.links[FRAME].joints.contains(&index) {
            progress.seats[index] = Some(FRAME);
        }
    }
    progress.turns[FRAME] = Some(Vec::new());
    let mut open: Vec<usize> = (FRAME + 1..linkage.links.len()).collect();
    let hinged = |progress: &Progress, link: usize| {
        let item = &linkage.links[link];
        let seat = progress.seats[item.joints[0]];
        item.about.is_some() && seat.is_some_and(|seat| progress.turns[seat].is_some())
    };
    while let Some(next) = open.iter().position(|link| hinged(&progress, *link)) {
        write_hinge(&mut progress, open.remove(next), diagnostics);
    }
    // Ends of rods are points of bodies, so that a body on rods has no unknowns but its frame.
    open.sort_by_key(|link| linkage.links[*link].joints.len() < 3);
    for &link in &open {
        let item = &linkage.links[link];
        let name = &item.name;
        if item.about.is_some() || item.at.is_some() {
            let fact = format!("the hinge of the link `{name}` is in no joint that is reached");
            let help = "its first joint is on the hinge: let it be one of the frame or of a hinged \
                        link before, and give the axis by `about (0, 0, 1)`";
            diagnostics.error_with_help(name.into(), fact, help);
        } else if item.joints.len() < 2 {
            let fact = format!("the link `{name}` has one joint");
            let help = "name its other joints, or give its hinge an axis: `about (0, 0, 1)`";
            diagnostics.error_with_help(name.into(), fact, help);
        } else if item.joints.len() == 2 {
            write_rod(&mut progress, link, diagnostics);
        } else {
            write_body(&mut progress, link, diagnostics);
        }
    }
    progress.items
}

fn refuse_items_of_the_plane(linkage: &Linkage, diagnostics: &mut Diagnostics) {
    let sliders = linkage.sliders.iter().map(|slider| &slider.name);
    let wheels = linkage.wheels.iter().map(|pair| &pair.item.wheels[0]);
    let welds = linkage
        .welds
        .iter()
        .map(|pair| &linkage.links[pair[0]].name);
    for name in sliders.chain(wheels).chain(welds) {
        let fact = "sliders, gears, belts and welds belong to the plane";
        let help = "write them in space as a `loop`, beside joints and links";
        diagnostics.error_with_help(name.into(), fact, help);
    }
    for link in &linkage.links {
        if !link.masses.is_empty() || !link.inertias.is_empty() {
            let fact = "links of space have no masses";
            let help = format!(
                "write `body {} = ball on frame at ..., mass ...`",
                link.name
            );
            diagnostics.error_with_help((&link.name).into(), fact, help);
        }
    }
}

/// Writes a link that turns about an axis in its first joint.
fn write_hinge(progress: &mut Progress, link: usize, diagnostics: &mut Diagnostics) {
    let Progress {
        linkage, drawing, ..
    } = *progress;
    let item = &linkage.links[link];
    let origin = item.joints[0];
    let Some(axis) = item.about.cloned() else {
        return;
    };
    let components = drawing.components(&axis);
    if components.is_some_and(|axis| axis.iter().all(|component| *component == 0.0)) {
        let fact = format!(
            "the hinge of `{}` has no axis: `about` has no direction",
            item.name
        );
        let help = "write a direction such as `(0, 0, 1)`, of any length";
        diagnostics.error_with_help(axis.span, fact, help);
        return;
    }
    let turn = ItemName::of_link(item.name.clone(), ident("angle", item.name.span()));
    progress.items.push(match item.at {
        // The drawing shows the link at the reference.
        Some(at) => Item::Let(NamedItem {
            name: turn,
            value: difference(at.clone(), drawing.at_reference(at)),
        }),
        None => Item::Unknown(UnknownItem {
            name: turn,
            estimate: Some(super::nodes::number("0", "deg", (&item.name).into())),
        }),
    });
    let seat = progress.seats[origin].unwrap_or(FRAME);
    let mut turns = progress.turns[seat].clone().unwrap_or_default();
    turns.insert(0, (axis, angle(linkage, link)));
    for (index, &joint) in item.joints.iter().enumerate().skip(1) {
        let vector = vector_on_link(item, index, drawing.vector(origin, joint));
        let (parameter, vector) = on_link(linkage, link, joint, vector);
        progress.items.extend(parameter);
        let turned = turns.iter().fold(vector, |vector, (axis, angle)| {
            call(Function::Turn, vec![vector, axis.clone(), angle.clone()])
        });
        let position = sum(point(linkage, origin), turned);
        put(progress, link, joint, position);
    }
    progress.turns[link] = Some(turns);
}
