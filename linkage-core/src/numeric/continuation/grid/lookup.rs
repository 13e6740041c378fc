//! The look-up of generated code in a grid: no branch, no call, no panic.

use super::super::cell::Frame;
use super::super::scale::{Scale, guard};
use super::super::shared::Shared;
use super::Grid;
use super::terms::{OUTSIDE, Terms, values};
use core::fmt;

/// A [`Grid`] of `I` inputs and `S` state numbers, with `T` terms in each cell. Cheap to clone.
#[derive(Clone, PartialEq)]
pub struct GridLookup<const I: usize, const S: usize, const T: usize> {
    axes: [Scale; I],
    /// All cells of the grid, in the order of its axes.
    cells: Shared<[Fixed<S, T>]>,
    served: f64,
}

/// A cell with a fixed number of state numbers and terms.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Fixed<const S: usize, const T: usize> {
    coefficients: [[f64; S]; T],
    floor: f64,
}

impl<const S: usize, const T: usize> Fixed<S, T> {
    const NOTHING: Self = Self {
        coefficients: [[f64::NAN; S]; T],
        floor: f64::NAN,
    };
}

impl Grid {
    /// For generated code: the numbers of inputs and of state numbers are fixed. `None` if they are
    /// not `I` and `S`.
    #[must_use]
    pub fn lookup<const I: usize, const S: usize, const T: usize>(
        &self,
    ) -> Option<GridLookup<I, S, T>> {
        GridLookup::new(self)
    }
}

impl<const I: usize, const S: usize, const T: usize> GridLookup<I, S, T> {
    const TERMS: Option<Terms> = Terms::with_count(I, T);

    fn new(grid: &Grid) -> Option<Self> {
        if grid.width() != S || Self::TERMS != Some(grid.terms) {
            return None;
        }
        let cells = grid.nodes.iter().map(|node| {
            let mut fixed = Fixed::NOTHING;
            if let Some(node) = node {
                let rows = node.coefficients.chunks_exact(S);
                for (row, values) in fixed.coefficients.iter_mut().zip(rows) {
                    row.copy_from_slice(values);
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

    /// The state near `x` from which steps are made, and the floor; NaN where there is none. With
    /// `FUSED` only on machines with fused multiply-add.
    #[must_use]
    #[inline(always)]
    pub fn at_with<const FUSED: bool>(&self, x: [f64; I]) -> ([f64; S], f64) {
        let mut number = 0;
        let mut offsets = [0.0; I];
        for ((axis, x), offset) in self.axes.iter().zip(x).zip(&mut offsets) {
            let (slot, within) = axis.cell(x);
            number = number * axis.slots() + slot;
            *offset = within;
        }
        let cell = self.cell(number);
        let mut outside = 0.0;
        for offset in offsets {
            outside += guard(offset, OUTSIDE);
        }
        let terms = Self::TERMS.unwrap_or(Terms::Slopes);
        let mut state = values::<FUSED, S>(terms, |term| cell.coefficients[term], &offsets);
        for number in &mut state {
            *number += outside;
        }
        (state, cell.floor + outside)
    }

    #[allow(unsafe_code, reason = "a bounds check would be a branch")]
    #[inline(always)]
    fn cell(&self, number: usize) -> &Fixed<S, T> {
        // SAFETY: `Scale::cell` gives slots below `Scale::slots`, `Grid::build` makes a cell for
        // every combination of them, and nothing changes the axes or the cells afterwards.
        unsafe { self.cells.get_unchecked(number) }
    }
}

impl<const I: usize, const S: usize, const T: usize> fmt::Debug for GridLookup<I, S, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("GridLookup")
            .field("cells", &self.cells.len())
            .finish_non_exhaustive()
    }
}
