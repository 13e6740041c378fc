//! The look-up of generated code in a grid: no branch, no call, no panic.

use super::super::cell::Frame;
use super::super::scale::{Scale, guard};
use super::super::shared::Shared;
use super::Grid;
use core::fmt;

/// So far from the centre of a cell, in cells, there is no state: half a cell outside the grid.
pub(in super::super) const OUTSIDE: f64 = 1.0;

/// A [`Grid`] of `I` inputs and `S` state numbers. Cheap to clone.
#[derive(Clone, PartialEq)]
pub struct GridLookup<const I: usize, const S: usize> {
    axes: [Scale; I],
    /// As many as the axes have cells together.
    cells: Shared<[Fixed<I, S>]>,
    served: f64,
}

/// A cell with a fixed number of inputs and state numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Fixed<const I: usize, const S: usize> {
    state: [f64; S],
    slopes: [[f64; S]; I],
    floor: f64,
}

impl<const I: usize, const S: usize> Fixed<I, S> {
    const NOTHING: Self = Self {
        state: [f64::NAN; S],
        slopes: [[f64::NAN; S]; I],
        floor: f64::NAN,
    };
}

impl<const I: usize, const S: usize> GridLookup<I, S> {
    pub(super) fn new(grid: &Grid) -> Option<Self> {
        if grid.width() != S {
            return None;
        }
        let cells = grid.nodes.iter().map(|node| {
            let mut fixed = Fixed::NOTHING;
            if let Some(node) = node {
                fixed.state.copy_from_slice(&node.state);
                for (slopes, values) in fixed.slopes.iter_mut().zip(node.slopes.chunks_exact(S)) {
                    slopes.copy_from_slice(values);
                }
                fixed.floor = node.floor;
            }
            fixed
        });
        Some(Self {
            axes: grid.axes.as_slice().try_into().ok()?,
            cells: cells.collect(),
            served: grid.served(),
        })
    }

    /// A look-up that gives NaN everywhere.
    #[must_use]
    pub fn nothing() -> Self {
        let frame = Frame::new(0.0, 0.0);
        Self {
            axes: [Scale::new(frame, 1, false); I],
            cells: core::iter::once(Fixed::NOTHING).collect(),
            served: 0.0,
        }
    }

    /// The share of the ranges in which it serves.
    #[must_use]
    pub fn served(&self) -> f64 {
        self.served
    }

    /// The state near `x` from which four steps are made, and the floor; NaN where there is none.
    #[must_use]
    #[inline(always)]
    pub fn at(&self, x: [f64; I]) -> ([f64; S], f64) {
        let mut number = 0;
        let mut offsets = [0.0; I];
        for ((axis, x), offset) in self.axes.iter().zip(x).zip(&mut offsets) {
            let (slot, within) = axis.cell(x);
            number = number * axis.slots() + slot;
            *offset = within;
        }
        let cell = self.cell(number);
        let mut state = cell.state;
        let mut outside = 0.0;
        for (slopes, offset) in cell.slopes.iter().zip(offsets) {
            outside += guard(offset, OUTSIDE);
            for (number, slope) in state.iter_mut().zip(slopes) {
                *number += slope * offset;
            }
        }
        for number in &mut state {
            *number += outside;
        }
        (state, cell.floor + outside)
    }

    #[allow(unsafe_code, reason = "a bounds check would be a branch")]
    #[inline(always)]
    fn cell(&self, number: usize) -> &Fixed<I, S> {
        // SAFETY: `Scale::cell` gives slots below `Scale::slots`, `Grid::build` makes a cell for every combination of
        // them, and nothing changes the axes or the cells afterwards.
        unsafe { self.cells.get_unchecked(number) }
    }
}

impl<const I: usize, const S: usize> fmt::Debug for GridLookup<I, S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("GridLookup")
            .field("cells", &self.cells.len())
            .finish_non_exhaustive()
    }
}
