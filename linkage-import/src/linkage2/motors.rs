//! Motors, cylinders, gears and chains.

use crate::document::{FRAME, GearPair, Input, InputKind};
use crate::error::ImportError;
use crate::names::shown;
use crate::number::{decimal, plain, rounded};
use crate::xml::XmlElement;

use super::fastened::unite;
use super::sheet::{Sheet, identifier, is_mechanism, is_true};

/// A revolution per minute.
const DEGREES_PER_SECOND: f64 = 6.0;

/// Reads motors, then cylinders, then gears.
pub(super) fn read(sheet: &mut Sheet) -> Result<(), ImportError> {
    let root = sheet.root;
    for connector in root.named("connector").filter(|child| is_mechanism(child)) {
        if is_true(connector, "input") {
            motor(sheet, connector)?;
        }
    }
    for (link, index) in sheet.bodies.clone() {
        if is_true(link, "actuator") {
            cylinder(sheet, link, index)?;
        }
    }
    for ratio in root
        .named("ratios")
        .flat_map(|ratios| ratios.named("ratio"))
    {
        gears(sheet, ratio)?;
    }
    Ok(())
}

/// A motor turns all links at its connector that no second anchor holds, as one body.
fn motor(sheet: &mut Sheet, connector: &XmlElement) -> Result<(), ImportError> {
    let id = identifier(connector)?;
    let Some(pivot) = sheet.joints.get(&id).copied() else {
        return Ok(());
    };
    let document = &sheet.document;
    let is_held = |index: usize| {
        let joints = &document.links[index].joints;
        joints
            .iter()
            .filter(|joint| document.is_fixed(**joint))
            .count()
            > 1
    };
    let mut turned: Vec<usize> = Vec::new();
    for (element, index) in &sheet.bodies {
        let has_pivot = document.links[*index].joints.contains(&pivot);
        let is_free = *index != FRAME && !is_true(element, "actuator") && !is_held(*index);
        if has_pivot && is_free && !turned.contains(index) {
            turned.push(*index);
        }
    }
    let Some(link) = turned.first().copied() else {
        let name = shown(&sheet.document.joints[pivot].name);
        sheet.document.warnings.push(format!(
            "the motor at `{name}` turns no link and is left out"
        ));
        return Ok(());
    };
    for other in turned.into_iter().skip(1) {
        unite(sheet, other, link);
    }
    // The program reads a missing speed as zero.
    let rpm = decimal(connector.attribute("rpm").unwrap_or("0"), "`rpm`")?.value;
    let direction = if rpm < 0.0 {
        "counterclockwise"
    } else {
        "clockwise"
    };
    let manual = if is_true(connector, "alwaysmanual") {
        "; moved manually in the program"
    } else {
        ""
    };
    sheet.document.inputs.push(Input {
        kind: InputKind::Crank {
            link,
            pivot,
            base: FRAME,
        },
        travel: None,
        speed: Some(format!(
            "{direction} at {} revolutions per minute{manual}",
            plain(rpm.abs())
        )),
        rate: (manual.is_empty() && rpm != 0.0).then_some(-DEGREES_PER_SECOND * rpm),
    });
    Ok(())
}

/// A cylinder begins at the drawn length and extends by its throw, or retracts if its speed is
/// negative.
fn cylinder(sheet: &mut Sheet, link: &XmlElement, index: usize) -> Result<(), ImportError> {
    let id = shown(link.attribute("id").unwrap_or_default());
    let count = sheet.document.links[index].joints.len();
    if index == FRAME || count != 2 {
        sheet.document.warnings.push(format!(
            "the actuator {id} has {count} connectors instead of two and is left out"
        ));
        return Ok(());
    }
    let number = |name: &str| {
        let text = link.attribute(name).unwrap_or("0");
        Ok::<f64, ImportError>(decimal(text, &format!("`{name}` of link {id}"))?.value)
    };
    let throw = rounded(number("throw")?.abs() * sheet.scale, sheet.document.band);
    let cpm = number("cpm")?;
    let travel = if cpm < 0.0 {
        [-throw, 0.0]
    } else {
        [0.0, throw]
    };
    sheet.document.inputs.push(Input {
        kind: InputKind::Length { link: index },
        travel: (throw > 0.0).then_some(travel),
        speed: Some(format!(
            "{} first, {} cycles per minute",
            if cpm < 0.0 { "retracts" } else { "extends" },
            plain(cpm.abs())
        )),
        rate: None,
    });
    Ok(())
}

/// A pair of wheels. Their common link is the arm; wheels on two anchors have the frame.
fn gears(sheet: &mut Sheet, ratio: &XmlElement) -> Result<(), ImportError> {
    let is_chain = ratio.attribute("type") != Some("gears");
    let mut wheels = Vec::new();
    for link in ratio.named("link") {
        let id = link.attribute("id").unwrap_or_default();
        let size = decimal(link.attribute("size").unwrap_or("0"), "`size` of a gear")?.value;
        let mut elements = sheet.root.children.iter();
        let pivot = elements.find(|child| {
            let is_link = child.name == "Link" || child.name == "element";
            is_link && child.attribute("id").map(str::trim) == Some(id.trim())
        });
        let pivot = pivot.and_then(|link| link.named("connector").next());
        let pivot = pivot.and_then(|connector| identifier(connector).ok());
        let pivot = pivot.and_then(|id| sheet.joints.get(&id).copied());
        if let (Some(wheel), Some(pivot)) = (sheet.body(id), pivot)
            && size > 0.0
        {
            wheels.push((wheel, pivot, size));
        }
    }
    let [first, second] = wheels[..] else {
        sheet.document.warnings.push(format!(
            "a ratio has {} wheels of the mechanism instead of two and is left out",
            wheels.len()
        ));
        return Ok(());
    };
    let arm = (0..sheet.document.links.len()).find(|index| {
        let joints = &sheet.document.links[*index].joints;
        let is_wheel = *index == first.0 || *index == second.0;
        joints.contains(&first.1) && joints.contains(&second.1) && !is_wheel
    });
    let Some(arm) = arm else {
        sheet.document.warnings.push(
            "a ratio joins wheels whose axes have no common link, and is left out".to_owned(),
        );
        return Ok(());
    };
    sheet.document.gears.push(GearPair {
        wheels: [first.0, second.0],
        sizes: [first.2, second.2],
        arm,
        is_chain,
    });
    Ok(())
}
