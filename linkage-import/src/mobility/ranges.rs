//! Ranges of inputs in which Newton steps from the drawing keep all links joined.

use std::cell::Cell;
use std::f64::consts::TAU;

use crate::document::{Document, InputKind};
use crate::driven_motions::{DrivenMotion, driven_motions, spread};

use super::built::system;
use super::constraints::{Pose, System};
use super::elimination::solve;
use super::motor_limits;

/// A step of a crank in radians, and of a length as a part of the size.
const ANGLE_STEP: f64 = TAU / 180.0;
const LENGTH_STEP: f64 = 0.01;
/// Steps are at least this part of the longest ones.
const SHORTEST: f64 = 64.0;
/// A length without bounds in the file moves by at most this part of the size.
const LONGEST: f64 = 0.5;

const MOST_ITERATIONS: usize = 12;
const SMALL_ERROR: f64 = 1e-11;
/// A body that moves further in a step is in another assembly.
const LARGEST_MOVE: f64 = 0.3;
/// Near dead points the pivots get small.
const SMALLEST_PIVOT: f64 = 1e-5;

/// A dead point is at the drawing if the way to it is shorter than this part of the margin.
const NEAR_DEAD_POINT: f64 = 0.5;

/// A range ends before a dead point, by this part of it.
const MARGIN: f64 = 0.03;

/// The effort of a search: some seconds.
const MOST_OPERATIONS: u64 = 5_000_000_000;

/// The parts of the ranges of single inputs that boxes of several inputs have.
const BOXES: [f64; 8] = [1.0, 0.7, 0.5, 0.35, 0.25, 0.15, 0.1, 0.05];
/// More inputs are not at corners of a box.
const MOST_CORNER_INPUTS: usize = 5;
/// Numbers of values of an input in the test of a box.
const BOX_VALUES: usize = 9;

/// Returns the change of each [motion](driven_motions) from the drawing, from the least to the greatest, in
/// radians or in the unit of length. Inputs that cannot move have equal bounds.
pub(crate) fn ranges(document: &Document) -> Option<Vec<[f64; 2]>> {
    let kinds: Vec<InputKind> = document.inputs.iter().map(|input| input.kind).collect();
    let system = system(document, &kinds)?;
    let drawn = system.drawn();
    let rows = system.rows(&drawn, &vec![0.0; kinds.len()]);
    let solution = solve(rows, system.unknowns());
    if solution.rank < system.unknowns() || kinds.is_empty() {
        return None;
    }
    let motions = driven_motions(document);
    let walk = Walk {
        system: &system,
        motions: &motions,
        left: Cell::new(MOST_OPERATIONS),
        rank: solution.rank,
        is_negative: solution.is_negative,
    };
    let mut ranges = Vec::new();
    for motion in 0..motions.len() {
        ranges.push(single(&walk, document, motion));
    }
    if motions.len() > 1 {
        let fits = |part: &&f64| is_box(&walk, &scaled(&ranges, **part));
        let part = BOXES.iter().find(fits).copied().unwrap_or(0.0);
        ranges = scaled(&ranges, part);
    }
    for (motion, range) in motions.iter().zip(&mut ranges) {
        if !matches!(kinds[motion.leader], InputKind::Crank { .. }) {
            *range = range.map(|bound| bound * system.size());
        }
    }
    Some(ranges)
}

fn scaled(ranges: &[[f64; 2]], part: f64) -> Vec<[f64; 2]> {
    let ranges = ranges.iter();
    ranges
        .map(|range| range.map(|bound| bound * part))
        .collect()
}

struct Walk<'t> {
    system: &'t System,
    motions: &'t [DrivenMotion],
    /// Operations that are left.
    left: Cell<u64>,
    rank: usize,
    /// The sign of the determinant in the drawing.
    is_negative: bool,
}

impl Walk<'_> {
    /// Returns the pose of other values of the motions, which are near those of a pose.
    fn step(&self, pose: &Pose, values: &[f64]) -> Option<Pose> {
        let mut next = pose.clone();
        let values = &spread(self.motions, values)[..];
        for _ in 0..MOST_ITERATIONS {
            let rows = self.system.rows(&next, values);
            let error = rows
                .iter()
                .map(|row| row.last().copied().unwrap_or(0.0).abs());
            let error = error.fold(0.0, f64::max);
            let unknowns = self.system.unknowns() as u64;
            let cost = unknowns * unknowns * rows.len() as u64;
            self.left.set(self.left.get().checked_sub(cost)?);
            let is_square = rows.len() == self.system.unknowns();
            let solution = solve(rows, self.system.unknowns());
            if solution.rank < self.rank || solution.smallest_pivot < SMALLEST_PIVOT {
                return None;
            }
            if error < SMALL_ERROR {
                let moves = next.iter().zip(pose).map(|(new, old)| (new - old).abs());
                let is_near = moves.fold(0.0, f64::max) < LARGEST_MOVE;
                let is_same = !is_square || solution.is_negative == self.is_negative;
                return (is_near && is_same).then_some(next);
            }
            for (value, step) in next.iter_mut().zip(&solution.step) {
                *value += step;
            }
            if next.iter().any(|value| !value.is_finite()) {
                return None;
            }
        }
        None
    }

    /// Returns the pose at the end of a straight way between values of the motions.
    fn walk(&self, pose: &Pose, from: &[f64], to: &[f64]) -> Option<Pose> {
        let way: Vec<f64> = from.iter().zip(to).map(|(a, b)| b - a).collect();
        let way = spread(self.motions, &way).into_iter();
        let longest = way.map(f64::abs);
        let steps = (longest.fold(0.0, f64::max) / (3.0 * ANGLE_STEP))
            .ceil()
            .max(1.0);
        let mut pose = pose.clone();
        for index in 1..=steps as usize {
            let part = index as f64 / steps;
            let values = from.iter().zip(to).map(|(a, b)| a + part * (b - a));
            pose = self.step(&pose, &values.collect::<Vec<_>>())?;
        }
        Some(pose)
    }
}

