//! Where a quantity lies between two bounds.

use super::course::Course;
use super::interval::Interval;
use super::stations::{Station, passing, stations};
use alloc::vec::Vec;

/// The intervals of [`Course::within`].
pub(super) fn within<const N: usize, F: Fn(f64) -> [f64; N]>(
    course: &Course<N, F>,
    low: f64,
    high: f64,
) -> Vec<Interval> {
    let mut found: Vec<[f64; 2]> = Vec::new();
    for part in &course.solved {
        let mut inside = inside(course, &stations(part), [low, high]);
        let ends = [
            part.stretch.nodes[0],
            part.stretch.nodes[part.stretch.nodes.len() - 1],
        ];
        let joins = part.stretch.whole && inside.len() > 1;
        if joins && inside[0][0] == ends[0].u && inside[inside.len() - 1][1] == ends[1].u {
            // The cycle was cut open in the middle of it.
            let [_, end] = inside.remove(0);
            if let Some(last) = inside.last_mut() {
                last[1] = end + course.source.width();
            }
        }
        found.extend(inside);
    }
    let interval = |ends: &[f64; 2]| {
        if course.is_cycle() && ends[1] - ends[0] >= course.source.width() {
            Interval::whole(&course.source)
        } else {
            Interval::of(&course.source, ends[0], ends[1])
        }
    };
    let mut intervals: Vec<Interval> = found.iter().map(interval).collect();
    intervals.sort_by(|a, b| a.from.total_cmp(&b.from));
    intervals
}

/// The parts of a chain within the bounds.
fn inside<const N: usize, F: Fn(f64) -> [f64; N]>(
    course: &Course<N, F>,
    chain: &[Station<N>],
    bounds: [f64; 2],
) -> Vec<[f64; 2]> {
    let mut cuts: Vec<f64> = chain.iter().map(Station::u).collect();
    let seam = course.source.advance.filter(|&advance| advance != 0.0);
    let high = course.source.high;
    let over_seam =
        cuts.first().is_some_and(|&u| u < high) && cuts.last().is_some_and(|&u| u > high);
    if seam.is_some() && over_seam {
        cuts.push(high);
    }
    // Beyond the seam of a cycle over which it advances, the quantity is higher by that.
    let shift = |u: f64| seam.filter(|_| u > course.source.high).unwrap_or(0.0);
    let shifts = [0.0, seam.unwrap_or(0.0)];
    for pair in chain.windows(2) {
        let [a, b] = [&pair[0].node, &pair[1].node];
        for bound in bounds
            .iter()
            .flat_map(|bound| shifts.map(|shift| bound + shift))
        {
            if (a.jet[0] - bound) * (b.jet[0] - bound).signum() < 0.0 {
                cuts.push(passing(&course.source, a, b, bound));
            }
        }
    }
    cuts.sort_by(f64::total_cmp);
    cuts.dedup();
    let mut found: Vec<[f64; 2]> = Vec::new();
    for pair in cuts.windows(2) {
        let middle = pair[0] + 0.5 * (pair[1] - pair[0]);
        let value = course.source.at(middle).jet[0] - shift(middle);
        if !(value >= bounds[0] && value <= bounds[1]) {
            continue;
        }
        match found.last_mut() {
            Some(last) if last[1] == pair[0] && pair[0] != seam_input(course) => last[1] = pair[1],
            _ => found.push([pair[0], pair[1]]),
        }
    }
    found
}

/// Where intervals end although the quantity goes on: at the end of a range over which it advances.
fn seam_input<const N: usize, F: Fn(f64) -> [f64; N]>(course: &Course<N, F>) -> f64 {
    match course.source.advance {
        Some(advance) if advance != 0.0 => course.source.high,
        _ => f64::NAN,
    }
}
