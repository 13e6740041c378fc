//! The items that joints and links become.

use super::drawing::{DRAWN_APART, Drawing, nominal};
use super::driven_angles::check_angle;
use super::inventory::closed_joint;
use super::linkage::{FRAME, Linkage, is_spatial};
use super::locations::{self, angle, angle_of_line, drawn_angle, point, position};
use super::nodes::{call, difference, equation, negative, number, sum};
use super::order::{AngleOf, Step, plan};
use super::printed::rounded;
use super::rigid_bodies::Bodies;
use super::sheet::Sheet;
use super::slides::{
    along, drawn_direction, drawn_in_slot, drawn_position, guide, leads_on, point_in_slot,
    slot_angle, slot_on_body, start_item, start_joint,
};
use super::{
    curved_slots, drawn_faults, frame_faults, mechanics, mixed_coordinates, space,
    undeclared_inputs, wheels, written_measures,
};
use crate::diagnostic::Diagnostics;
use crate::model::types::Function;
use crate::syntax::{
    Expr, Item, ItemName, LinkLoop, MechanismDef, NamedItem, ParamItem, Toleranced, UnknownItem,
};

/// Returns the items that joints and links stand for.
pub(super) fn items(
    definition: &MechanismDef,
    linkage: &Linkage,
    bodies: &Bodies,
    drawing: &Drawing,
    diagnostics: &mut Diagnostics,
) -> Vec<Item> {
    mixed_coordinates::report(linkage, diagnostics);
    if diagnostics.is_empty() {
        written_measures::report(definition, linkage, drawing, diagnostics);
        undeclared_inputs::report(definition, linkage, drawing, diagnostics);
    }
    frame_faults::report_missing_frame(linkage, diagnostics);
    if !diagnostics.is_empty() {
        return Vec::new();
    }
    if is_spatial(linkage) {
        let fixed = fixed_joints(linkage, &linkage.links[FRAME].joints, drawing, diagnostics);
        return space::items(linkage, drawing, fixed, diagnostics);
    }
    refuse_axes(linkage, diagnostics);
    let plan = plan(linkage, bodies, diagnostics);
    let sheet = Sheet {
        linkage,
        bodies,
        drawing,
        plan: &plan,
    };
    if !diagnostics.is_empty() {
        return Vec::new();
    }
    drawn_faults::report(&sheet, diagnostics);
    let mut items = fixed_joints(linkage, &bodies.list[FRAME].joints, drawing, diagnostics);
    items.extend(angles_of_the_frame(&sheet));
    items.extend(locations::items(linkage, bodies, drawing, diagnostics));
    let sliders = linkage.sliders.iter();
    items.extend(sliders.filter_map(|slider| start_item(slider, drawing)));
    for step in &plan.steps {
        write_step(&sheet, step, &mut items, diagnostics);
    }
    items.extend(wheels::items(&sheet));
    items.extend(mechanics::items(definition, &sheet));
    items.extend(curved_slots::items(&sheet));
    items
}

/// Returns the joints of the frame: parameters, or derived quantities if they depend on others.
fn fixed_joints(
    linkage: &Linkage,
    fixed: &[usize],
    drawing: &Drawing,
    diagnostics: &mut Diagnostics,
) -> Vec<Item> {
    let mut items = Vec::new();
    for (index, joint) in linkage.joints.iter().enumerate() {
        let Some(drawn) = joint.drawn else { continue };
        let name = ItemName::from(joint.name.clone());
        if !fixed.contains(&index) {
            if has_tolerance(drawn) {
                let fact = format!("the joint `{name}` moves, and is only drawn here");
                let help = "give the tolerance to a link: `length 50mm +- 0.1mm`";
                diagnostics.error_with_help((&joint.name).into(), fact, help);
            }
            continue;
        }
        items.push(if drawing.is_constant(&nominal(drawn)) {
            Item::Param(ParamItem {
                attributes: Vec::new(),
                name,
                value: drawn.clone(),
            })
        } else {
            let value = nominal(drawn);
            Item::Let(NamedItem { name, value })
        });
    }
    items
}

/// Returns the angles of links that are welded to the frame.
fn angles_of_the_frame(sheet: &Sheet) -> Vec<Item> {
    let linkage = sheet.linkage;
    let links = sheet.bodies.list[FRAME].links.iter();
    links
        .filter(|link| **link != FRAME)
        .filter_map(|link| {
            let name = &linkage.links[*link].name;
            Some(Item::Let(NamedItem {
                name: ItemName::of_link(name.clone(), super::nodes::ident("angle", name.span())),
                value: drawn_angle(linkage, *link, sheet.drawing)?,
            }))
        })
        .collect()
}

