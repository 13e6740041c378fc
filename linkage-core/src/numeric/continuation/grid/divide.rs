//! How finely the ranges are divided.

use super::super::cell::Frame;
use super::super::follow::Follower;
use super::super::scale::Scale;
use super::LeftOut;
use super::cells::{Cell, Sum};
use super::feasibility::{Feasibility, feasibility};
use super::fit::Fit;
use super::layout::{Layout, Places};
use super::terms::Terms;
use super::walk::{Solution, fill};
use alloc::vec;
use alloc::vec::Vec;

/// Cells of a grid, at most.
pub(super) const CELLS: usize = 1 << 12;

/// Up to so many cells, which take two milliseconds, nothing is left out and the boundary of the solution is looked at closely.
const FEW: usize = 64;

/// The same for polynomials, which take ten milliseconds.
const FEW_POLYNOMIALS: usize = 256;

/// Before more places than these are looked at, a few cells say whether the ranges can be served at all; before any, where a cell takes as long as that
/// many places.
const MANY: usize = 256;

/// The share of places on the borders of more cells at which the solution may be left out although it exists: near its boundary it always
/// is at some. A grid that leaves out more even away from boundaries is not what was declared.
pub(super) const MISSED: f64 = 0.005;

/// A grid of twice as many cells takes less than so many times the corrections.
const GROWTH: usize = 3;

/// The ranges in cells.
pub(super) struct Divided {
    pub(super) axes: Vec<Scale>,
    pub(super) cells: Vec<Cell>,
    pub(super) sum: Sum,
    /// What a look at a few places has shown not to be served by any cells.
    hopeless: Option<LeftOut>,
}

impl Divided {
    /// What should be served and is not.
    pub(super) fn left_out(&self) -> Option<LeftOut> {
        if self.hopeless.is_some() {
            return self.hopeless.clone();
        }
        let share = self.sum.share(self.sum.regular);
        let worst = self.sum.worst.filter(|_| share > MISSED)?;
        let layout = Layout(&self.axes);
        let centre = layout.centre(&layout.slots(worst));
        let at = match &self.cells[worst].example {
            Some(offsets) => layout.moved(&centre, offsets),
            None => centre,
        };
        Some(LeftOut { share, at })
    }

    /// Whether smaller cells are wanted.
    fn is_coarse(&self, terms: Terms) -> bool {
        let sum = &self.sum;
        let few = match terms {
            Terms::Slopes => FEW,
            Terms::Polynomials => FEW_POLYNOMIALS,
        };
        sum.served == 0
            || sum.share(sum.left_out) > MISSED
            || (sum.left_out > 0 || sum.boundary) && self.cells.len() < few
    }
}

/// Divides the ranges until the solution is served wherever it exists, or as far as cells and corrections go. Each range is given with
/// whether it is a full turn. Where `all` of the ranges must be served and cannot be, nothing is.
pub(super) fn divided(
    follower: &mut Follower<'_>,
    ranges: &[(Frame, bool)],
    reference: &Solution<'_>,
    fit: &Fit,
    all: bool,
) -> Divided {
    let places = Places::new(ranges.len());
    let mut counts: Vec<u32> = ranges.iter().map(|(frame, _)| start(frame)).collect();
    let mut asked = !all;
    loop {
        let axes = scales(ranges, &counts);
        let layout = Layout(&axes);
        let many =
            layout.cells() * places.offsets.len() > MANY || fit.terms() == Terms::Polynomials;
        if !asked && many {
            asked = true;
            match feasibility(follower, ranges, &counts, (&places, fit), reference) {
                Feasibility::From(next) => {
                    counts = next;
                    continue;
                }
                Feasibility::Hopeless(left_out) => {
                    let cells = vec![Cell::default(); layout.cells()];
                    let sum = Sum::new(&cells, &layout, places.offsets.len());
                    return Divided {
                        axes,
                        cells,
                        sum,
                        hopeless: Some(left_out),
                    };
                }
            }
        }
        let left = follower.left();
        let cells = fill(follower, &axes, (&places, fit), reference);
        let taken = left - follower.left();
        let sum = Sum::new(&cells, &layout, places.offsets.len());
        let divided = Divided {
            axes,
            cells,
            sum,
            hopeless: None,
        };
        let full = 2 * divided.cells.len() > CELLS || GROWTH * taken > follower.left();
        match longest(&divided.sum.bends, &counts) {
            Some(axis) if divided.is_coarse(fit.terms()) && !full => counts[axis] *= 2,
            _ => return divided,
        }
    }
}

/// The ranges in so many cells each.
pub(super) fn scales(ranges: &[(Frame, bool)], counts: &[u32]) -> Vec<Scale> {
    let pairs = ranges.iter().zip(counts);
    pairs
        .map(|((frame, closed), &count)| Scale::new(*frame, count, *closed))
        .collect()
}

/// Cells along an input to begin with.
fn start(range: &Frame) -> u32 {
    if range.length > 0.0 { 2 } else { 1 }
}

/// The input along which the state bends most in a cell; of equal ones, the one that is divided least. `None` if no range has a length.
pub(super) fn longest(bends: &[f64], counts: &[u32]) -> Option<usize> {
    let bend = |axis: usize| bends.get(axis).copied().unwrap_or_default();
    let ranges = (0..counts.len()).filter(|&axis| counts[axis] > 1);
    ranges.max_by(|&a, &b| {
        let most = bend(a).total_cmp(&bend(b));
        most.then(counts[b].cmp(&counts[a]))
    })
}