/// Returns the range of one motion while the others stay.
fn single(walk: &Walk, document: &Document, motion: usize) -> [f64; 2] {
    let size = walk.system.size();
    let DrivenMotion {
        leader: input,
        ref followers,
        turns,
    } = walk.motions[motion];
    let turns = f64::from(turns) * TAU;
    let kind = document.inputs[input].kind;
    let (step, bounds) = match kind {
        InputKind::Crank { .. } => {
            let ratios = followers.iter().map(|(_, ratio)| ratio.abs());
            let within = |bound| motor_limits::limited(document, &walk.motions[motion], bound);
            let bounds = [-turns, turns].map(within);
            (ANGLE_STEP / ratios.fold(1.0, f64::max), bounds)
        }
        InputKind::Length { link } => {
            let joints = &document.links[link].joints;
            let length = document.distance(joints[0], joints[1]) / size;
            let travel = document.inputs[input].travel;
            let travel = travel.map(|travel| travel.map(|bound| bound / size));
            let [low, high] = travel.unwrap_or([-LONGEST, LONGEST]);
            (LENGTH_STEP, [low.max(-0.9 * length), high])
        }
        InputKind::Position { .. } => {
            let travel = document.inputs[input].travel;
            let travel = travel.map(|travel| travel.map(|bound| bound / size));
            (LENGTH_STEP, travel.unwrap_or([-LONGEST, LONGEST]))
        }
    };
    let is_crank = matches!(kind, InputKind::Crank { .. });
    let reach = bounds.map(|bound| reached(walk, motion, bound, step));
    let is_limited = bounds != [-turns, turns];
    if is_crank
        && !is_limited
        && reach
            .iter()
            .any(|end| end.is_end && is_whole_turn(&end.pose))
    {
        // A whole turn in one sense is a whole turn in the other one.
        return [-0.5 * turns, 0.5 * turns];
    }
    let [low, high] = &reach;
    let margin = MARGIN * (high.value - low.value);
    let bounds = reach.each_ref().map(|end| {
        if end.is_end || end.value.abs() <= margin {
            end.value
        } else {
            end.value - margin.copysign(end.value)
        }
    });
    // A table of positions needs short steps where it begins at a dead point.
    let is_dead = |end: &Reached| !end.is_end && end.value.abs() < NEAR_DEAD_POINT * margin;
    if is_crank && (is_dead(low) || is_dead(high)) {
        return bounds.map(|bound| bound.clamp(-0.25 * TAU, 0.25 * TAU));
    }
    bounds
}

/// Returns true if all bodies are back, up to whole turns.
fn is_whole_turn(pose: &Pose) -> bool {
    const CLOSE: f64 = 1e-6;
    pose.iter().enumerate().all(|(index, value)| {
        let turned = if index % 3 == 2 {
            value - TAU * (value / TAU).round()
        } else {
            *value
        };
        turned.abs() < CLOSE
    })
}

/// The end of a walk.
struct Reached {
    value: f64,
    /// True if it is the bound.
    is_end: bool,
    pose: Pose,
}

/// Walks towards a bound, to the last value that is reached.
fn reached(walk: &Walk, motion: usize, bound: f64, step: f64) -> Reached {
    let mut end = Reached {
        value: 0.0,
        is_end: false,
        pose: walk.system.drawn(),
    };
    let mut length = step;
    while end.value.abs() < bound.abs() {
        let next = (end.value.abs() + length).min(bound.abs()).copysign(bound);
        let mut values = vec![0.0; walk.motions.len()];
        values[motion] = next;
        match walk.step(&end.pose, &values) {
            Some(pose) => {
                end.pose = pose;
                end.value = next;
            }
            // Near dead points steps get shorter.
            None if length > step / SHORTEST => length *= 0.5,
            None => return end,
        }
    }
    end.is_end = true;
    end
}

/// Returns true if a raster of a box can be reached: all pairs of two inputs, and corners of more.
fn is_box(walk: &Walk, ranges: &[[f64; 2]]) -> bool {
    let drawn = walk.system.drawn();
    let zero = vec![0.0; ranges.len()];
    if let [first, _] = ranges {
        return (0..BOX_VALUES).all(|index| {
            let part = index as f64 / (BOX_VALUES - 1) as f64;
            let value = first[0] + part * (first[1] - first[0]);
            let Some(pose) = walk.walk(&drawn, &zero, &[value, 0.0]) else {
                return false;
            };
            let mut ends = ranges[1].iter();
            ends.all(|end| walk.walk(&pose, &[value, 0.0], &[value, *end]).is_some())
        });
    }
    // The first inputs, since corners double with each.
    let corners = 1usize << ranges.len().min(MOST_CORNER_INPUTS);
    (0..corners).all(|corner| {
        let values = ranges.iter().enumerate();
        let values = values.map(|(index, range)| range[corner >> index.min(63) & 1]);
        walk.walk(&drawn, &zero, &values.collect::<Vec<_>>())
            .is_some()
    })
}
