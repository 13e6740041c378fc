//! A prepared table of states over the range of one input.

use super::cell::{Cell, Frame, OUTSIDE};
use super::follow::Follower;
use super::polynomial::by_pairs;
use super::scale::{Scale, guard};
use super::shared::Shared;
use super::walk::{FULL, Piece, Walk};
use super::{Correction, End, Range, Refusal};
use alloc::vec;
use alloc::vec::Vec;
use core::f64::consts::TAU;
use core::fmt;

/// Corrections that building a table may take.
const CORRECTIONS: usize = 400_000;

/// A range that is shorter than a turn by this share is a full turn.
const ROUNDING: f64 = 1e-9;

/// After a full turn the state must be back with this accuracy.
const CLOSURE: f64 = 1e-8;

/// Places in a turn, as shares of it, where the state must solve the equations one turn later, too.
const REPEATS: [f64; 4] = [0.137, 0.382, 0.618, 0.871];

/// The state of a group over the range of one input, for any number of state numbers. Cheap to
/// clone.
///
/// It consists of cells, each with polynomials of degree 7. The cells are as short as the solution
/// needs them: where it bends sharply, and towards a turning point, they become shorter. While the
/// table is built the solution is followed from the given one, in steps that are small enough to
/// stay on it, and the sign of the determinant must not change.
#[derive(Clone, PartialEq)]
pub struct Table {
    pub(super) scale: Scale,
    /// The cell of each part of the range, as long as the shortest cell.
    pub(super) index: Shared<[u16]>,
    pub(super) cells: Shared<[Cell]>,
    width: usize,
    ends: [End; 2],
}

impl Table {
    /// Follows the solution `state` at the input `at` through the range.
    ///
    /// Where a full turn is asked for and the state returns after it, the table serves every input.
    /// Outside another range it reaches as far as the state can be extrapolated. With `partial` the
    /// table may end inside the range; it then reaches to some 1e-5 of the range before a turning
    /// point. Otherwise that is refused.
    ///
    /// # Errors
    ///
    /// See [`Refusal`].
    pub fn build(
        correction: &mut dyn Correction,
        at: f64,
        state: &[f64],
        range: Range,
        partial: bool,
    ) -> Result<Self, Refusal> {
        let (low, high) = (
            range.low.min(range.high).min(at),
            range.low.max(range.high).max(at),
        );
        let finite = [range.low, range.high, at, high - low];
        if state.is_empty() || !finite.iter().all(|x| x.is_finite()) {
            return Err(Refusal::NotFinite);
        }
        let mut state = state.to_vec();
        let mut follower = Follower::new(correction, &[at], &mut state, CORRECTIONS)
            .ok_or(Refusal::NotASolution)?;
        if low == high {
            return Self::point(&mut follower, at, &mut state);
        }
        if range.turn && high - low >= TAU * (1.0 - ROUNDING) {
            match Self::closed(&mut follower, at, &state) {
                Ok(Some(table)) => return Ok(table),
                Err(Refusal::TurningPoint { at }) if !partial => {
                    let at = if at > high { at - TAU } else { at };
                    return Err(Refusal::TurningPoint { at });
                }
                _ => {}
            }
        }
        Self::open(&mut follower, at, &state, low, high, range.turn, partial)
    }

    /// The lower and the upper end of the table.
    #[must_use]
    pub fn ends(&self) -> [End; 2] {
        self.ends
    }

    /// Returns the number of cells.
    #[must_use]
    pub fn cells(&self) -> usize {
        self.cells.len()
    }

    /// Returns the number of state numbers.
    #[must_use]
    pub fn width(&self) -> usize {
        self.width
    }

    /// The largest distance of the table from the solution that was found between its nodes.
    #[must_use]
    pub fn error(&self) -> f64 {
        self.cells
            .iter()
            .fold(0.0, |most: f64, cell| most.max(cell.error))
    }

    /// Writes the state at `x`, NaN where there is none, and returns the floor.
    ///
    /// # Panics
    ///
    /// If `state` is not [`width`](Self::width) numbers long.
    pub fn state(&self, x: f64, state: &mut [f64]) -> f64 {
        assert!(
            state.len() == self.width,
            "a state has {} numbers",
            self.width
        );
        let (position, slot) = self.scale.find(x);
        let cell = &self.cells[usize::from(self.index[slot])];
        let guard = guard(cell.t(position), OUTSIDE);
        cell.state(position, state);
        state.iter_mut().for_each(|number| *number += guard);
        cell.floor + guard
    }

