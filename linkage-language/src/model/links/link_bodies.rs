//! Links as bodies of the mechanics: their names and masses, and the bodies that joints are on. A
//! cylinder is two bodies.

use proc_macro2::Ident;

use super::locations::{angle, is_cylinder};
use super::nodes::ident;
use super::order::Step;
use super::sheet::Sheet;
use crate::syntax::{BodyItem, InertiaPart, Item, JointPart, MassPart};

/// Returns the name of a body.
pub(super) fn body_name<'s>(sheet: &'s Sheet, body: usize) -> &'s Ident {
    &sheet.linkage.links[sheet.bodies.list[body].lead()].name
}

/// Returns a body in a joint, with the masses of its links.
pub(super) fn body_item(sheet: &Sheet, body: usize, joint: JointPart) -> Item {
    let links = || {
        let links = sheet.bodies.list[body].links.iter();
        links.map(|link| &sheet.linkage.links[*link])
    };
    let masses = links().flat_map(|link| link.masses).map(copy_mass);
    let inertias = links().flat_map(|link| link.inertias).map(copy_inertia);
    let lead = sheet.bodies.list[body].lead();
    Item::Body(BodyItem {
        name: body_name(sheet, body).clone(),
        joint,
        turns: Some(angle(sheet.linkage, lead)),
        masses: masses.collect(),
        inertias: inertias.collect(),
    })
}

fn copy_mass(part: &MassPart) -> MassPart {
    MassPart {
        mass: part.mass.clone(),
        at: part.at.clone(),
    }
}

fn copy_inertia(part: &InertiaPart) -> InertiaPart {
    InertiaPart {
        inertia: part.inertia.clone(),
        at: part.at.clone(),
    }
}

/// Returns the joint at which a cylinder ends, if the body is one.
pub(super) fn sliding_end(sheet: &Sheet, body: usize, from: usize) -> Option<usize> {
    let link = &sheet.linkage.links[sheet.bodies.list[body].lead()];
    let [first, second] = sheet.bodies.list[body].joints[..] else {
        return None;
    };
    let end = if from == first { second } else { first };
    is_cylinder(link, sheet.drawing).then_some(end)
}

/// Returns the body that a joint of a body is fixed on: the rod, if the body is a cylinder.
pub(super) fn end_of(sheet: &Sheet, body: usize, joint: usize) -> Ident {
    let mut steps = sheet.plan.steps.iter();
    let from = steps.find_map(|step| match step {
        Step::Reach {
            body: reached,
            from,
            ..
        } if *reached == body => Some(*from),
        _ => None,
    });
    let name = body_name(sheet, body).clone();
    match from.and_then(|from| sliding_end(sheet, body, from)) {
        Some(end) if end == joint => rod_name(&name),
        _ => name,
    }
}

/// Returns the name of the rod of a cylinder.
pub(super) fn rod_name(cylinder: &Ident) -> Ident {
    ident(&format!("{cylinder}_rod"), cylinder.span())
}
