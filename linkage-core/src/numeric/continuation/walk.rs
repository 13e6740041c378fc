//! The walk from cell to cell through the range.

use super::cell::{Cell, Frame, Guess, attempt};
use super::follow::Follower;
use super::{End, Refusal, turning_point};
use alloc::vec::Vec;

/// The range in units: the shortest cells are this many to the range.
pub(super) const FULL: u32 = 1 << 17;

/// The first cell is at most this part of the range or of a turn.
const FIRST: f64 = 1.0 / 32.0;

/// Cells are at most this part of the range.
const LARGEST: u32 = FULL / 4;

/// A turning point is looked for within so many of the shortest cells.
const REACH: f64 = 256.0;

/// Cells of a table, at most.
const CELLS: usize = 8192;

/// A cell twice as long is tried if its error may be expected to be small enough.
const SMOOTH: f64 = 1e-12;

/// A cell and the units it covers.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    pub(super) first: u32,
    pub(super) size: u32,
    pub(super) cell: Cell,
}

/// Neighbouring cells, in order.
pub(super) struct Walk<'f, 'c> {
    pub(super) follower: &'f mut Follower<'c>,
    pub(super) frame: Frame,
    pub(super) width: usize,
}

impl Walk<'_, '_> {
    /// The cell around a known solution. The range may be an angle.
    pub(super) fn first(&mut self, x: f64, state: &[f64], turn: bool) -> Result<Piece, Refusal> {
        let position = self.frame.position(x);
        let unit = ((position + 0.5) * f64::from(FULL)) as u32;
        let share = if turn && self.frame.length > core::f64::consts::TAU {
            FIRST * core::f64::consts::TAU / self.frame.length
        } else {
            FIRST
        };
        let mut size = FULL;
        while size > 1 && f64::from(size) > share * f64::from(FULL) {
            size /= 2;
        }
        while size > 0 {
            let first = unit.min(FULL - 1) / size * size;
            if let Some(piece) = self.piece(first, size, Guess::State(position, state)) {
                return Ok(piece);
            }
            size /= 2;
        }
        Err(Refusal::NotConverging { at: x })
    }

    /// Cells from `piece` on upwards or downwards (`side` 1 or -1), nearest first, as far as they
    /// go.
    pub(super) fn run(&mut self, piece: &Piece, side: f64) -> (Vec<Piece>, End) {
        let mut pieces: Vec<Piece> = Vec::new();
        loop {
            let last = pieces.last().unwrap_or(piece);
            let edge = if side > 0.0 {
                last.first + last.size
            } else {
                last.first
            };
            let end = self.frame.x(last.cell.position(side));
            if edge == if side > 0.0 { FULL } else { 0 } {
                return (pieces, End::Range(self.frame.end(side)));
            }
            if pieces.len() >= CELLS || self.follower.exhausted() {
                return (pieces, End::Lost(end));
            }
            match self.next(last, edge, side) {
                Some(next) => pieces.push(next),
                None => {
                    let turning = self.turning(&last.cell, side);
                    let lost = End::Lost(end);
                    let end =
                        turning.map_or(lost, |position| End::TurningPoint(self.frame.x(position)));
                    return (pieces, end);
                }
            }
        }
    }

    /// The longest cell that can be made behind `last`.
    fn next(&mut self, last: &Piece, edge: u32, side: f64) -> Option<Piece> {
        let double = last.cell.error < SMOOTH && 2 * last.size <= LARGEST;
        let mut size = if double { 2 * last.size } else { last.size };
        while !edge.is_multiple_of(size) {
            size /= 2;
        }
        while size > 0 {
            let first = if side > 0.0 { edge } else { edge - size };
            if let Some(piece) = self.piece(first, size, Guess::Cell(&last.cell)) {
                return Some(piece);
            }
            size /= 2;
        }
        None
    }

    fn piece(&mut self, first: u32, size: u32, guess: Guess<'_>) -> Option<Piece> {
        let full = f64::from(FULL);
        let length = f64::from(size) / full;
        let centre = f64::from(first) / full + 0.5 * length - 0.5;
        let cell = attempt(self.follower, &self.frame, centre, length, guess)?;
        Some(Piece { first, size, cell })
    }

    fn turning(&mut self, last: &Cell, side: f64) -> Option<f64> {
        let reach = REACH / f64::from(FULL);
        turning_point::locate(self.follower, &self.frame, last, self.width, side, reach)
    }
}
