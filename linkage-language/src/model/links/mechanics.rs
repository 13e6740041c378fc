//! Links as bodies of the mechanics: masses, and the joints that forces pass through.

use std::collections::{BTreeMap, BTreeSet};

use super::bodies_on_slots;
use super::link_bodies::{body_item, body_name, end_of, rod_name, sliding_end};
use super::linkage::{FRAME, Linkage, Slider};
use super::locations::{angle, point};
use super::nodes::{call, ident};
use super::order::Step;
use super::rigid_bodies::Bodies;
use super::sheet::Sheet;
use super::slides::{guide, slot_angle};
use crate::model::types::{Function, MechanicsWord};
use crate::syntax::{
    Between, BodyItem, Expr, ExprKind, Item, JointItem, JointKind, JointPart, LinkedItem,
    MechanismDef, Member, Word,
};

/// Returns the bodies and joints of the mechanics, if the mechanism has masses, loads or forces.
pub(super) fn items(definition: &MechanismDef, sheet: &Sheet) -> Vec<Item> {
    if !has_forces(definition) {
        return Vec::new();
    }
    let mut taken = BTreeSet::new();
    let mut items = Vec::new();
    for step in &sheet.plan.steps {
        match step {
            Step::Reach {
                body,
                from,
                slot: None,
                ..
            } => items.extend(body_items(sheet, *body, *from, &mut taken)),
            Step::Reach {
                body,
                from,
                slot: Some(slider),
                ..
            } => {
                let slider = &sheet.linkage.sliders[*slider];
                items.extend(bodies_on_slots::items(
                    sheet, *body, *from, slider, &mut taken,
                ));
            }
            Step::Close { body, joint, .. } => {
                let end = end_of(sheet, *body, *joint);
                let joint = JointItem {
                    body: Member::from(&end),
                    joint: pin(sheet, *joint, *body, &mut taken),
                };
                items.push(Item::Joint(joint));
            }
            Step::CloseSlide { slider } | Step::Follow { slider } => {
                let slider = &sheet.linkage.sliders[*slider];
                let holder = match slider.block {
                    Some(link) => sheet.bodies.of_link[link],
                    None => sheet.plan.seats[slider.pin].unwrap_or(FRAME),
                };
                let mut body = Member::from(&end_of(sheet, holder, slider.pin));
                let mut joint = slot_joint(sheet, slider, &mut taken);
                // The first body of a joint moves: of a pin of the frame it is that with the slot.
                if holder == FRAME {
                    std::mem::swap(&mut body, &mut joint.on);
                }
                items.push(Item::Joint(JointItem { body, joint }));
            }
            // The body that begins at this pin has the joint.
            Step::PlacePin { .. } => {}
        }
    }
    items
}

/// Returns true if something asks for forces.
fn has_forces(definition: &MechanismDef) -> bool {
    let mut items = definition.items.iter();
    let loaded = items.any(|item| match item {
        Item::Gravity(_)
        | Item::Body(_)
        | Item::Joint(_)
        | Item::Force(_)
        | Item::Torque(_)
        | Item::Spring(_)
        | Item::Damper(_)
        | Item::Friction(_) => true,
        Item::Linked(LinkedItem::Link(link)) => {
            !link.masses.is_empty() || !link.inertias.is_empty()
        }
        Item::Linked(_)
        | Item::Unit(_)
        | Item::Const(_)
        | Item::Param(_)
        | Item::Input(_)
        | Item::Unknown(_)
        | Item::Let(_)
        | Item::Loop(_)
        | Item::Argument(_)
        | Item::Part(_)
        | Item::Arc(_) => false,
    });
    let functions = definition.functions.iter();
    let mut quantities = functions.flat_map(|function| &function.quantities);
    loaded || quantities.any(|quantity| calls_mechanics(&quantity.value))
}

fn calls_mechanics(expr: &Expr) -> bool {
    let is_asked = match &expr.kind {
        ExprKind::Call(function, _) => MechanicsWord::from_word(&function.to_string()).is_some(),
        _ => false,
    };
    is_asked || expr.operands().into_iter().any(calls_mechanics)
}

