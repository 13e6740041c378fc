//! The kind of each joint of a table: pins, motors, slots, blocks and cylinders.

use csv::StringRecord;

use super::header::Table;
use crate::document::{FRAME, Input, InputKind, Slot, SlotPath};
use crate::error::ImportError;
use crate::names::shown;
use crate::number::{decimal, plain, with_point};

/// Joins the links of a row.
pub(super) fn connect(table: &mut Table, row: &StringRecord) -> Result<(), ImportError> {
    let name = table.cell(row, "name").to_owned();
    let kind = table.cell(row, "kind").to_ascii_lowercase();
    let names = table.cell(row, "links").split_whitespace();
    let names: Vec<String> = names.map(str::to_owned).collect();
    if kind == "cylinder" {
        return cylinder(table, &name, &names);
    }
    let pin = table.joint(&name)?;
    let mut links = Vec::new();
    for name in names {
        let document = &mut table.document;
        let link = table
            .links
            .entry(name)
            .or_insert_with_key(|name| document.add_link(name.clone(), Vec::new()));
        links.push(*link);
    }
    let is_slot = kind == "slot" || kind == "block";
    for link in links.iter().skip(usize::from(is_slot)) {
        table.document.attach(pin, *link);
    }
    match &kind[..] {
        "" | "pin" | "r" => Ok(()),
        "motor" => motor(table, &name, pin, &links),
        "slot" | "block" => slot(table, row, pin, &links, kind == "block"),
        other => Err(ImportError::new(format!(
            "`{}` is of the kind `{}`\nhelp: kinds are pin, motor, slot, block and cylinder",
            shown(&name),
            shown(other)
        ))),
    }
}

/// Drives the second link against the first one. The fixed link never turns: it is the first.
fn motor(table: &mut Table, name: &str, pivot: usize, links: &[usize]) -> Result<(), ImportError> {
    let (base, link) = match *links {
        [turned, FRAME, ..] if turned != FRAME => {
            table.document.warnings.push(format!(
                "the motor `{}` names the fixed link second: the angle of `{}` is taken, which has \
                 the opposite sign",
                shown(name),
                shown(&table.document.links[turned].name)
            ));
            (FRAME, turned)
        }
        [base, link, ..] => (base, link),
        _ => {
            return Err(ImportError::new(format!(
                "the motor `{}` needs two links, the fixed one first",
                shown(name)
            )));
        }
    };
    table.document.inputs.push(Input {
        kind: InputKind::Crank { link, pivot, base },
        travel: None,
        speed: None,
        rate: None,
    });
    Ok(())
}

fn slot(
    table: &mut Table,
    row: &StringRecord,
    pin: usize,
    links: &[usize],
    is_block: bool,
) -> Result<(), ImportError> {
    let name = shown(table.cell(row, "name"));
    let along = table.cell(row, "along");
    if along.is_empty() {
        return Err(ImportError::new(format!(
            "the slot `{name}` has no `along`\nhelp: it is the direction in degrees, or two joints \
             of the link that has the slot"
        )));
    }
    let path = if let Some((first, second)) = along.split_once(char::is_whitespace) {
        SlotPath::Joints(table.joint(first)?, table.joint(second.trim())?)
    } else {
        let angle = decimal(
            &with_point(along, table.separator),
            &format!("`along` of `{name}`"),
        )?
        .value;
        SlotPath::Direction(angle.to_radians(), format!("{}deg", plain(angle)), None)
    };
    let (Some(guide), block) = (links.first().copied(), links.get(1).copied()) else {
        return Err(ImportError::new(format!(
            "the slot `{name}` needs its link"
        )));
    };
    if is_block && block.is_none() {
        return Err(ImportError::new(format!(
            "the block `{name}` needs two links"
        )));
    }
    table.document.slots.push(Slot {
        pin,
        guide,
        path,
        block: block.filter(|_| is_block),
    });
    if !table.cell(row, "input").is_empty() {
        table.document.inputs.push(Input {
            kind: InputKind::Position {
                slot: table.document.slots.len() - 1,
            },
            travel: None,
            speed: None,
            rate: None,
        });
    }
    Ok(())
}

fn cylinder(table: &mut Table, name: &str, joints: &[String]) -> Result<(), ImportError> {
    let [first, second] = joints else {
        return Err(ImportError::new(format!(
            "the cylinder `{}` needs two joints in the column `links`",
            shown(name)
        )));
    };
    let ends = vec![table.joint(first)?, table.joint(second)?];
    let link = table.document.add_link(name, ends);
    table.document.inputs.push(Input {
        kind: InputKind::Length { link },
        travel: None,
        speed: None,
        rate: None,
    });
    Ok(())
}
