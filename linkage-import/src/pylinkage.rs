//! JSON files of pylinkage, and the same as a dictionary of Python.
//!
//! They have positions of joints and lists of joints for links. There are no lengths: all of them
//! follow from the positions. Slides move along a line that does not move.

use std::collections::BTreeMap;

use serde_json::Value;

use crate::document::{Document, FRAME, Input, InputKind, LengthUnit, MOST_JOINTS, MOST_LINKS};
use crate::document::{Slot, SlotPath};
use crate::error::ImportError;
use crate::names::shown;
use crate::number::plain;

mod contradictions;
mod python;

/// Reads a file.
pub(crate) fn read(content: &[u8]) -> Result<Document, ImportError> {
    let text = String::from_utf8_lossy(content);
    let value: Value = serde_json::from_str(&text)
        .or_else(|error| serde_json::from_str(&python::as_json(&text)).map_err(|_| error))
        .map_err(|error| ImportError::new(format!("the file is no JSON: {error}")))?;
    if value.get("nodes").is_some() && value.get("joints").is_none() {
        return Err(ImportError::new(
            "the file has only a graph, without positions\nhelp: save the mechanism itself, with \
             `mechanism_to_json`",
        ));
    }
    let mut document = Document::new("a file of pylinkage", LengthUnit::Millimetre);
    document.warnings.push(
        "the file has no unit: millimetres are taken, confirm the largest distance".to_owned(),
    );
    document.remarks.push(
        "The file has no lengths: they are those of the positions, which have all digits."
            .to_owned(),
    );
    if let Some(name) = value.get("name").and_then(Value::as_str) {
        document.name = name.to_owned();
    }
    let mut sheet = Sheet {
        document,
        joints: BTreeMap::new(),
    };
    let [joints, links] = ["joints", "links"].map(|name| list(&value, name));
    let (joints, links) = (joints.map_err(foreign)?, links.map_err(foreign)?);
    if joints.len() > MOST_JOINTS || links.len() > MOST_LINKS {
        return Err(ImportError::new("the file has too many joints or links"));
    }
    for joint in joints {
        read_joint(&mut sheet, joint)?;
    }
    for link in links {
        read_link(&mut sheet, link)?;
    }
    for joint in joints {
        trackers(&mut sheet, joint)?;
    }
    name_unknown(&mut sheet, &value);
    Ok(sheet.document)
}

struct Sheet {
    document: Document,
    joints: BTreeMap<String, usize>,
}

impl Sheet {
    fn joint(&self, id: &str) -> Result<usize, ImportError> {
        let joint = self.joints.get(id).copied();
        joint.ok_or_else(|| {
            ImportError::new(format!("there is no joint `{}`, which is named", shown(id)))
        })
    }
}

fn list<'t>(value: &'t Value, name: &str) -> Result<&'t Vec<Value>, ImportError> {
    let list = value.get(name).and_then(Value::as_array);
    list.ok_or_else(|| ImportError::new(format!("the file has no list `{name}`")))
}

/// Adds to a message that the JSON may be that of another program.
fn foreign(error: ImportError) -> ImportError {
    ImportError::new(format!(
        "{error}\nhelp: it is read as a file of pylinkage, which has lists `joints` and `links`; \
         `--format` names another format"
    ))
}

fn text<'t>(value: &'t Value, name: &str) -> Option<&'t str> {
    value.get(name).and_then(Value::as_str)
}

fn pair(value: &Value, name: &str, of: &str) -> Result<[f64; 2], ImportError> {
    let pair = value.get(name).and_then(Value::as_array);
    let numbers: Vec<f64> = pair
        .into_iter()
        .flatten()
        .filter_map(Value::as_f64)
        .collect();
    match numbers[..] {
        [x, y] if x.is_finite() && y.is_finite() => Ok([x, y]),
        _ => Err(ImportError::new(format!(
            "joint `{}` has no `{name}` with two numbers\nhelp: simulate one step before saving, \
             then all positions are known",
            shown(of)
        ))),
    }
}

fn identifier<'t>(value: &'t Value, kind: &str) -> Result<&'t str, ImportError> {
    text(value, "id").ok_or_else(|| ImportError::new(format!("a {kind} has no `id`")))
}

fn read_joint(sheet: &mut Sheet, value: &Value) -> Result<(), ImportError> {
    let id = identifier(value, "joint")?;
    let position = pair(value, "position", id)?;
    let name = text(value, "name").unwrap_or(id);
    let joint = sheet.document.add_joint(name, position);
    if sheet.joints.insert(id.to_owned(), joint).is_some() {
        return Err(ImportError::new(format!(
            "two joints are called `{}`",
            shown(id)
        )));
    }
    match text(value, "type").unwrap_or("revolute") {
        "revolute" | "tracker" => {}
        "ground" => sheet.document.attach(joint, FRAME),
        "prismatic" => {
            let axis = match value.get("axis") {
                Some(_) => pair(value, "axis", id)?,
                None => [1.0, 0.0],
            };
            let angle = axis[1].atan2(axis[0]);
            sheet.document.slots.push(Slot {
                pin: joint,
                guide: FRAME,
                path: SlotPath::Direction(angle, format!("{}rad", plain(angle)), None),
                block: None,
            });
            contradictions::name_line(&mut sheet.document, value, joint, angle);
        }
        other => {
            return Err(ImportError::new(format!(
                "joint `{}` is of the type `{}`, which is not known",
                shown(id),
                shown(other)
            )));
        }
    }
    Ok(())
}

