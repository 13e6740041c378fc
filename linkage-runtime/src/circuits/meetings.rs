//! Change points, where two assemblies meet and both go on: a group has one solution there instead
//! of two.

use super::branch::Meeting;
use super::leaf::{GroupAssembly, Leaf};
use super::levels::Levels;
use super::unknowns::{near, numbers, size};
use crate::range_check::touches;
use alloc::vec::Vec;
use linkage_core::range_check::{AT_END, samples};
use linkage_core::{Cycle, Level};

/// Greatest distance between the positions of two assemblies where they meet, relative to their
/// size. Half of the digits are known there, and later groups may enlarge the error.
const SAME: f64 = 1e-5;

/// The inputs at which a group with two solutions has one, for given assemblies of the groups
/// before it over a stretch of the input.
struct Touched<'a> {
    group: usize,
    before: &'a [(usize, GroupAssembly)],
    inputs: [f64; 2],
    inputs_touched: Vec<f64>,
}

/// All pairs of assemblies that meet inside a range. `assemblies` are those of the leaves.
pub(super) fn meetings<M: Levels>(
    mechanism: &M,
    cycle: &Cycle,
    leaves: &[Leaf],
    assemblies: &[M::Assembly],
) -> Vec<Meeting> {
    let levels = mechanism.searched().levels;
    let mut known: Vec<Touched<'_>> = Vec::new();
    let mut found: Vec<Meeting> = Vec::new();
    for (one, leaf) in leaves.iter().enumerate() {
        for (index_of_way, (group, way)) in leaf.ways.iter().enumerate() {
            if !matches!(levels[*group], Level::Modes(_)) {
                continue;
            }
            let before = &leaf.ways[..index_of_way];
            let same = |touched: &Touched<'_>| {
                touched.group == *group && touched.before == before && touched.inputs == leaf.inputs
            };
            let index = known.iter().position(same).unwrap_or_else(|| {
                let slack = |x: f64| mechanism.slack(&assemblies[one], *group, x);
                known.push(Touched {
                    group: *group,
                    before,
                    inputs: leaf.inputs,
                    inputs_touched: change_points(cycle, leaf.inputs, &slack),
                });
                known.len() - 1
            });
            for (other, second) in leaves.iter().enumerate().skip(one + 1) {
                let turned = second
                    .ways
                    .get(index_of_way)
                    .is_some_and(|(_, other_way)| other_way != way);
                if !turned || second.ways[..index_of_way] != *before {
                    continue;
                }
                let at: Vec<f64> = known[index]
                    .inputs_touched
                    .iter()
                    .copied()
                    .filter(|&x| {
                        let [low, high] = second.inputs;
                        let [here, there] =
                            [one, other].map(|k| numbers(mechanism, &assemblies[k], x));
                        let size = size(&here).max(size(&there));
                        low <= x && x <= high && near(&here, &there, size, SAME)
                    })
                    .collect();
                if !at.is_empty() {
                    found.push(Meeting {
                        branches: [one, other],
                        at,
                    });
                }
            }
        }
    }
    found.sort_by_key(|meeting| meeting.branches);
    found
}

/// The inputs between two limits at which a slack touches zero. The ends of a turn are one input.
fn change_points(cycle: &Cycle, [low, high]: [f64; 2], slack: &dyn Fn(f64) -> f64) -> Vec<f64> {
    let count = samples(high - low, cycle.angle);
    let at = |k: usize| low + (high - low) * (k as f64 / count as f64);
    let sizes = (0..=count).map(|k| slack(at(k)).abs());
    let largest = sizes.fold(0.0, f64::max);
    if largest == 0.0 {
        return Vec::new();
    }
    let near = |x: f64, end: f64| (x - end).abs() < AT_END * (cycle.high - cycle.low);
    let snapped = |x: f64| {
        let ends = [cycle.low, cycle.high];
        ends.into_iter().find(|&end| near(x, end)).unwrap_or(x)
    };
    let inputs = touches([low, high], count, &mut |x| slack(x) / largest);
    let mut inputs: Vec<f64> = inputs.into_iter().map(snapped).collect();
    if cycle.turn().is_some() && inputs.first() == Some(&cycle.low) {
        inputs.retain(|&x| x != cycle.high);
    }
    inputs
}