/// Reports axes of hinges, which all have one direction in the plane.
fn refuse_axes(linkage: &Linkage, diagnostics: &mut Diagnostics) {
    for link in linkage.links.iter().filter(|link| link.about.is_some()) {
        let fact = format!(
            "the link `{}` turns about an axis, but is drawn in the plane",
            link.name
        );
        let help = "leave `about` out, or draw all joints with three coordinates";
        diagnostics.error_with_help((&link.name).into(), fact, help);
    }
}

fn has_tolerance(value: &Toleranced) -> bool {
    match value {
        Toleranced::Single { tolerance, .. } => tolerance.is_some(),
        Toleranced::Components { .. } => true,
    }
}

fn write_step(sheet: &Sheet, step: &Step, items: &mut Vec<Item>, diagnostics: &mut Diagnostics) {
    let Sheet {
        linkage,
        bodies,
        drawing,
        ..
    } = *sheet;
    match step {
        Step::Reach {
            body,
            from,
            angle,
            slot,
            new,
        } => {
            write_angles(sheet, *body, angle, items, diagnostics);
            if let Some(slider) = slot {
                write_position(sheet, *slider, items, diagnostics);
                let slider = &linkage.sliders[*slider];
                let along = along(linkage, bodies, slider, drawing);
                let value = difference(point(linkage, slider.pin), along);
                items.push(let_joint(linkage, *from, value));
            }
            for joint in new {
                let from = (*from, point(linkage, *from));
                let value = position(linkage, &bodies.list[*body], from, *joint);
                items.push(let_joint(linkage, *joint, value));
            }
        }
        Step::Close { body, from, joint } => {
            let from = (*from, point(linkage, *from));
            let value = position(linkage, &bodies.list[*body], from, *joint);
            let lead = bodies.list[*body].lead();
            let of = closed_joint(linkage, lead, &bodies.list[*body].joints, *joint);
            let link = &linkage.links[lead].name;
            items.push(equation(point(linkage, *joint), value, of, link.into()));
        }
        Step::PlacePin { slider } => {
            write_position(sheet, *slider, items, diagnostics);
            let slider = &linkage.sliders[*slider];
            let value = point_in_slot(linkage, bodies, slider, drawing);
            items.push(let_joint(linkage, slider.pin, value));
        }
        Step::CloseSlide { slider } => {
            write_position(sheet, *slider, items, diagnostics);
            let slider = &linkage.sliders[*slider];
            let value = point_in_slot(linkage, bodies, slider, drawing);
            let span = (&slider.name).into();
            let of = LinkLoop::Slider(slider.name.to_string());
            items.push(equation(point(linkage, slider.pin), value, of, span));
        }
        Step::Follow { slider } => {
            let slider = &linkage.sliders[*slider];
            let unit = call(
                Function::Dir,
                vec![slot_angle(linkage, bodies, slider, drawing)],
            );
            let Some(start) = start_joint(slider) else {
                return;
            };
            let vector = difference(point(linkage, slider.pin), point(linkage, start));
            items.push(Item::Let(NamedItem {
                name: slider.name.clone().into(),
                value: call(Function::Dot, vec![vector, unit]),
            }));
        }
    }
}

/// Writes the angle of each link of a body.
fn write_angles(
    sheet: &Sheet,
    body: usize,
    angle_of: &AngleOf,
    items: &mut Vec<Item>,
    diagnostics: &mut Diagnostics,
) {
    let Sheet {
        linkage, drawing, ..
    } = *sheet;
    let body = &sheet.bodies.list[body];
    let lead = body.lead();
    let name = &linkage.links[lead].name;
    let named = |link: usize| {
        let link = &linkage.links[link].name;
        ItemName::of_link(link.clone(), super::nodes::ident("angle", link.span()))
    };
    let drawn = |link: usize| drawn_angle(linkage, link, drawing);
    let between = |link: usize| match (drawn(link), drawn(lead)) {
        (Some(link), Some(lead)) => Some(difference(link, lead)),
        _ => None,
    };
    let value = match angle_of {
        AngleOf::Unknown => None,
        AngleOf::Given { link } => {
            let at = linkage.links[*link].at.cloned();
            let at = at.unwrap_or_else(|| Expr::error(name.into()));
            if linkage.links[*link].joints.len() > 1 {
                check_angle(sheet, *link, &at, diagnostics);
            }
            Some(match between(*link).filter(|_| *link != lead) {
                Some(turned) => difference(at, turned),
                None => at,
            })
        }
        AngleOf::Block { slider } => Some(angle_of_block(sheet, lead, *slider)),
        AngleOf::Pins { sliders } => Some(angle_by_pins(sheet, lead, *sliders)),
    };
    let needs_angle = body.joints.len() > 1
        || !matches!(angle_of, AngleOf::Unknown)
        || sheet.turns_by_wheels(lead);
    items.push(match value {
        Some(value) => Item::Let(NamedItem {
            name: named(lead),
            value,
        }),
        None if !needs_angle => {
            let fact = format!("the link `{name}` has one joint, and nothing gives its direction");
            let help = "name a second joint, or `at` an angle";
            diagnostics.error_with_help(name.into(), fact, help);
            return;
        }
        None => Item::Unknown(UnknownItem {
            name: named(lead),
            estimate: drawn(lead),
        }),
    });
    for &link in &body.links[1..] {
        if let Some(turned) = between(link) {
            items.push(Item::Let(NamedItem {
                name: named(link),
                value: sum(angle(linkage, lead), turned),
            }));
        }
    }
}

