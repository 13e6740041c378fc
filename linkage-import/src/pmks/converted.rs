//! A drawing of a page as joints, links and slots.

use std::collections::BTreeMap;

use crate::document::{Document, FRAME, Input, InputKind, LengthUnit, Load, Mass, Slot, SlotPath};
use crate::error::ImportError;
use crate::names::shown;
use crate::number::plain;

use super::conversion::Assembly;
use super::cylinders;
use super::page_drawing::{Drawing, PageForce, PageJoint, PageLink};
use super::pounds::{POUND, POUND_INCHES, converted};

/// Half of a thousandth, the rounding of the page.
const BAND: f64 = 0.0005;

/// Returns the mechanism of a drawing.
pub(super) fn document(drawing: Drawing) -> Result<Document, ImportError> {
    let unit = drawing.unit.unwrap_or(LengthUnit::Centimetre);
    let mut document = Document::new("an address of PMKS+", unit);
    document.warnings.clone_from(&drawing.warnings);
    if !drawing.is_precise {
        document.band = BAND;
        document.remarks.push(format!(
            "The page rounds every number to 0.001 {}, and directions of slots to 0.001 rad.",
            unit.name()
        ));
    }
    let mut assembly = Assembly {
        drawing,
        document,
        joints: BTreeMap::new(),
        links: BTreeMap::new(),
    };
    joints(&mut assembly)?;
    links(&mut assembly)?;
    let slides: Vec<PageJoint> = assembly.drawing.joints.clone();
    for slide in slides.iter().filter(|joint| joint.is_slide) {
        if !cylinders::read(&mut assembly, slide)? {
            slot(&mut assembly, slide)?;
        }
    }
    motors(&mut assembly);
    masses(&mut assembly);
    forces(&mut assembly);
    Ok(assembly.document)
}

fn joints(assembly: &mut Assembly) -> Result<(), ImportError> {
    let all = assembly.drawing.joints.clone();
    // Pins of blocks stand for their slides, and the slide says whether the line is fixed.
    let pins: Vec<String> = all
        .iter()
        .filter(|joint| joint.is_slide)
        .filter_map(|slide| Some(assembly.pin(slide)?.id.clone()))
        .collect();
    for joint in &all {
        if joint.is_slide && assembly.pin(joint).is_some() {
            continue;
        }
        let name = if joint.name.is_empty() {
            &joint.id
        } else {
            &joint.name
        };
        let index = assembly.document.add_joint(name, joint.position);
        if assembly.joints.insert(joint.id.clone(), index).is_some() {
            return Err(ImportError::new(format!(
                "two joints of the address are called `{}`",
                shown(&joint.id)
            )));
        }
        if joint.is_grounded && !joint.is_slide && !pins.contains(&joint.id) {
            assembly.document.attach(index, FRAME);
        }
    }
    for slide in all.iter().filter(|joint| joint.is_slide) {
        if let Some(pin) = assembly.pin(slide) {
            let index = assembly.joint(&pin.id)?;
            assembly.joints.insert(slide.id.clone(), index);
        }
    }
    Ok(())
}

/// Takes roots: a welded link has the joints of its parts.
fn links(assembly: &mut Assembly) -> Result<(), ImportError> {
    let all = assembly.drawing.links.clone();
    for link in all.iter().filter(|link| link.is_root && !link.is_block) {
        let parts = all.iter().filter(|part| link.parts.contains(&part.id));
        let ids = link
            .joints
            .iter()
            .chain(parts.flat_map(|part| &part.joints));
        let mut joints = Vec::new();
        for id in ids {
            let joint = assembly.joint(id)?;
            if !joints.contains(&joint) {
                joints.push(joint);
            }
        }
        let name = if link.name.is_empty() {
            &link.id
        } else {
            &link.name
        };
        let index = assembly.document.add_link(name, joints);
        for id in link.parts.iter().chain([&link.id]) {
            assembly.links.insert(id.clone(), index);
        }
    }
    Ok(())
}

/// Adds the slot of a slide that is no cylinder.
fn slot(assembly: &mut Assembly, slide: &PageJoint) -> Result<(), ImportError> {
    let pin = assembly.pin(slide).cloned();
    let index = assembly.joint(&slide.id)?;
    let is_grounded = slide.is_grounded || pin.as_ref().is_some_and(|pin| pin.is_grounded);
    let (guide, path) = match &slide.carrier {
        Some([carrier, first, second]) => {
            let guide = assembly.links.get(carrier).copied().ok_or_else(|| {
                ImportError::new(format!("the address lacks the link `{}`", shown(carrier)))
            })?;
            let ends = (assembly.joint(first)?, assembly.joint(second)?);
            (guide, SlotPath::Joints(ends.0, ends.1))
        }
        None if is_grounded => {
            let text = format!("{}rad", plain(slide.angle));
            (FRAME, SlotPath::Direction(slide.angle, text, None))
        }
        None => {
            assembly.document.warnings.push(format!(
                "the slide `{}` slides on nothing and is left out",
                shown(&slide.id)
            ));
            return Ok(());
        }
    };
    let is_welded = slide.is_welded || pin.as_ref().is_some_and(|pin| pin.is_welded);
    let links = assembly.document.links_of(index);
    let block = links
        .into_iter()
        .find(|link| *link != guide && *link != FRAME);
    assembly.document.slots.push(Slot {
        pin: index,
        guide,
        path,
        block: block.filter(|_| is_welded),
    });
    if slide.is_input || pin.is_some_and(|pin| pin.is_input) {
        assembly.document.inputs.push(Input {
            kind: InputKind::Position {
                slot: assembly.document.slots.len() - 1,
            },
            travel: None,
            speed: None,
            rate: None,
        });
    }
    Ok(())
}

