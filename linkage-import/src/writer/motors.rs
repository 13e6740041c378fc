//! Motors: their angles in the drawing, and motors that run with another one.

use crate::document::{Document, FRAME, InputKind};
use crate::driven_motions::DrivenMotion;
use crate::number::plain;

use super::drive::{Drive, head, inside, line, rounded};
use super::spelling::Spelling;

/// The range to each side of the drawing that is written where none is known, in degrees.
const SMALL_ANGLE: f64 = 5.0;

/// A ratio of speeds with more letters is written as a quotient.
const MOST_DIGITS: usize = 6;

/// A crank in the drawing: its pivot, its link and the link that its angle is measured from.
struct Drawn {
    /// Degrees.
    reference: f64,
    clause: String,
    target: usize,
    about: String,
}

fn drawn(
    document: &Document,
    spelling: &Spelling,
    name: &str,
    [link, pivot, base]: [usize; 3],
) -> Drawn {
    let target = target(document, link, pivot);
    let direction = document.direction(pivot, target);
    let (reference, clause) = match first_two(document, base) {
        Some([first, second]) => (
            direction - document.direction(first, second),
            format!("{}.angle + {name}", spelling.links[base]),
        ),
        None => (direction, name.to_owned()),
    };
    Drawn {
        reference: degrees(reference),
        clause,
        target,
        about: format!("{} about {}", spelling.links[link], spelling.joints[pivot]),
    }
}

/// An input that turns a link about a pivot, with the range of its motion.
pub(super) fn crank(
    document: &Document,
    spelling: &Spelling,
    motion: &DrivenMotion,
    joined: [usize; 3],
    range: Option<[f64; 2]>,
) -> Drive {
    let index = motion.leader;
    let name = spelling.inputs[index].clone();
    let drawn = drawn(document, spelling, &name, joined);
    let mut reference = drawn.reference;
    let turn = |[low, high]: [f64; 2]| high - low > std::f64::consts::TAU - 1e-9;
    let (low, high) = match range {
        Some([low, high]) if turn([low, high]) => {
            if reference < 0.0 {
                reference = rounded(reference + 360.0, 1e-12);
            }
            let turns = f64::from(motion.turns);
            let is_period = ((high - low) / std::f64::consts::TAU - turns).abs() < 1e-9;
            (0.0, if is_period { 360.0 * turns } else { 360.0 })
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
    let line = line(
        document,
        index,
        &name,
        [reference, low, high],
        "deg",
        &drawn.about,
    );
    Drive {
        name,
        line,
        kind: document.inputs[index].kind,
        leader: None,
        clause: drawn.clause,
        target: Some(drawn.target),
        value: format!("{}deg", plain(reference)),
    }
}

/// A motor that runs with another one; nothing else has a speed.
pub(super) fn following(
    document: &Document,
    spelling: &Spelling,
    index: usize,
    motion: &DrivenMotion,
    leader: &Drive,
) -> Option<Drive> {
    let name = spelling.inputs[index].clone();
    let kind = document.inputs[index].kind;
    let InputKind::Crank { link, pivot, base } = kind else {
        return None;
    };
    let drawn = drawn(document, spelling, &name, [link, pivot, base]);
    let value = format!("{}deg", plain(drawn.reference));
    let [rate, of_leader] = [index, motion.leader].map(|input| document.inputs[input].rate);
    let [rate, of_leader] = [rate, of_leader].map(|rate| rate.unwrap_or_default());
    let sign = if (rate < 0.0) == (of_leader < 0.0) {
        '+'
    } else {
        '-'
    };
    let ratio = match plain(rate.abs() / of_leader.abs()) {
        short if short == "1" => String::new(),
        short if short.len() <= MOST_DIGITS => format!("{short} * "),
        _ => format!("{}/{} * ", plain(rate.abs()), plain(of_leader.abs())),
    };
    let about = head(document, index, &name, &drawn.about);
    let change = match leader.value.as_str() {
        "0deg" => leader.name.clone(),
        value => format!("({} - {value})", leader.name),
    };
    let line = format!("{about}\n    let {name} = {value} {sign} {ratio}{change};");
    Some(Drive {
        name,
        line,
        kind,
        leader: Some((leader.name.clone(), rate / of_leader)),
        clause: drawn.clause,
        target: Some(drawn.target),
        value,
    })
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

/// The first two joints of a link as they are written; none of the frame, which does not turn.
fn first_two(document: &Document, link: usize) -> Option<[usize; 2]> {
    let mut inputs = document.inputs.iter().rev();
    let as_crank = inputs.find_map(|input| match input.kind {
        InputKind::Crank {
            link: turned,
            pivot,
            ..
        } if turned == link => Some([pivot, target(document, link, pivot)]),
        _ => None,
    });
    match document.links[link].joints[..] {
        [first, second, ..] if link != FRAME => Some(as_crank.unwrap_or([first, second])),
        _ => None,
    }
}

/// Returns an angle in degrees between -180 and 180, without the noise of the last digits.
fn degrees(radians: f64) -> f64 {
    let degrees = radians.to_degrees();
    let turned = degrees - 360.0 * (degrees / 360.0).round();
    rounded(turned, 1e-12)
}