/// Returns the angle of a block by that of its slot, or the other way round.
fn angle_of_block(sheet: &Sheet, lead: usize, slider: usize) -> Expr {
    let Sheet {
        linkage,
        bodies,
        drawing,
        ..
    } = *sheet;
    let slider = &linkage.sliders[slider];
    let slot = guide(bodies, slider);
    let (reached, drawn) = if slot == bodies.of_link[lead] {
        let block = slider.block.expect("it has a block");
        let block = bodies.list[bodies.of_link[block]].lead();
        (angle(linkage, block), drawn_angle(linkage, block, drawing))
    } else {
        (
            slot_angle(linkage, bodies, slider, drawing),
            drawn_direction(slider, drawing),
        )
    };
    // A block of one joint has the direction of its slot.
    let is_point = linkage.links[lead].joints.len() < 2;
    match (drawn_angle(linkage, lead, drawing), drawn) {
        (Some(block), Some(drawn)) if !is_point => sum(reached, difference(block, drawn)),
        _ => reached,
    }
}

/// Returns the angle of a body with two pins in one slot, or of that with the slot.
fn angle_by_pins(sheet: &Sheet, lead: usize, sliders: [usize; 2]) -> Expr {
    let Sheet {
        linkage,
        bodies,
        drawing,
        ..
    } = *sheet;
    let [one, other] = sliders.map(|slider| &linkage.sliders[slider]);
    let pins = [one.pin, other.pin];
    let turning_body = bodies.of_link[lead];
    let half_turn =
        (!leads_on(one, other, drawing)).then(|| number("180", "deg", (&one.name).into()));
    let (reached, turned) = if guide(bodies, one) == turning_body {
        let holds =
            |body: &&super::rigid_bodies::Body| pins.iter().all(|pin| body.joints.contains(pin));
        let mut others = bodies.list.iter();
        let holder = others.find(holds).expect("the pins are on one body");
        let reached = if std::ptr::eq(holder, &raw const bodies.list[FRAME]) {
            let [first, second] = pins.map(|pin| point(linkage, pin));
            call(Function::Angle, vec![difference(second, first)])
        } else {
            let turning = angle(linkage, holder.lead());
            match angle_of_line(linkage, holder, pins) {
                Some(turned) => sum(turning, turned),
                None => turning,
            }
        };
        let line = slot_on_body(linkage, bodies, one, drawing);
        (reached, line)
    } else {
        let reached = slot_angle(linkage, bodies, one, drawing);
        (
            reached,
            angle_of_line(linkage, &bodies.list[turning_body], pins),
        )
    };
    let turned = turned.map(negative);
    [turned, half_turn].into_iter().flatten().fold(reached, sum)
}

/// Writes the position of a slider along its slot.
fn write_position(
    sheet: &Sheet,
    slider: usize,
    items: &mut Vec<Item>,
    diagnostics: &mut Diagnostics,
) {
    let slider = &sheet.linkage.sliders[slider];
    let drawn = drawn_position(slider, sheet.drawing);
    let name = ItemName::from(slider.name.clone());
    items.push(match slider.at {
        None => Item::Unknown(UnknownItem {
            name,
            estimate: drawn,
        }),
        Some(at) => {
            let drawing = sheet.drawing;
            let reference = drawing.number(&drawing.at_reference(at));
            let drawn = drawn_in_slot(slider, drawing).map(|[along, _]| along);
            if let (Some(reference), Some(drawn)) = (reference, drawn)
                && (reference - drawn).abs() > DRAWN_APART * reference.abs().max(drawn.abs())
            {
                let fact = format!(
                    "`{}` is drawn {} mm along its slot, but is {} mm there at the reference of its input",
                    slider.name,
                    rounded(drawn * 1e3),
                    rounded(reference * 1e3)
                );
                let help = "draw it there, or change the reference";
                diagnostics.error_with_help((&slider.name).into(), fact, help);
            }
            let value = at.clone();
            Item::Let(NamedItem { name, value })
        }
    });
}

fn let_joint(linkage: &Linkage, joint: usize, value: Expr) -> Item {
    let name = linkage.joints[joint].name.clone().into();
    Item::Let(NamedItem { name, value })
}