fn motors(assembly: &mut Assembly) {
    let pins = assembly.drawing.joints.clone();
    let slides: Vec<&PageJoint> = pins.iter().filter(|joint| joint.is_slide).collect();
    for motor in pins
        .iter()
        .filter(|joint| joint.is_input && !joint.is_slide)
    {
        let is_block = |slide: &&&PageJoint| {
            let pin = assembly.pin(slide);
            pin.is_some_and(|pin| pin.id == motor.id)
        };
        if slides.iter().any(|slide| is_block(&slide)) {
            continue;
        }
        let Some(pivot) = assembly.joints.get(&motor.id).copied() else {
            continue;
        };
        // The fixed link comes first.
        let links = assembly.document.links_of(pivot);
        let [base, link, ref others @ ..] = links[..] else {
            assembly.document.warnings.push(format!(
                "the motor at `{}` joins no two links and is left out",
                shown(&motor.name)
            ));
            continue;
        };
        if !others.is_empty() {
            let name = shown(&assembly.document.links[link].name);
            assembly.document.doubts.push(format!(
                "the motor at `{}` could turn several links; it turns `{name}`: `--input \
                 PIVOT,JOINT` names another one",
                shown(&motor.name)
            ));
        }
        let (speed, rate) = assembly.speed(motor);
        assembly.document.inputs.push(Input {
            kind: InputKind::Crank { link, pivot, base },
            travel: None,
            speed: Some(speed),
            rate: Some(rate),
        });
    }
}

/// Masses of 1 with inertias of 1 are those of new links of the page, which nobody chose.
fn masses(assembly: &mut Assembly) {
    let links = assembly.drawing.links.clone();
    let is_taken = |link: &&PageLink| link.is_root && !link.is_block;
    let mut new = 0;
    for link in links.iter().filter(is_taken) {
        let Some(index) = assembly.links.get(&link.id).copied() else {
            continue;
        };
        if (link.mass == 1.0 && link.inertia == 1.0) || link.mass <= 0.0 {
            new += 1;
            continue;
        }
        let [mass, inertia] = match assembly.document.unit {
            LengthUnit::Inch => [
                format!("{}kg", converted(link.mass * POUND)),
                format!("{}kg*cm^2", converted(link.inertia * POUND_INCHES)),
            ],
            LengthUnit::Metre => [
                format!("{}kg", plain(link.mass)),
                format!("{}kg*m^2", plain(link.inertia)),
            ],
            _ => [
                format!("{}kg", plain(link.mass)),
                format!("{}kg*cm^2", plain(link.inertia)),
            ],
        };
        let name = format!("centre_of_{}", link.id);
        let centre = assembly.document.add_derived(name, link.centre);
        assembly.document.attach(centre, index);
        assembly.document.links[index].mass = Some(Mass {
            mass,
            inertia: Some(inertia),
            centre,
        });
    }
    if new > 0 {
        assembly.document.remarks.push(format!(
            "{new} links have no mass or the mass 1 and the inertia 1 of new links: left out."
        ));
    }
}

/// Adds the forces: arrows that point to their place of application or away from it.
fn forces(assembly: &mut Assembly) {
    let unit = assembly.drawing.force_unit;
    let all = std::mem::take(&mut assembly.drawing.forces);
    for force in &all {
        let PageForce {
            id,
            link,
            start,
            end,
            size,
            ..
        } = force;
        let arrow = [end[0] - start[0], end[1] - start[1]];
        let length = arrow[0].hypot(arrow[1]);
        let link_index = assembly.links.get(link).copied();
        let (Some(link_index), Some(unit)) = (link_index.filter(|_| length > 0.0), unit) else {
            assembly.document.warnings.push(format!(
                "the force `{}` of {} on `{}` has no direction or link, and is left out",
                shown(id),
                plain(*size),
                shown(link)
            ));
            continue;
        };
        let sign = if force.points_away { 1.0 } else { -1.0 };
        let vector = arrow.map(|component| sign * size * component / length);
        let load = Load {
            vector,
            unit,
            turns: force.turns,
        };
        assembly.document.add_load(id, link_index, *start, load);
    }
}
