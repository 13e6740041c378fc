//! Prepared states over the ranges of several inputs, or of none.

mod border;
mod cells;
mod counts;
mod divide;
mod feasibility;
mod fit;
mod layout;
mod left_out;
mod lookup;
mod node;
mod path;
mod reached;
mod served;
mod slopes;
mod terms;
mod walk;

use super::cell::Frame;
use super::follow::Follower;
use super::scale::Scale;
use super::shared::Shared;
use super::{Correction, Range, Refusal};
use alloc::vec;
use alloc::vec::Vec;
use cells::Cell;
use core::f64::consts::TAU;
use core::fmt;
use divide::{Divided, divided};
use fit::Fit;
use node::Node;
use walk::Solution;

pub use left_out::LeftOut;
pub use lookup::GridLookup;
pub use reached::reached;
pub(super) use terms::OUTSIDE;
pub use terms::Terms;

/// Corrections that building a grid of slopes may take: less than a second. A grid of all cells
/// takes half of them; with polynomials it takes three times as many.
const CORRECTIONS: usize = 2_000_000;

/// Inputs, at most: a cell has two corners for each of them.
const INPUTS: usize = 8;

/// The state of a group over the ranges of any number of inputs. Cheap to clone.
///
/// The ranges are divided into cells. For each the state at its centre is known, and how it changes
/// with the inputs: over two of them by polynomials, from which one Newton step reaches the
/// solution everywhere in the cell, else by its slopes, from which four do. The states are followed
/// from the given one, cell to cell. Where the solution cannot be reached, beyond the mechanism's
/// reach for instance, there is none.
#[derive(Clone, PartialEq)]
pub struct Grid {
    pub(super) axes: Vec<Scale>,
    /// Cell by cell, the last input changing fastest; `None` where the solution cannot be reached.
    pub(super) nodes: Shared<[Option<Node>]>,
    pub(super) terms: Terms,
    width: usize,
    served: f64,
    left_out: Option<LeftOut>,
}

impl Grid {
    /// Follows the solution `state` at the inputs `at` through all ranges. An input whose range is
    /// empty stays where it is. With one input, or more than two, there are no polynomials.
    ///
    /// # Errors
    ///
    /// See [`Refusal`]; more than 8 inputs need too large a grid.
    ///
    /// # Panics
    ///
    /// If there are not as many ranges as inputs.
    pub fn build(
        correction: &mut dyn Correction,
        at: &[f64],
        state: &[f64],
        ranges: &[Range],
        terms: Terms,
    ) -> Result<Self, Refusal> {
        Self::followed(correction, at, state, ranges, (terms, false))
    }

    /// The same for ranges that must be served: where a look at a few places says that much of them
    /// would be left out, all of it is, in a part of the time; and cells of which a look says that
    /// they are too large are not tried.
    ///
    /// # Errors
    ///
    /// As those of [`build`](Self::build).
    ///
    /// # Panics
    ///
    /// If there are not as many ranges as inputs.
    pub fn build_all(
        correction: &mut dyn Correction,
        at: &[f64],
        state: &[f64],
        ranges: &[Range],
        terms: Terms,
    ) -> Result<Self, Refusal> {
        Self::followed(correction, at, state, ranges, (terms, true))
    }

    fn followed(
        correction: &mut dyn Correction,
        at: &[f64],
        state: &[f64],
        ranges: &[Range],
        (terms, all): (Terms, bool),
    ) -> Result<Self, Refusal> {
        assert!(at.len() == ranges.len(), "a range for every input");
        let terms = match at.len() {
            2 => terms,
            _ => Terms::Slopes,
        };
        if at.len() > INPUTS {
            return Err(Refusal::NotConverging { at: at[0] });
        }
        let frames: Option<Vec<(Frame, bool)>> = at
            .iter()
            .zip(ranges)
            .map(|(&at, range)| frame(at, *range))
            .collect();
        let frames = frames
            .filter(|_| !state.is_empty())
            .ok_or(Refusal::NotFinite)?;
        let mut state = state.to_vec();
        let most = match terms {
            Terms::Slopes => CORRECTIONS,
            Terms::Polynomials => 3 * CORRECTIONS,
        };
        let mut follower =
            Follower::new(correction, at, &mut state, most).ok_or(Refusal::NotASolution)?;
        let determinant = follower.settle(at, &mut state);
        let reference = Solution {
            at,
            state: &state,
            determinant: determinant.ok_or(Refusal::NotASolution)?,
        };
        let fit = Fit::new(terms);
        let divided = divided(&mut follower, &frames, &reference, &fit, all);
        Self::made(divided, &fit, &reference)
    }

