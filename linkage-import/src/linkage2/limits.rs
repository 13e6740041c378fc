//! Sliding connectors: a slot between two limits, straight or an arc.

use crate::document::{FRAME, Slot, SlotPath};
use crate::error::ImportError;
use crate::names::shown;
use crate::number::{decimal, plain, rounded};
use crate::xml::XmlElement;

use super::sheet::{Sheet, identifier, is_mechanism, is_true};

/// The program keeps radii of arcs above half of the distance of the limits, in its unit.
const LEAST_EXCESS: f64 = 0.0009;

/// Reads all slots.
pub(super) fn read(sheet: &mut Sheet) -> Result<(), ImportError> {
    let root = sheet.root;
    for connector in root.named("connector").filter(|child| is_mechanism(child)) {
        if is_true(connector, "slider") {
            slot(sheet, connector)?;
        }
    }
    Ok(())
}

fn slot(sheet: &mut Sheet, connector: &XmlElement) -> Result<(), ImportError> {
    let id = identifier(connector)?;
    let Some(pin) = sheet.joints.get(&id).copied() else {
        return Ok(());
    };
    let mut limits = Vec::new();
    for limit in connector.named("slidelimit") {
        limits.extend(sheet.referred(limit)?);
    }
    let (Some(first), Some(second)) = (limits.first().copied(), limits.get(1).copied()) else {
        sheet.document.warnings.push(format!(
            "connector {id} slides, and has {} limits instead of two: its slot is left out",
            limits.len()
        ));
        return Ok(());
    };
    if limits.len() > 2 || first == second {
        sheet.document.warnings.push(format!(
            "connector {id} has {} limits; the slot is that of the first two",
            limits.len()
        ));
    }
    let Some(guide) = guide(sheet, pin, first, second) else {
        let [first, second] =
            [first, second].map(|joint| shown(&sheet.document.joints[joint].name));
        sheet.document.warnings.push(format!(
            "connector {id} slides between `{first}` and `{second}`, which no link joins: the slot \
             is left out"
        ));
        return Ok(());
    };
    let radius = connector.attribute("slideradius").unwrap_or("0");
    let radius = decimal(radius, &format!("`slideradius` of connector {id}"))?.value;
    let path = if radius == 0.0 {
        SlotPath::Joints(first, second)
    } else {
        arc(sheet, guide, [first, second], radius)
    };
    sheet.document.slots.push(Slot {
        pin,
        guide,
        path,
        block: None,
    });
    Ok(())
}

/// Returns the link that has both limits and not the pin.
fn guide(sheet: &Sheet, pin: usize, first: usize, second: usize) -> Option<usize> {
    let document = &sheet.document;
    if document.is_fixed(first) && document.is_fixed(second) {
        return Some(FRAME);
    }
    let is_cylinder = |index: usize| {
        let mut bodies = sheet.bodies.iter();
        bodies.any(|body| body.1 == index && is_true(body.0, "actuator"))
    };
    let links = document.links.iter().enumerate();
    let mut guides = links.filter(|(index, link)| {
        let has = |joint| link.joints.contains(joint);
        has(&first) && has(&second) && !has(&pin) && !is_cylinder(*index)
    });
    guides.next().map(|(index, _)| index)
}

/// Adds the centre of an arc to its link. It is to the left of the way from the first limit to the
/// second one for positive radii.
fn arc(sheet: &mut Sheet, guide: usize, limits: [usize; 2], radius: f64) -> SlotPath {
    let document = &mut sheet.document;
    let [first, second] = limits.map(|joint| document.joints[joint].position);
    let along = [second[0] - first[0], second[1] - first[1]];
    let distance = along[0].hypot(along[1]);
    let stored = radius.abs() * sheet.scale;
    let length = stored.max(0.5 * distance + LEAST_EXCESS * sheet.scale);
    let height = (length * length - 0.25 * distance * distance)
        .max(0.0)
        .sqrt();
    let height = height.copysign(radius) / distance.max(f64::MIN_POSITIVE);
    let centre = [
        0.5 * (first[0] + second[0]) - height * along[1],
        0.5 * (first[1] + second[1]) + height * along[0],
    ];
    // More digits than positions have: errors of the limits are smaller in the centre of no arc.
    let centre = centre.map(|value| rounded(value, document.band));
    let same = document.slots.iter().find_map(|slot| match slot.path {
        SlotPath::Arc { centre: joint, .. }
            if slot.guide == guide && document.joints[joint].position == centre =>
        {
            Some(joint)
        }
        _ => None,
    });
    let centre = same.unwrap_or_else(|| {
        let names = limits.map(|joint| document.joints[joint].name.clone());
        let name = format!("centre_{}_{}", names[0], names[1]);
        let joint = document.add_derived(name, centre);
        document.attach(joint, guide);
        joint
    });
    if length > stored {
        document.warnings.push(format!(
            "a slot radius of {} is less than half of the distance of its limits: {} is taken, as \
             the program does",
            plain(stored),
            plain(length)
        ));
    }
    SlotPath::Arc {
        centre,
        radius: length,
    }
}
