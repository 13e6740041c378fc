//! Addresses of the rewritten page, `data=...`: JSON with shorter marks, compressed by LZ-String.
//!
//! Whole numbers are texts in base 16, and other numbers are JSON numbers. The page itself reads
//! whole coordinates in base 10. An address has no units.

use std::collections::BTreeMap;

use serde_json::Value;

use crate::document::{Document, FRAME, Input, InputKind, LengthUnit, MOST_JOINTS, MOST_LINKS};
use crate::document::{Slot, SlotPath};
use crate::error::ImportError;
use crate::names::shown;
use crate::number::plain;

/// The start of the query of such an address.
pub(super) const PREFIX: &str = "data=";

/// The longest compressed text: it could expand to the square of its length.
const LONGEST: usize = 1 << 14;

/// The shorter marks and the texts that they stand for, in the order in which they are replaced.
const MARKS: [(&str, &str); 4] = [
    ("--", "\"]_[\""),
    ("RP", "Reference Point"),
    ("_", ","),
    ("~", "\",\""),
];

/// The columns of a row of joints.
mod joint_column {
    pub(super) const NAME: usize = 1;
    pub(super) const X: usize = 2;
    pub(super) const Y: usize = 3;
    pub(super) const TYPE: usize = 4;
    pub(super) const ANGLE: usize = 5;
    pub(super) const GROUNDED: usize = 6;
    pub(super) const INPUT: usize = 7;
    pub(super) const SPEED: usize = 8;
    pub(super) const WELDED: usize = 9;
}

/// The columns of a row of links.
mod link_column {
    pub(super) const NAME: usize = 1;
    pub(super) const JOINTS: usize = 6;
}

/// The type of a joint that slides on the ground.
const PRISMATIC: f64 = 0.0;

/// The rows of a drawing.
struct Rows<'v> {
    joints: Vec<&'v Value>,
    links: Vec<&'v Value>,
    compounds: Vec<&'v Value>,
    forces: usize,
}

/// Reads the compressed text of an address.
pub(super) fn read(packed: &str) -> Result<Document, ImportError> {
    if packed.len() > LONGEST {
        return Err(ImportError::new(format!(
            "the address has more than {LONGEST} characters"
        )));
    }
    let units = lz_str::decompress_from_encoded_uri_component(packed);
    let text = units.and_then(|units| String::from_utf16(&units).ok());
    let mut text = text.filter(|text| !text.is_empty()).ok_or_else(|| {
        ImportError::new(
            "the compressed part of the address cannot be read: it was cut or changed\nhelp: \
             share the drawing again and give the whole address in quotes",
        )
    })?;
    for (mark, meaning) in MARKS {
        text = text.replace(mark, meaning);
    }
    let value: Value = serde_json::from_str(&text).map_err(|error| {
        ImportError::new(format!(
            "the drawing of the address cannot be read: {error}; a name with `_`, `~` or `--` breaks \
             an address of this page"
        ))
    })?;
    let rows = |key: &str| {
        value
            .get(key)
            .and_then(Value::as_array)
            .map_or_else(Vec::new, |rows| rows.iter().collect())
    };
    document(&Rows {
        joints: rows("j"),
        links: rows("l"),
        compounds: rows("c"),
        forces: rows("f").len(),
    })
}

fn document(rows: &Rows) -> Result<Document, ImportError> {
    if rows.joints.len() > MOST_JOINTS || rows.links.len() > MOST_LINKS {
        return Err(ImportError::new(format!(
            "the address has more than {MOST_JOINTS} joints or {MOST_LINKS} links"
        )));
    }
    if rows.joints.is_empty() {
        return Err(ImportError::new("the address has no joints"));
    }
    let mut document = Document::new("a compressed address of PMKS+", LengthUnit::Centimetre);
    document.warnings.push(
        "the address has no unit: centimetres are taken, confirm the largest distance".to_owned(),
    );
    let mut joints: BTreeMap<i64, usize> = BTreeMap::new();
    for row in &rows.joints {
        let position = [number(row, joint_column::X)?, number(row, joint_column::Y)?];
        let index = document.add_joint(text(row, joint_column::NAME), position);
        if joints.insert(number(row, 0)? as i64, index).is_some() {
            return Err(ImportError::new(
                "two joints of the address have one number",
            ));
        }
        if is_true(row, joint_column::GROUNDED) {
            document.attach(index, FRAME);
        }
        if is_true(row, joint_column::WELDED) {
            let name = shown(text(row, joint_column::NAME));
            document.warnings.push(format!(
                "the weld at `{name}` is taken only if its links are a compound link"
            ));
        }
    }
    let links = add_links(&mut document, rows, &joints)?;
    weld(&mut document, rows, &links)?;
    for row in &rows.joints {
        let index = joints[&(number(row, 0)? as i64)];
        add_slide_or_motor(&mut document, row, index)?;
    }
    if rows.forces > 0 {
        document.warnings.push(format!(
            "{} forces are left out: the address has no unit for them",
            rows.forces
        ));
    }
    document
        .remarks
        .push("Masses are left out: the address has no units for them.".to_owned());
    Ok(document)
}

