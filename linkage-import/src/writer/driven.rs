//! Inputs: their values in the drawing, and ranges in which the mechanism stays together.

use crate::document::{Document, FRAME, InputKind, SlotPath};
use crate::mobility;
use crate::names::{in_comment, shown};
use crate::number::plain;

use super::spelling::Spelling;
use super::wrapped::comment;

/// An input as text.
pub(super) struct Drive {
    pub(super) name: String,
    /// The item of the input, below a comment.
    pub(super) line: String,
    pub(super) kind: InputKind,
    /// The expression of the clause `at` or `length` where the input is used.
    pub(super) clause: String,
    /// The joint that a crank points to from its pivot.
    pub(super) target: Option<usize>,
    /// The value in the drawing with its unit.
    value: String,
}

/// The range that is written where none is known, in degrees and as a part of a length.
const SMALL_ANGLE: f64 = 5.0;
const SMALL_PART: f64 = 0.05;

/// Returns the inputs, with warnings about those that cannot move.
pub(super) fn drives(document: &mut Document, spelling: &Spelling) -> Vec<Drive> {
    let ranges = mobility::ranges(document);
    if ranges.is_none() {
        explain(document);
    }
    let mut drives = Vec::new();
    for index in 0..document.inputs.len() {
        let range = ranges.as_ref().map(|ranges| ranges[index]);
        if range.is_some_and(|[low, high]| high - low < 1e-6) {
            document.warnings.push(format!(
                "`{}` cannot move from the drawing, or only by very little: set its range",
                spelling.inputs[index]
            ));
        }
        let drive = match document.inputs[index].kind {
            InputKind::Crank { link, pivot, base } => {
                crank(document, spelling, index, [link, pivot, base], range)
            }
            InputKind::Length { link } => {
                let joints = &document.links[link].joints;
                let length = document.distance(joints[0], joints[1]);
                let ends = [joints[0], joints[1]].map(|joint| spelling.joints[joint].clone());
                let about = format!("the distance of {} and {}", ends[0], ends[1]);
                linear(document, spelling, index, length, range, &about)
            }
            InputKind::Position { slot } => {
                let position = position(document, slot);
                let pin = &spelling.joints[document.slots[slot].pin];
                let about = format!("the position of {pin} in its slot");
                linear(document, spelling, index, position, range, &about)
            }
        };
        drives.push(drive);
    }
    drives
}

/// Several motors run together in the file: their angles as functions of one time.
pub(super) fn together(document: &Document, drives: &[Drive], text: &mut String) {
    let motors = drives.iter().zip(&document.inputs);
    let motors = motors.filter_map(|(drive, input)| {
        let rate = input.rate?;
        let sign = if rate < 0.0 { '-' } else { '+' };
        let Drive { name, value, .. } = drive;
        Some(format!(
            "{name} = {value} {sign} {}deg/s * t",
            plain(rate.abs())
        ))
    });
    let motors: Vec<String> = motors.collect();
    if motors.len() > 1 {
        let words = format!("In the file they run together: {}.", motors.join(", "));
        comment(text, "    // ", &words);
    }
    if drives.len() > 1 && motors.len() < drives.len() {
        let words = "Inputs without a rate move to and fro, or as the user of the program moves \
                     them: they are no functions of that time.";
        comment(text, "    // ", words);
    }
}

/// A warning for drawings whose mobility is not the number of their inputs.
fn explain(document: &mut Document) {
    let kinds: Vec<InputKind> = document.inputs.iter().map(|input| input.kind).collect();
    let warning = match mobility::mobility(document, &[]) {
        Some(0) => "nothing can move in the drawing: ranges of inputs are not known".to_owned(),
        Some(free) if free != kinds.len() => format!(
            "the drawing has the mobility {free} and {} inputs: ranges are not known",
            kinds.len()
        ),
        Some(_) => "the inputs do not determine the drawing, or it is at a dead point: ranges are \
                    not known"
            .to_owned(),
        None => "the drawing is too large for a search of ranges".to_owned(),
    };
    document.warnings.push(warning);
}

fn position(document: &Document, slot: usize) -> f64 {
    let slot = &document.slots[slot];
    match slot.path {
        SlotPath::Joints(first, second) => {
            let direction = document.direction(first, second);
            let to_pin = document.direction(first, slot.pin);
            document.distance(first, slot.pin) * (to_pin - direction).cos()
        }
        SlotPath::Direction(..) | SlotPath::Arc { .. } => 0.0,
    }
}

