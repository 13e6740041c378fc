//! Links of the file, and elements that are fastened to each other.

use crate::document::FRAME;
use crate::error::ImportError;
use crate::names::shown;
use crate::xml::XmlElement;

use super::sheet::{Sheet, identifier, is_mechanism, is_true, named};

/// Reads links and fastenings.
pub(super) fn read(sheet: &mut Sheet) -> Result<(), ImportError> {
    let root = sheet.root;
    let elements = root.children.iter();
    let links = elements.filter(|child| child.name == "Link" || child.name == "element");
    let mut drawn = 0;
    for link in links {
        if !is_mechanism(link) {
            drawn += 1;
            continue;
        }
        let id = identifier(link)?;
        let mut joints = Vec::new();
        for connector in link.named("connector") {
            if let Some(joint) = sheet.referred(connector)?
                && !joints.contains(&joint)
            {
                joints.push(joint);
            }
        }
        let name = named(link).unwrap_or_else(|| format!("link{id}"));
        let index = sheet.document.add_link(name, joints);
        sheet.bodies.push((link, index));
        // Connectors of drawings are fastened here, too.
        for connector in link.named("fastenconnector") {
            let id = identifier(connector)?;
            if let Some(joint) = sheet.joints.get(&id).copied() {
                sheet.document.attach(joint, index);
            }
        }
        if is_true(link, "locked") {
            let name = shown(&sheet.document.links[index].name);
            let remark = format!("The program keeps `{name}` from being edited.");
            sheet.document.remarks.push(remark);
        }
    }
    if drawn > 0 {
        sheet.document.remarks.push(format!(
            "{drawn} links of drawing layers are no part of the mechanism and left out."
        ));
    }
    fasten(sheet);
    Ok(())
}

/// Fastened links are one body with that to which they are fastened.
fn fasten(sheet: &mut Sheet) {
    for (link, index) in sheet.bodies.clone() {
        let target = if let Some(id) = link.attribute("fastenlink") {
            let target = sheet.body(id);
            if target.is_none() {
                warn(sheet, link, &format!("the link {}", shown(id)));
            }
            target
        } else if let Some(id) = link.attribute("fastenconnector") {
            let number = id.trim().parse::<i64>().ok();
            let joint = number.and_then(|id| sheet.joints.get(&id).copied());
            match joint {
                // An anchor holds it. Another connector has no direction.
                Some(joint) if sheet.document.is_fixed(joint) => Some(FRAME),
                _ => {
                    warn(sheet, link, &format!("the connector {}", shown(id)));
                    None
                }
            }
        } else {
            None
        };
        if let Some(target) = target.filter(|target| *target != index) {
            unite(sheet, index, target);
        }
    }
    let root = sheet.root;
    for connector in root.named("connector").filter(|child| is_mechanism(child)) {
        let link = connector.attribute("fasten");
        let Some(id) = link.or_else(|| connector.attribute("fastenlink")) else {
            continue;
        };
        let joint = identifier(connector).ok();
        let joint = joint.and_then(|id| sheet.joints.get(&id).copied());
        if let (Some(joint), Some(link)) = (joint, sheet.body(id)) {
            sheet.document.attach(joint, link);
        }
    }
}

fn warn(sheet: &mut Sheet, link: &XmlElement, target: &str) {
    let id = shown(link.attribute("id").unwrap_or_default());
    sheet.document.warnings.push(format!(
        "link {id} is fastened to {target}, which does not hold it: the fastening is left out"
    ));
}

/// Moves the joints of a link to another one. The elements of both lead to the other one then.
pub(super) fn unite(sheet: &mut Sheet, index: usize, target: usize) {
    let joints = std::mem::take(&mut sheet.document.links[index].joints);
    // The pivot of a fixed wheel stays a pivot of the arm: it is fixed already.
    for joint in joints {
        sheet.document.attach(joint, target);
    }
    let (name, other) = (
        shown(&sheet.document.links[index].name),
        shown(&sheet.document.links[target].name),
    );
    sheet
        .document
        .remarks
        .push(format!("`{name}` and `{other}` of the file are one body."));
    for body in &mut sheet.bodies {
        if body.1 == index {
            body.1 = target;
        }
    }
}