/// Returns a body that begins at a joint; of a link whose length changes, the other end slides in
/// the first one.
fn body_items(sheet: &Sheet, body: usize, from: usize, taken: &mut BTreeSet<String>) -> Vec<Item> {
    let name = body_name(sheet, body).clone();
    let sliders = sheet.linkage.sliders.iter();
    let joint = match sheet.plan.seats[from] {
        Some(seat) if seat != body => pin(sheet, from, body, taken),
        _ => {
            let mut sliders = sliders.filter(|slider| slider.pin == from);
            let slider = sliders
                .next()
                .expect("the slot gave the joint its position");
            slot_joint(sheet, slider, taken)
        }
    };
    let mut items = vec![body_item(sheet, body, joint)];
    if let Some(end) = sliding_end(sheet, body, from) {
        let lead = sheet.bodies.list[body].lead();
        let direction = call(Function::Dir, vec![angle(sheet.linkage, lead)]);
        items.push(Item::Body(BodyItem {
            name: rod_name(&name),
            joint: JointPart {
                kind: JointKind::Slide,
                name: None,
                on: Member::from(&name),
                at: point(sheet.linkage, end),
                direction: Some(direction),
                span: (&name).into(),
            },
            turns: None,
            masses: Vec::new(),
            inertias: Vec::new(),
        }));
    }
    items
}

/// Returns a pin in a joint, on the body that gave the joint its position.
fn pin(sheet: &Sheet, joint: usize, body: usize, taken: &mut BTreeSet<String>) -> JointPart {
    let name = &sheet.linkage.joints[joint].name;
    let seat = sheet.plan.seats[joint].unwrap_or(FRAME);
    let bodies = sheet.bodies.list.iter();
    let count = bodies.filter(|body| body.joints.contains(&joint)).count();
    // With more than two bodies, the name tells on which of them the force acts.
    let text = match count > 2 || taken.contains(&name.to_string()) {
        true => format!("{name}_{}", body_name(sheet, body)),
        false => name.to_string(),
    };
    taken.insert(text.clone());
    JointPart {
        kind: JointKind::Pin,
        name: Some(ident(&text, name.span())),
        on: Member::from(&end_of(sheet, seat, joint)),
        at: point(sheet.linkage, joint),
        direction: None,
        span: name.into(),
    }
}

/// Returns the joint of a slider: a block transmits a moment, a pin in a slot does not.
fn slot_joint(sheet: &Sheet, slider: &Slider, taken: &mut BTreeSet<String>) -> JointPart {
    let Sheet {
        linkage,
        bodies,
        drawing,
        ..
    } = *sheet;
    let name = slider.name.clone();
    taken.insert(name.to_string());
    let angle = slot_angle(linkage, bodies, slider, drawing);
    JointPart {
        kind: match slider.block {
            Some(_) => JointKind::Slide,
            None => JointKind::Roller,
        },
        span: (&name).into(),
        name: Some(name),
        on: Member::from(body_name(sheet, guide(bodies, slider))),
        at: point(linkage, slider.pin),
        direction: Some(call(Function::Dir, vec![angle])),
    }
}

/// Returns the links that have another name as bodies.
pub(super) fn renamed_bodies(linkage: &Linkage, bodies: &Bodies) -> BTreeMap<String, String> {
    let links = linkage.links.iter().zip(&bodies.of_link);
    links
        .map(|(link, body)| {
            let lead = &linkage.links[bodies.list[*body].lead()];
            (link.name.to_string(), lead.name.to_string())
        })
        .filter(|(link, lead)| link != lead)
        .collect()
}

/// Gives loads and bodies the names that links have as bodies.
pub(super) fn rename(definition: &mut MechanismDef, renamed: &BTreeMap<String, String>) {
    let rename = |member: &mut Member| {
        if let Some(lead) = renamed.get(&member.text) {
            member.text.clone_from(lead);
        }
    };
    for item in &mut definition.items {
        match item {
            Item::Force(load) | Item::Torque(load) => {
                rename(&mut load.on);
                load.from.as_mut().map(rename);
            }
            Item::Spring(element) | Item::Damper(element) => match &mut element.between {
                Between::Points(ends) => ends.iter_mut().for_each(|(member, _)| rename(member)),
                Between::Joint(joint) => rename(joint),
            },
            Item::Friction(friction) => rename(&mut friction.joint),
            Item::Body(body) => rename(&mut body.joint.on),
            Item::Joint(joint) => {
                rename(&mut joint.body);
                rename(&mut joint.joint.on);
            }
            Item::Part(part) => {
                part.on.as_mut().map(rename);
            }
            // These name no body.
            Item::Unit(_)
            | Item::Const(_)
            | Item::Param(_)
            | Item::Input(_)
            | Item::Unknown(_)
            | Item::Let(_)
            | Item::Loop(_)
            | Item::Argument(_)
            | Item::Gravity(_)
            | Item::Arc(_)
            | Item::Linked(_) => {}
        }
    }
}
