//! The ends of assemblies. Beside a turning point input and place are smooth functions of the margin.

use super::{BranchEnd, Cycle, MEETING, SAME, near, size};
use alloc::vec::Vec;

/// An assembly ends at a turning point if it is not further away than this from where its margin vanishes, as a share of
/// the range.
const REACH: f64 = 1e-3;

/// Distances from the turning point of the positions that are looked at, as multiples of the first.
const DISTANCES: [f64; 6] = [1.0, 1.5, 2.2, 3.3, 5.0, 7.5];

/// The first of them, as a share of the range, at least.
const NEAREST: f64 = 1e-6;

/// Turning points of two assemblies that meet are located alike: they differ by less than this share of the range.
const TOGETHER: f64 = 1e-6;

/// Times that the turning point is located anew from where it was found to be.
const TIMES: usize = 3;

/// How far the last place before the end is from it, as a share of the range.
const INSIDE: f64 = 1e-11;

/// An end of an assembly.
pub(super) struct Side {
    pub(super) end: BranchEnd,
    /// The last input, about, at which there is a margin.
    pub(super) inside: f64,
    /// The place there, at the turning point if it is one.
    place: Vec<f64>,
    /// How large the numbers of the place are along the assembly.
    size: f64,
    side: f64,
}

impl Side {
    /// Finds out how an assembly ends that fails `at` an input, above or below (`side` 1 or -1). Its place at another input
    /// is `here`.
    pub(super) fn new(
        cycle: &Cycle,
        at: Option<f64>,
        side: f64,
        here: &[f64],
        margin: impl Fn(f64) -> f64,
        place: impl Fn(f64) -> Vec<f64>,
    ) -> Self {
        let range = cycle.high - cycle.low;
        let border = if side > 0.0 { cycle.high } else { cycle.low };
        let (end, inside, place) = match at {
            None => (BranchEnd::Range(border), border, place(border)),
            Some(at) => {
                let inside = at - side * INSIDE * range;
                let turning = first_estimate(at, side, range, &margin)
                    .and_then(|first| locate(first, at, side, range, &margin, &place));
                match turning {
                    Some((x, place)) => (BranchEnd::TurningPoint(x), inside, place),
                    None => (BranchEnd::Lost(at), inside, place(inside)),
                }
            }
        };
        Self {
            end,
            inside,
            size: size(&place).max(size(here)),
            place,
            side,
        }
    }

    /// Whether two turning points face each other across a narrow gap.
    pub(super) fn faces(&self, other: &Self, cycle: &Cycle) -> bool {
        match (self.end, other.end) {
            (BranchEnd::TurningPoint(a), BranchEnd::TurningPoint(b)) => {
                self.side != other.side && (a - b).abs() <= REACH * (cycle.high - cycle.low)
            }
            _ => false,
        }
    }

    /// It was no turning point.
    pub(super) fn lose(&mut self) {
        self.end = BranchEnd::Lost(self.inside);
    }

    /// Whether two assemblies, or two ends of one, continue each other here.
    pub(super) fn meets(&self, other: &Self, cycle: &Cycle) -> bool {
        let range = cycle.high - cycle.low;
        let size = self.size.max(other.size);
        match (self.end, other.end) {
            (BranchEnd::TurningPoint(a), BranchEnd::TurningPoint(b)) => {
                let here = self.side == other.side && (a - b).abs() <= TOGETHER * range;
                here && near(&self.place, &other.place, size, MEETING)
            }
            (BranchEnd::Range(_), BranchEnd::Range(_)) => {
                let seam = cycle.is_turn() && self.side != other.side;
                seam && near(&self.place, &other.place, size, SAME)
            }
            _ => false,
        }
    }
}

/// Where the square of the margin vanishes, seen from two positions.
fn first_estimate(at: f64, side: f64, range: f64, margin: impl Fn(f64) -> f64) -> Option<f64> {
    let step = 1e-5 * range;
    let square = |distance: f64| {
        let margin = margin(at - side * distance);
        margin * margin
    };
    let (near, far) = (square(step), square(2.0 * step));
    let beyond = near * step / (far - near) - step;
    (beyond.abs() <= REACH * range).then_some(at + side * beyond)
}

/// The turning point and the place there, as polynomials of the margin.
fn locate(
    first: f64,
    at: f64,
    side: f64,
    range: f64,
    margin: impl Fn(f64) -> f64,
    place: impl Fn(f64) -> Vec<f64>,
) -> Option<(f64, Vec<f64>)> {
    let mut x = first;
    let mut there = Vec::new();
    for _ in 0..TIMES {
        let nearest = ((x - at) * side).max(0.0) + NEAREST * range;
        let inputs = DISTANCES.map(|distance| x - side * distance * nearest);
        let margins = inputs.map(&margin);
        let weights = weights(&margins);
        let sum = |value: &dyn Fn(usize) -> f64| -> f64 {
            weights
                .iter()
                .enumerate()
                .map(|(k, weight)| weight * value(k))
                .sum()
        };
        x = first + sum(&|k| inputs[k] - first);
        let places = inputs.map(&place);
        there = (0..places[0].len())
            .map(|index| sum(&|k| places[k][index]))
            .collect();
    }
    let near = (x - first).abs() <= REACH * range;
    near.then_some((x, there))
}

/// Weights of values at these margins that give the value at margin 0: Lagrange's polynomial.
fn weights(margins: &[f64; DISTANCES.len()]) -> [f64; DISTANCES.len()] {
    let mut weights = [1.0; DISTANCES.len()];
    for (one, weight) in weights.iter_mut().enumerate() {
        for (other, margin) in margins.iter().enumerate() {
            if other != one {
                *weight *= margin / (margin - margins[one]);
            }
        }
    }
    weights
}