/// Adds all links, and returns the link of each number.
fn add_links(
    document: &mut Document,
    rows: &Rows,
    joints: &BTreeMap<i64, usize>,
) -> Result<BTreeMap<i64, usize>, ImportError> {
    let mut links = BTreeMap::new();
    for row in &rows.links {
        let mut members = Vec::new();
        for id in text(row, link_column::JOINTS).split('|') {
            let joint = id.parse().ok().and_then(|id: i64| joints.get(&id));
            let joint = joint.ok_or_else(|| {
                ImportError::new(format!("the address lacks the joint `{}`", shown(id)))
            })?;
            if !members.contains(joint) {
                members.push(*joint);
            }
        }
        let link = document.add_link(text(row, link_column::NAME), members);
        links.insert(number(row, 0)? as i64, link);
    }
    Ok(links)
}

/// Joins the links of compound links to the first of them.
fn weld(
    document: &mut Document,
    rows: &Rows,
    links: &BTreeMap<i64, usize>,
) -> Result<(), ImportError> {
    /// The column with the links of a compound link.
    const LINKS: usize = 5;
    for row in &rows.compounds {
        let members = text(row, LINKS).split('|');
        let members = members.map(|id| {
            let link = id.parse().ok().and_then(|id: i64| links.get(&id).copied());
            link.ok_or_else(|| {
                ImportError::new(format!("the address lacks the link `{}`", shown(id)))
            })
        });
        let members: Vec<usize> = members.collect::<Result<_, _>>()?;
        let Some((first, others)) = members.split_first() else {
            continue;
        };
        for other in others.iter().filter(|other| *other != first) {
            for joint in std::mem::take(&mut document.links[*other].joints) {
                document.attach(joint, *first);
            }
        }
    }
    Ok(())
}

fn add_slide_or_motor(
    document: &mut Document,
    row: &Value,
    joint: usize,
) -> Result<(), ImportError> {
    let is_input = is_true(row, joint_column::INPUT);
    if number(row, joint_column::TYPE)? == PRISMATIC {
        let angle = number(row, joint_column::ANGLE)?;
        document.slots.push(Slot {
            pin: joint,
            guide: FRAME,
            path: SlotPath::Direction(angle.to_radians(), format!("{}deg", plain(angle)), None),
            block: None,
        });
        if is_input {
            document.inputs.push(Input {
                kind: InputKind::Position {
                    slot: document.slots.len() - 1,
                },
                travel: None,
                speed: None,
                rate: None,
            });
        }
        return Ok(());
    }
    if !is_input {
        return Ok(());
    }
    // The fixed link comes first.
    let [base, link, ..] = document.links_of(joint)[..] else {
        let name = shown(text(row, joint_column::NAME));
        document.warnings.push(format!(
            "the motor at `{name}` joins no two links and is left out"
        ));
        return Ok(());
    };
    let speed = number(row, joint_column::SPEED)?;
    document.inputs.push(Input {
        kind: InputKind::Crank {
            link,
            pivot: joint,
            base,
        },
        travel: None,
        speed: Some(format!("at {} revolutions per minute", plain(speed))),
        rate: Some(6.0 * speed),
    });
    Ok(())
}

/// Returns a number of a row: a text is a whole number in base 16.
fn number(row: &Value, column: usize) -> Result<f64, ImportError> {
    let value = row.get(column).unwrap_or(&Value::Null);
    let number = match value {
        Value::Number(number) => number.as_f64(),
        Value::String(text) => i64::from_str_radix(text, 16).ok().map(|whole| whole as f64),
        _ => None,
    };
    number.ok_or_else(|| {
        ImportError::new(format!(
            "`{}` in a row of the address is no number",
            shown(&value.to_string())
        ))
    })
}

fn text(row: &Value, column: usize) -> &str {
    row.get(column).and_then(Value::as_str).unwrap_or_default()
}

fn is_true(row: &Value, column: usize) -> bool {
    text(row, column) == "y"
}
