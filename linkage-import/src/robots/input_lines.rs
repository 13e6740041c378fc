//! Inputs of a robot: their ranges and their declarations.

use super::input_ranges::{common_share, reach};
use super::model::Motion;
use super::wording::{Sections, Wording};
use crate::names::{in_comment, shown};
use crate::number::plain;

/// A limit of an angle without limits, in radians: a turn.
const TURN: f64 = core::f64::consts::TAU;

/// The range to each side of the drawing if a search is ended: in radians, and as a part of the
/// size.
const SMALL_TURN: f64 = core::f64::consts::TAU / 72.0;
const SMALL_PART: f64 = 0.05;

/// The part of a reach that is left out next to a dead point.
const BESIDE: f64 = 0.97;

/// The range of an input.
struct Limits {
    ends: [f64; 2],
    is_cut: bool,
    is_turn: bool,
    is_length: bool,
}

impl Wording<'_> {
    /// The declarations of the inputs, with the ranges in which the loops close.
    pub(super) fn inputs(&self, sections: &mut Sections) {
        let indices = &self.analysis.inputs;
        let limits: Vec<Limits> = indices.iter().map(|index| self.limits(*index)).collect();
        let shared: Vec<(usize, [f64; 2])> = indices
            .iter()
            .zip(&limits)
            .filter(|(index, _)| self.is_in_loop(**index))
            .map(|(index, limits)| (*index, limits.ends))
            .collect();
        let share = common_share(self.chain, self.analysis, &shared);
        if share < 1.0 {
            sections.warnings.push(
                "the ranges of the inputs are shortened, so that the loops close for all of them together"
                    .to_owned(),
            );
        }
        if self.analysis.effort.is_spent() {
            sections.warnings.push(
                "the robot is too large for a search of ranges: set those of the inputs".to_owned(),
            );
        }
        for (index, limits) in indices.iter().zip(limits) {
            let share = if self.is_in_loop(*index) { share } else { 1.0 };
            self.input(*index, limits, share, sections);
        }
    }

    /// The limits of an input: those of its joint, as far as the loops close.
    fn limits(&self, index: usize) -> Limits {
        let coordinate = &self.chain.coordinates[index];
        let joint = self.chain.robot.bodies[coordinate.body].joint.as_ref();
        let is_length = joint.is_some_and(|joint| matches!(joint.motion, Motion::Slide(_)));
        let size = self.chain.size;
        let range = joint.and_then(|joint| joint.range);
        let declared = range.filter(|[low, high]| *low <= 0.0 && 0.0 <= *high && low < high);
        let free = if is_length { size } else { TURN };
        let (limits, is_turn) = match declared {
            Some([low, high]) => ([low.max(-free), high.min(free)], false),
            None if is_length => ([-size, size], false),
            None if self.is_one_of_several(index) => ([-TURN / 8.0, TURN / 8.0], false),
            None => ([-TURN / 2.0, TURN / 2.0], true),
        };
        // A joint of an open chain goes as far as its limits.
        let (found, is_cut) = match self.is_in_loop(index) {
            true => reach(self.chain, self.analysis, index, limits),
            false => (limits, false),
        };
        let is_spent = self.analysis.effort.is_spent();
        let small = if is_length {
            SMALL_PART * size
        } else {
            SMALL_TURN
        };
        let ends = [0, 1].map(|end| match found[end] == limits[end] {
            true => found[end],
            false if is_spent => limits[end].signum() * small.min(limits[end].abs()),
            false => BESIDE * found[end],
        });
        Limits {
            ends,
            is_cut: is_cut && !is_spent,
            is_turn: is_turn && !is_cut,
            is_length,
        }
    }

    /// True if an input moves loops that others move, too. Without limits in the file it gets an
    /// eighth of a turn to each side: over more, the box of all ranges has dead points.
    fn is_one_of_several(&self, index: usize) -> bool {
        self.analysis.inputs.len() > 1 && self.is_in_loop(index)
    }

    fn is_in_loop(&self, index: usize) -> bool {
        let rows = &self.analysis.rows;
        rows.iter().any(|row| row.changes[index] != 0.0)
    }

    fn input(&self, index: usize, limits: Limits, share: f64, sections: &mut Sections) {
        let coordinate = &self.chain.coordinates[index];
        let Some(joint) = &self.chain.robot.bodies[coordinate.body].joint else {
            return;
        };
        let name = &self.joints[coordinate.body];
        let written = |value: f64| match limits.is_length {
            true => format!("{}m", plain(rounded(value))),
            false => format!("{}deg", plain(rounded(value.to_degrees()))),
        };
        let [low, high] = limits.ends.map(|end| written(share * end));
        let range = match limits.is_turn && share == 1.0 {
            true => "0deg..360deg".to_owned(),
            false => format!("{low}..{high}"),
        };
        if limits.is_cut {
            sections.warnings.push(format!(
                "`{name}` goes from {low} to {high}: beyond, the loops do not close, or a dead point is near"
            ));
        }
        let zero = written(0.0);
        let shift = match joint.zero == 0.0 {
            true => String::new(),
            false => format!(", which is {} in the file", written(joint.zero)),
        };
        sections.inputs.push(format!(
            "input {name} = {zero} in {range};    // joint {}, from where it is drawn{shift}",
            in_comment(&shown(&joint.name))
        ));
    }
}

/// A number with six digits.
fn rounded(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}