fn crank(
    document: &Document,
    spelling: &Spelling,
    index: usize,
    [link, pivot, base]: [usize; 3],
    range: Option<[f64; 2]>,
) -> Drive {
    let name = spelling.inputs[index].clone();
    let target = target(document, link, pivot);
    let direction = document.direction(pivot, target);
    let (reference, clause) = match document.links[base].joints[..] {
        [first, second, ..] if base != FRAME => (
            direction - document.direction(first, second),
            format!("{}.angle + {name}", spelling.links[base]),
        ),
        _ => (direction, name.clone()),
    };
    let mut reference = degrees(reference);
    let turn = |[low, high]: [f64; 2]| high - low > std::f64::consts::TAU - 1e-9;
    let (low, high) = match range {
        Some(range) if turn(range) => {
            if reference < 0.0 {
                reference = rounded(reference + 360.0, 1e-12);
            }
            (0.0, 360.0)
        }
        Some([low, high]) if high - low > 1e-6 => {
            let quantum = if high - low > 0.1 { 0.1 } else { 1e-4 };
            let [low, high] = [low, high].map(|bound| reference + bound.to_degrees());
            inside(low, high, reference, quantum)
        }
        _ => {
            let [low, high] = [-SMALL_ANGLE, SMALL_ANGLE].map(|change| reference + change);
            inside(low, high, reference, 0.1)
        }
    };
    let about = format!("{} about {}", spelling.links[link], spelling.joints[pivot]);
    let line = line(
        document,
        index,
        &name,
        [reference, low, high],
        "deg",
        &about,
    );
    Drive {
        name,
        line,
        kind: document.inputs[index].kind,
        clause,
        target: Some(target),
        value: format!("{}deg", plain(reference)),
    }
}

/// The joint that a crank points to: one that other links have, if there is any.
fn target(document: &Document, link: usize, pivot: usize) -> usize {
    let joints = document.links[link].joints.iter().copied();
    let others: Vec<usize> = joints
        .filter(|joint| *joint != pivot && document.distance(pivot, *joint) > 0.0)
        .collect();
    let shared = others
        .iter()
        .find(|joint| document.links_of(**joint).len() > 1);
    shared.or(others.first()).copied().unwrap_or(pivot)
}

fn linear(
    document: &Document,
    spelling: &Spelling,
    index: usize,
    reference: f64,
    range: Option<[f64; 2]>,
    about: &str,
) -> Drive {
    let name = spelling.inputs[index].clone();
    let size = document.largest_distance().map_or(1.0, |largest| largest.2);
    let reference = rounded(reference, 1e-14 * size.max(1e-3));
    let (low, high) = match range {
        Some([low, high]) if high - low > 1e-9 * size => {
            let quantum = 10f64.powf(((high - low) * 1e-3).log10().floor());
            inside(reference + low, reference + high, reference, quantum)
        }
        _ => (reference - SMALL_PART * size, reference + SMALL_PART * size),
    };
    let unit = document.unit.name();
    let line = line(document, index, &name, [reference, low, high], unit, about);
    Drive {
        clause: name.clone(),
        name,
        line,
        kind: document.inputs[index].kind,
        target: None,
        value: format!("{}{unit}", plain(reference)),
    }
}

fn line(
    document: &Document,
    index: usize,
    name: &str,
    [value, low, high]: [f64; 3],
    unit: &str,
    about: &str,
) -> String {
    let [value, low, high] = [value, low, high].map(plain);
    let speed = document.inputs[index].speed.as_deref();
    let speed = speed.map_or_else(String::new, |speed| format!("; {}", shown_speed(speed)));
    format!(
        "// {name}: {about}{speed}\n    input {name} = {value}{unit} in {low}{unit}..{high}{unit};"
    )
}

fn shown_speed(speed: &str) -> String {
    let speed = in_comment(speed);
    if speed.len() > 80 {
        shown(&speed)
    } else {
        speed
    }
}

/// Rounds bounds inwards to a multiple of a quantum, but never past the value of the drawing.
fn inside(low: f64, high: f64, value: f64, quantum: f64) -> (f64, f64) {
    let scale = 1.0 / quantum;
    let [low, high] = [(low * scale).ceil() / scale, (high * scale).floor() / scale];
    let [low, high] = [low, high].map(|bound| rounded(bound, quantum * 1e-6));
    (low.min(value), high.max(value))
}

/// Rounds to a power of ten.
fn rounded(value: f64, quantum: f64) -> f64 {
    let scale = 10f64.powf((-quantum.log10()).round());
    let rounded = (value * scale).round() / scale;
    if rounded.is_finite() { rounded } else { value }
}

/// Returns an angle in degrees between -180 and 180, without the noise of the last digits.
fn degrees(radians: f64) -> f64 {
    let degrees = radians.to_degrees();
    let turned = degrees - 360.0 * (degrees / 360.0).round();
    rounded(turned, 1e-12)
}
