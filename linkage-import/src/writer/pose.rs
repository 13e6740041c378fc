//! The drawn pose of a document, with the names of its text.

use crate::document::{Document, FRAME, InputKind, SlotPath};
use crate::drawn::{Drawn, DrawnPoint, Drive, Measure};

use super::drive;
use super::parts::ordered;
use super::spelling::Spelling;

/// Returns the joints where they are drawn, and the coordinates that inputs drive.
pub(super) fn drawn(document: &Document, spelling: &Spelling, drives: &[drive::Drive]) -> Drawn {
    let joints = document.joints.iter().enumerate();
    let points = joints.map(|(index, joint)| DrawnPoint {
        name: spelling.joints[index].clone(),
        position: [joint.position[0], joint.position[1], 0.0],
        is_fixed: document.is_fixed(index),
    });
    let measured = drives.iter().filter_map(|drive| {
        let (leader, rate) = drive.leader.clone().unwrap_or((drive.name.clone(), 1.0));
        Some(Drive {
            input: leader,
            rate,
            measure: measure(document, drives, drive)?,
        })
    });
    Drawn {
        function: "points",
        unit: document.unit.name(),
        band: document.band,
        points: points.collect(),
        drives: measured.collect(),
    }
}

fn measure(document: &Document, drives: &[drive::Drive], drive: &drive::Drive) -> Option<Measure> {
    let base = |link: usize| match ordered(document, drives, link)[..] {
        [first, second, ..] if link != FRAME => Some([first, second]),
        _ => None,
    };
    match drive.kind {
        InputKind::Crank {
            pivot, base: from, ..
        } => Some(Measure::Turn {
            pivot,
            point: drive.target?,
            axis: [0.0, 0.0, 1.0],
            base: base(from),
        }),
        InputKind::Length { link } => match document.links[link].joints[..] {
            [first, second, ..] => Some(Measure::Distance([first, second])),
            _ => None,
        },
        InputKind::Position { slot } => {
            let slot = &document.slots[slot];
            let (direction, origin) = match slot.path {
                SlotPath::Joints(first, second) => (document.direction(first, second), Some(first)),
                SlotPath::Direction(direction, _, through) => (direction, through),
                SlotPath::Arc { .. } => return None,
            };
            let (sin, cos) = direction.sin_cos();
            Some(Measure::Shift {
                point: slot.pin,
                origin,
                along: [cos, sin, 0.0],
                base: base(slot.guide),
            })
        }
    }
}