fn read_link(sheet: &mut Sheet, value: &Value) -> Result<(), ImportError> {
    let id = identifier(value, "link")?;
    let mut joints = Vec::new();
    for joint in list(value, "joints")? {
        let joint = sheet.joint(joint.as_str().unwrap_or_default())?;
        if !joints.contains(&joint) {
            joints.push(joint);
        }
    }
    let kind = text(value, "type").unwrap_or("link");
    if kind == "ground" {
        for joint in joints {
            sheet.document.attach(joint, FRAME);
        }
        return Ok(());
    }
    let link = sheet
        .document
        .add_link(text(value, "name").unwrap_or(id), joints);
    if kind != "driver" && kind != "arc_driver" {
        return Ok(());
    }
    let Some(motor) = text(value, "motor_joint") else {
        sheet.document.warnings.push(format!(
            "the driver `{}` has no `motor_joint` and is not driven",
            shown(id)
        ));
        return Ok(());
    };
    let pivot = sheet.joint(motor)?;
    sheet.document.attach(pivot, FRAME);
    sheet.document.attach(pivot, link);
    name_angle(sheet, value, link, pivot);
    let rate = value.get("angular_velocity").and_then(Value::as_f64);
    sheet.document.inputs.push(Input {
        kind: InputKind::Crank {
            link,
            pivot,
            base: FRAME,
        },
        travel: None,
        speed: rate.map(|rate| format!("{} rad for each step of the program", plain(rate))),
        rate: None,
    });
    if kind == "arc_driver" {
        let bound = |name| value.get(name).and_then(Value::as_f64).map(plain);
        let bounds = [bound("arc_start"), bound("arc_end")];
        let bounds = bounds.map(|bound| bound.unwrap_or_else(|| "?".to_owned()));
        sheet.document.warnings.push(format!(
            "the driver `{}` moves between {} and {} rad in the program: set the range of its input",
            shown(id),
            bounds[0],
            bounds[1]
        ));
    }
    Ok(())
}

/// The program begins at the angle of the file, which positions that were saved later do not have.
fn name_angle(sheet: &mut Sheet, value: &Value, link: usize, pivot: usize) {
    const CLOSE: f64 = 1e-6;
    let joints = &sheet.document.links[link].joints;
    let other = joints.iter().find(|joint| **joint != pivot).copied();
    let angle = value.get("initial_angle").and_then(Value::as_f64);
    let (Some(other), Some(angle)) = (other, angle) else {
        return;
    };
    let drawn = sheet.document.direction(pivot, other);
    let turned = drawn - angle;
    let turned = turned - std::f64::consts::TAU * (turned / std::f64::consts::TAU).round();
    if turned.abs() > CLOSE {
        sheet.document.warnings.push(format!(
            "the driver `{}` begins at {} rad in the program, and is at {} rad in the positions of \
             the file: these are taken",
            shown(&sheet.document.links[link].name),
            plain(angle),
            plain(drawn)
        ));
    }
}

/// A tracker belongs to the link of its two reference joints.
fn trackers(sheet: &mut Sheet, value: &Value) -> Result<(), ImportError> {
    if text(value, "type") != Some("tracker") {
        return Ok(());
    }
    let id = identifier(value, "joint")?;
    let joint = sheet.joint(id)?;
    let references = ["ref_joint1_id", "ref_joint2_id"].map(|name| text(value, name));
    let [Some(first), Some(second)] = references else {
        return Err(ImportError::new(format!(
            "the tracker `{}` has no two reference joints",
            shown(id)
        )));
    };
    let ends = [sheet.joint(first)?, sheet.joint(second)?];
    contradictions::name_tracker(&mut sheet.document, value, joint, ends);
    let mut links = sheet.document.links.iter();
    let link = links.position(|link| ends.iter().all(|end| link.joints.contains(end)));
    match link {
        Some(link) => sheet.document.attach(joint, link),
        None => sheet.document.warnings.push(format!(
            "no link has both reference joints of the tracker `{}`: it is left out",
            shown(id)
        )),
    }
    Ok(())
}

/// Names keys that are not read, once each.
fn name_unknown(sheet: &mut Sheet, value: &Value) {
    const READ: [&str; 19] = [
        "name",
        "joints",
        "links",
        "ground",
        "id",
        "type",
        "position",
        "axis",
        "line_point",
        "slide_distance",
        "ref_joint1_id",
        "ref_joint2_id",
        "distance",
        "angle",
        "angular_velocity",
        "motor_joint",
        "arc_start",
        "arc_end",
        "initial_angle",
    ];
    let lists = ["joints", "links"].map(|name| value.get(name).and_then(Value::as_array));
    let objects = lists.into_iter().flatten().flatten().chain([value]);
    let keys = objects
        .filter_map(Value::as_object)
        .flat_map(|object| object.keys());
    let mut unknown: Vec<&String> = keys.filter(|key| !READ.contains(&&key[..])).collect();
    unknown.sort();
    unknown.dedup();
    for key in unknown {
        sheet.document.warnings.push(format!(
            "the key `{}` is not known and left out",
            shown(key)
        ));
    }
}