    fn made(divided: Divided, fit: &Fit, reference: &Solution<'_>) -> Result<Self, Refusal> {
        if divided.sum.served == 0 && divided.sum.boundary {
            let at = reference.at.first().copied().unwrap_or_default();
            return Err(Refusal::NotConverging { at });
        }
        Ok(Self {
            terms: fit.terms(),
            width: reference.state.len(),
            served: divided.sum.share(divided.sum.served),
            left_out: divided.left_out(),
            nodes: divided.cells.into_iter().map(Cell::node).collect(),
            axes: divided.axes,
        })
    }

    /// Returns the number of cells.
    #[must_use]
    pub fn cells(&self) -> usize {
        self.nodes.len()
    }

    /// In how many cells the solution can be reached.
    #[must_use]
    pub fn reached(&self) -> usize {
        self.nodes.iter().flatten().count()
    }

    /// The share of the ranges in which it serves: of the places on the borders of cells, those
    /// that evaluators reach.
    #[must_use]
    pub fn served(&self) -> f64 {
        self.served
    }

    /// Returns the part that is not served although the solution exists, or may exist, away from
    /// its boundary, if it is more of the ranges than allowed.
    #[must_use]
    pub fn left_out(&self) -> Option<&LeftOut> {
        self.left_out.as_ref()
    }

    /// Returns the number of state numbers.
    #[must_use]
    pub fn width(&self) -> usize {
        self.width
    }

    /// Returns the number of inputs.
    #[must_use]
    pub fn inputs(&self) -> usize {
        self.axes.len()
    }

    /// Writes the state near `x` from which steps are made, NaN where there is none, and returns
    /// the floor.
    ///
    /// # Panics
    ///
    /// If `x` or `state` has another length than [`inputs`](Self::inputs) or
    /// [`width`](Self::width).
    pub fn state(&self, x: &[f64], state: &mut [f64]) -> f64 {
        self.look_up::<false>(x, state)
    }

    /// Returns the result of [`GridLookup::at_with`], to the last bit. `FUSED` is for machines with
    /// fused multiply-add only.
    ///
    /// # Panics
    ///
    /// As [`state`](Self::state).
    pub fn look_up<const FUSED: bool>(&self, x: &[f64], state: &mut [f64]) -> f64 {
        assert!(x.len() == self.axes.len() && state.len() == self.width);
        let mut cell = 0;
        let mut offsets = vec![0.0; x.len()];
        for ((axis, &x), offset) in self.axes.iter().zip(x).zip(&mut offsets) {
            let (slot, within) = axis.cell(x);
            cell = cell * axis.slots() + slot;
            *offset = within;
        }
        match &self.nodes[cell] {
            Some(node) => node.state::<FUSED>(&offsets, state),
            None => {
                state.fill(f64::NAN);
                f64::NAN
            }
        }
    }

    /// Returns whether evaluators give the solution at `x`: of one step, that it is tiny and the
    /// determinant above the floor; of four, that each is a quarter of the one before and the last
    /// one tiny.
    ///
    /// # Panics
    ///
    /// As those of [`state`](Self::state).
    pub fn serves(&self, correction: &mut dyn Correction, x: &[f64]) -> bool {
        let mut state = vec![0.0; self.width];
        let floor = self.state(x, &mut state);
        served::serves(correction, self.terms, x, &mut state, floor)
    }
}

/// A range that misses a full turn by this share or less is one: users write 360 degrees.
const TURN: f64 = 1e-9;

/// The range of an input that includes the place to start from, and whether it is a full turn.
fn frame(at: f64, range: Range) -> Option<(Frame, bool)> {
    let low = range.low.min(range.high).min(at);
    let high = range.low.max(range.high).max(at);
    let finite = [range.low, range.high, at, high - low];
    if !finite.iter().all(|x| x.is_finite()) {
        return None;
    }
    let closed = range.turn && high - low >= TAU * (1.0 - TURN);
    let frame = if closed {
        Frame::new(at - 0.5 * TAU, at + 0.5 * TAU)
    } else {
        Frame::new(low, high)
    };
    Some((frame, closed))
}

impl fmt::Debug for Grid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Grid")
            .field("cells", &self.cells())
            .field("reached", &self.reached())
            .field("inputs", &self.axes.len())
            .field("width", &self.width)
            .finish_non_exhaustive()
    }
}
