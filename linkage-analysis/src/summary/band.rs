//! The intervals in which a quantity is between two bounds.

use super::curve::Curve;
use super::interval::Interval;
use super::monotone_pieces::{PieceEnd, crossing_input, monotone_pieces};
use alloc::vec::Vec;

/// The intervals of [`Curve::within`].
pub(super) fn within<const N: usize, F: Fn(f64) -> [f64; N]>(
    curve: &Curve<N, F>,
    low: f64,
    high: f64,
) -> Vec<Interval> {
    let mut found: Vec<[f64; 2]> = Vec::new();
    for part in &curve.solved {
        let mut inside = inside(curve, &monotone_pieces(part), [low, high]);
        let ends = [
            part.interval.nodes[0],
            part.interval.nodes[part.interval.nodes.len() - 1],
        ];
        let joins = part.interval.whole && inside.len() > 1;
        if joins && inside[0][0] == ends[0].u && inside[inside.len() - 1][1] == ends[1].u {
            // The cycle was cut open in the middle of it.
            let [_, end] = inside.remove(0);
            if let Some(last) = inside.last_mut() {
                last[1] = end + curve.source.width();
            }
        }
        found.extend(inside);
    }
    let interval = |ends: &[f64; 2]| {
        if curve.is_cycle() && ends[1] - ends[0] >= curve.source.width() {
            Interval::whole(&curve.source)
        } else {
            Interval::between(&curve.source, ends[0], ends[1])
        }
    };
    let mut intervals: Vec<Interval> = found.iter().map(interval).collect();
    intervals.sort_by(|a, b| a.from.total_cmp(&b.from));
    intervals
}

/// The parts of a chain within the bounds.
fn inside<const N: usize, F: Fn(f64) -> [f64; N]>(
    curve: &Curve<N, F>,
    chain: &[PieceEnd<N>],
    bounds: [f64; 2],
) -> Vec<[f64; 2]> {
    let mut cuts: Vec<f64> = chain.iter().map(PieceEnd::u).collect();
    let seam = curve.source.advance.filter(|&advance| advance != 0.0);
    let high = curve.source.high;
    let over_seam =
        cuts.first().is_some_and(|&u| u < high) && cuts.last().is_some_and(|&u| u > high);
    if seam.is_some() && over_seam {
        cuts.push(high);
    }
    // Beyond the seam of a cycle over which it advances, the quantity is higher by that.
    let shift = |u: f64| seam.filter(|_| u > curve.source.high).unwrap_or(0.0);
    let shifts = [0.0, seam.unwrap_or(0.0)];
    for pair in chain.windows(2) {
        let [a, b] = [&pair[0].node, &pair[1].node];
        for bound in bounds
            .iter()
            .flat_map(|bound| shifts.map(|shift| bound + shift))
        {
            if (a.jet[0] - bound) * (b.jet[0] - bound).signum() < 0.0 {
                cuts.push(crossing_input(&curve.source, a, b, bound));
            }
        }
    }
    cuts.sort_by(f64::total_cmp);
    cuts.dedup();
    let mut found: Vec<[f64; 2]> = Vec::new();
    for pair in cuts.windows(2) {
        let middle = pair[0] + 0.5 * (pair[1] - pair[0]);
        let value = curve.source.node(middle).jet[0] - shift(middle);
        if !(value >= bounds[0] && value <= bounds[1]) {
            continue;
        }
        match found.last_mut() {
            Some(last) if last[1] == pair[0] && pair[0] != seam_input(curve) => last[1] = pair[1],
            _ => found.push([pair[0], pair[1]]),
        }
    }
    found
}

/// The end of a range over which the quantity advances: intervals end there although the quantity
/// goes on.
fn seam_input<const N: usize, F: Fn(f64) -> [f64; N]>(curve: &Curve<N, F>) -> f64 {
    match curve.source.advance {
        Some(advance) if advance != 0.0 => curve.source.high,
        _ => f64::NAN,
    }
}
