//! Facts of drawings: positions, links, slots and inputs, from which the files were written.

use std::collections::BTreeMap;
use std::fs;

use serde_json::Value;

use crate::files::folder;

/// A drawing, in the unit of its mechanism.
pub(crate) struct Facts {
    pub(crate) joints: Vec<(String, [f64; 2])>,
    pub(crate) fixed: Vec<usize>,
    pub(crate) links: BTreeMap<String, Vec<usize>>,
    pub(crate) slots: Vec<Slot>,
    pub(crate) inputs: Vec<Input>,
    /// The identifiers of joints in the imported text.
    pub(crate) names: Vec<String>,
    pub(crate) size: f64,
}

pub(crate) struct Slot {
    pub(crate) pin: usize,
    /// `frame` or a link.
    pub(crate) guide: String,
    pub(crate) path: Path,
    /// The link that keeps its angle to the guide.
    pub(crate) block: Option<String>,
}

pub(crate) enum Path {
    Joints(usize, usize),
    Direction(f64),
    Arc([f64; 2]),
}

pub(crate) enum Input {
    Crank { pivot: usize, other: usize },
    Length(usize, usize),
}

/// Reads the facts of a drawing.
pub(crate) fn facts(name: &str) -> Facts {
    let path = folder().join("facts").join(format!("{name}.json"));
    let text = fs::read_to_string(path).expect("facts");
    let value: Value = serde_json::from_str(&text).expect("facts as JSON");
    let tool = value["tool"].as_str().expect("a tool");
    let scale = match (tool, value["unit"].as_str()) {
        ("linkage2", Some("inch")) => 1.0 / 96.0,
        ("linkage2", _) => 25.4 / 96.0,
        _ => 1.0,
    };
    let point = |value: &Value| [0, 1].map(|axis| number(&value[axis]) * scale);
    let joints = value["joints"].as_object().expect("joints");
    let joints: Vec<(String, [f64; 2])> = joints
        .iter()
        .map(|(name, value)| (name.clone(), point(value)))
        .collect();
    // JSON objects are sorted by name, files by number.
    let mut joints = joints;
    joints.sort_by_key(|joint| joint.0[1..].parse::<usize>().expect("a number"));
    let index = |name: &Value| {
        let name = name.as_str().expect("a joint");
        let mut joints = joints.iter();
        joints.position(|joint| joint.0 == name).expect("a joint")
    };
    let list = |value: &Value| {
        value
            .as_array()
            .expect("a list")
            .iter()
            .map(index)
            .collect()
    };
    let links = value["links"].as_object().expect("links").iter();
    let links: BTreeMap<String, Vec<usize>> = links
        .map(|(name, joints)| (name.clone(), list(joints)))
        .collect();
    let straight = value["sliding_pins"].as_array().expect("slots").iter();
    let straight = straight.map(|slot| Slot {
        pin: index(&slot["joint"]),
        guide: slot["on"].as_str().expect("a guide").to_owned(),
        path: match slot["through"].as_array() {
            Some(ends) => Path::Joints(index(&ends[0]), index(&ends[1])),
            None => Path::Direction(number(&slot["direction_rad"])),
        },
        block: slot["block"].as_str().map(str::to_owned),
    });
    let curved = value["curved_slots"].as_array().expect("slots").iter();
    let curved = curved.map(|slot| Slot {
        pin: index(&slot["joint"]),
        guide: slot["on"].as_str().expect("a guide").to_owned(),
        path: Path::Arc(point(&slot["centre"])),
        block: None,
    });
    let inputs = value["inputs"].as_array().expect("inputs").iter();
    let inputs = inputs.filter_map(|input| match input["kind"].as_str() {
        Some("crank") => {
            let pivot = index(&input["pivot"]);
            let body = &links[input["body"].as_str().expect("a body")];
            let other = body.iter().find(|joint| **joint != pivot);
            let other = *other.expect("another joint");
            Some(Input::Crank { pivot, other })
        }
        Some("length") => Some(Input::Length(index(&input["a"]), index(&input["b"]))),
        // The motion of the file is that of another input then.
        _ => None,
    });
    let names = joints.iter().enumerate();
    let names = names.map(|(index, joint)| match tool {
        "pyslvs" => format!("p{index}"),
        _ => joint.0.clone(),
    });
    let (names, fixed) = (names.collect(), list(&value["fixed"]));
    let (slots, inputs) = (straight.chain(curved).collect(), inputs.collect());
    let mut facts = Facts {
        size: size(&joints),
        joints,
        fixed,
        links,
        slots,
        inputs,
        names,
    };
    mark_guides(&mut facts);
    facts
}

/// A guide with one joint has a direction only with a point on its slot.
fn mark_guides(facts: &mut Facts) {
    for slot in &facts.slots {
        let Some(joints) = facts.links.get_mut(&slot.guide) else {
            continue;
        };
        if joints.len() == 1 && matches!(slot.path, Path::Direction(_)) {
            joints.push(facts.joints.len());
            facts
                .names
                .push(format!("line_of_{}", facts.names[slot.pin]));
            let position = facts.joints[slot.pin].1;
            facts.joints.push(("line".to_owned(), position));
        }
    }
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

fn size(joints: &[(String, [f64; 2])]) -> f64 {
    let pairs = joints
        .iter()
        .flat_map(|a| joints.iter().map(move |b| (a.1, b.1)));
    let distances = pairs.map(|(a, b)| (b[0] - a[0]).hypot(b[1] - a[1]));
    distances.fold(0.0, f64::max)
}