    /// Writes as [`state`](Self::state) does, to the last bit the result of
    /// [`Lookup::at_with`](super::Lookup::at_with). `FUSED` is for machines with fused multiply-add
    /// only.
    ///
    /// # Panics
    ///
    /// As [`state`](Self::state).
    #[inline(always)]
    pub fn look_up<const FUSED: bool>(&self, x: f64, state: &mut [f64]) -> f64 {
        let width = self.width;
        assert!(state.len() == width, "a state has {width} numbers");
        let (position, slot) = self.scale.find(x);
        let cell = &self.cells[usize::from(self.index[slot])];
        let (t, c) = (cell.t(position), &cell.coefficients);
        for (index, number) in state.iter_mut().enumerate() {
            *number = by_pairs::<FUSED>(|power| c[power * width + index], t);
        }
        cell.floor + guard(t, OUTSIDE)
    }

    /// Over a range of one point.
    fn point(follower: &mut Follower<'_>, at: f64, state: &mut [f64]) -> Result<Self, Refusal> {
        let determinant = follower.settle(&[at], state).ok_or(Refusal::NotASolution)?;
        let frame = Frame::new(at, at);
        let cell = Cell::constant(state, 0.5 * determinant);
        let pieces = vec![Piece {
            first: 0,
            size: FULL,
            cell,
        }];
        Ok(Self::from_pieces(
            frame,
            pieces,
            state.len(),
            [End::Range(at); 2],
        ))
    }

    /// Over a full turn, if the state returns after it.
    fn closed(
        follower: &mut Follower<'_>,
        at: f64,
        state: &[f64],
    ) -> Result<Option<Self>, Refusal> {
        let frame = Frame::new(at, at + TAU);
        let width = state.len();
        let mut walk = Walk {
            follower,
            frame,
            width,
        };
        let mut pieces = vec![walk.first(at, state, true)?];
        let (above, end) = walk.run(&pieces[0], 1.0);
        reached(end, false)?;
        pieces.extend(above);
        let mut last = vec![0.0; width];
        pieces[pieces.len() - 1].cell.state(0.5, &mut last);
        let close = |(a, b): (&f64, &f64)| (a - b).abs() <= CLOSURE;
        let table = Self::from_pieces(frame, pieces, width, [End::Closed; 2]);
        let repeats = last.iter().zip(state).all(close) && table.repeats(follower);
        Ok(repeats.then_some(table))
    }

    /// Returns whether the states of the first turn solve the equations one turn later.
    fn repeats(&self, follower: &mut Follower<'_>) -> bool {
        let mut state = vec![0.0; self.width];
        REPEATS.iter().all(|share| {
            let x = self.scale.frame.x(share - 0.5);
            self.state(x, &mut state);
            let step = follower.correct(&[x + TAU], &mut state);
            step.is_some_and(|step| step.size <= CLOSURE)
        })
    }

    /// Over a range with two ends.
    fn open(
        follower: &mut Follower<'_>,
        at: f64,
        state: &[f64],
        low: f64,
        high: f64,
        turn: bool,
        partial: bool,
    ) -> Result<Self, Refusal> {
        let frame = Frame::new(low, high);
        let width = state.len();
        let mut walk = Walk {
            follower,
            frame,
            width,
        };
        let first = walk.first(at, state, turn)?;
        let (below, lower) = walk.run(&first, -1.0);
        let lower = reached(lower, partial)?;
        let (above, upper) = walk.run(&first, 1.0);
        let upper = reached(upper, partial)?;
        let mut pieces = below;
        pieces.reverse();
        pieces.push(first);
        pieces.extend(above);
        Ok(Self::from_pieces(frame, pieces, width, [lower, upper]))
    }

    fn from_pieces(frame: Frame, pieces: Vec<Piece>, width: usize, ends: [End; 2]) -> Self {
        let shortest = pieces.iter().map(|piece| piece.size).min().unwrap_or(FULL);
        let slots = FULL / shortest;
        let mut index = Vec::with_capacity(slots as usize);
        for (number, piece) in (0_u16..).zip(&pieces) {
            // What no cell covers belongs to the first or the last one.
            let end = if usize::from(number) + 1 == pieces.len() {
                slots
            } else {
                (piece.first + piece.size) / shortest
            };
            index.resize(end as usize, number);
        }
        let closed = ends[0] == End::Closed;
        Self {
            scale: Scale::new(frame, slots, closed),
            index: index.into(),
            cells: pieces.into_iter().map(|piece| piece.cell).collect(),
            width,
            ends,
        }
    }
}

/// An end that a table may have.
fn reached(end: End, partial: bool) -> Result<End, Refusal> {
    match end {
        End::TurningPoint(at) if !partial => Err(Refusal::TurningPoint { at }),
        End::Lost(at) if !partial => Err(Refusal::NotConverging { at }),
        end => Ok(end),
    }
}

impl fmt::Debug for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Table")
            .field("cells", &self.cells.len())
            .field("width", &self.width)
            .field("ends", &self.ends)
            .finish_non_exhaustive()
    }
}
