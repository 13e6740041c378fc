//! The number of cells of a grid.

use super::super::cell::Frame;
use super::super::follow::Follower;
use super::super::scale::Scale;
use super::cells::{Cell, Sum};
use super::counts::{CELLS, MISSED, longest, scales};
use super::feasibility::{Feasibility, feasibility};
use super::fit::Fit;
use super::layout::{Layout, Places};
use super::left_out::LeftOut;
use super::terms::Terms;
use super::walk::{Solution, fill};
use alloc::vec;
use alloc::vec::Vec;

/// Up to so many cells, which take two milliseconds, nothing is left out and the boundary of the
/// solution is looked at closely.
const FEW: usize = 64;

/// The same for polynomials, which take ten milliseconds.
const FEW_POLYNOMIALS: usize = 256;

/// Before more places than these are looked at, a few cells say whether the ranges can be served at
/// all; before any, where a cell takes as long as that many places.
const MANY: usize = 256;

/// A grid of twice as many cells takes less than so many times the corrections.
const GROWTH: usize = 3;

/// The ranges in cells.
pub(super) struct Divided {
    pub(super) axes: Vec<Scale>,
    pub(super) cells: Vec<Cell>,
    pub(super) sum: Sum,
    /// The part that no cells can serve, as a look at a few places has shown.
    hopeless: Option<LeftOut>,
}

impl Divided {
    /// Returns the part of the ranges that should be served and is not.
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

    /// Returns whether smaller cells are wanted.
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

/// Divides the ranges until the solution is served wherever it exists, or as far as cells and
/// corrections go. Each range is given with whether it is a full turn. Where `all` of the ranges
/// must be served and cannot be, nothing is.
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

/// Cells along an input to begin with.
fn start(range: &Frame) -> u32 {
    if range.length > 0.0 { 2 } else { 1 }
}
