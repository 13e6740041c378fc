//! The look-up of generated code: no branch, no call, no panic.

mod block;

use super::cell::{Cell, Frame, OUTSIDE};
use super::polynomial::{TERMS, by_pairs};
use super::scale::{Scale, guard};
use super::shared::Shared;
use super::table::Table;
use crate::scalar::FUSED;
use core::fmt;

/// A [`Table`] of `S` state numbers. Cheap to clone.
#[derive(Clone, PartialEq)]
pub struct Lookup<const S: usize> {
    scale: Scale,
    /// A number of a cell for each slot of the scale.
    index: Shared<[u16]>,
    cells: Shared<[Fixed<S>]>,
}

/// A cell with a fixed number of state numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(32))]
struct Fixed<const S: usize> {
    /// First, so that the rows of four numbers do not cross cache lines.
    coefficients: [[f64; S]; TERMS],
    centre: f64,
    inverse: f64,
    floor: f64,
}

impl<const S: usize> Fixed<S> {
    /// A place as the polynomials see it.
    #[inline(always)]
    fn t(&self, position: f64) -> f64 {
        (position - self.centre) * self.inverse
    }
}

/// The values of a cell's polynomials at `t`.
#[inline(always)]
fn polynomials<const FUSED: bool, const S: usize>(c: &[[f64; S]; TERMS], t: f64) -> [f64; S] {
    let mut state = [0.0; S];
    for (index, number) in state.iter_mut().enumerate() {
        *number = by_pairs::<FUSED>(|power| c[power][index], t);
    }
    state
}

impl Table {
    /// For generated code: the number of state numbers is fixed. `None` if it is not `S`.
    #[must_use]
    pub fn lookup<const S: usize>(&self) -> Option<Lookup<S>> {
        Lookup::new(self)
    }
}

impl<const S: usize> Lookup<S> {
    fn new(table: &Table) -> Option<Self> {
        if table.width() != S {
            return None;
        }
        let fixed = |cell: &Cell| {
            let mut coefficients = [[0.0; S]; TERMS];
            for (row, values) in coefficients
                .iter_mut()
                .zip(cell.coefficients.chunks_exact(S))
            {
                row.copy_from_slice(values);
            }
            Fixed {
                centre: cell.centre,
                inverse: cell.inverse,
                floor: cell.floor,
                coefficients,
            }
        };
        Some(Self {
            scale: table.scale,
            index: table.index.clone(),
            cells: table.cells.iter().map(fixed).collect(),
        })
    }

    /// A look-up that gives NaN everywhere.
    #[must_use]
    pub fn nothing() -> Self {
        let frame = Frame::new(0.0, 0.0);
        let nowhere = Fixed {
            centre: f64::NAN,
            inverse: f64::NAN,
            floor: f64::NAN,
            coefficients: [[f64::NAN; S]; TERMS],
        };
        Self {
            scale: Scale::new(frame, 1, false),
            index: core::iter::once(0).collect(),
            cells: core::iter::once(nowhere).collect(),
        }
    }

    /// The state at `x`, with an error of 1e-9 or less inside the range, and the floor. Far outside
    /// the floor is NaN, and with it every result: steps from the state compare their determinant
    /// with it. The state does not wait for that.
    #[must_use]
    #[inline(always)]
    pub fn state_at(&self, x: f64) -> ([f64; S], f64) {
        self.at_with::<{ FUSED }>(x)
    }

    /// The same, for the machines that [`Scalar::mul_add`](crate::Scalar::mul_add) speaks of.
    #[must_use]
    #[inline(always)]
    pub fn at_with<const FUSED: bool>(&self, x: f64) -> ([f64; S], f64) {
        let (position, slot) = self.scale.find(x);
        let cell = self.cell(slot);
        let t = cell.t(position);
        let state = polynomials::<FUSED, S>(&cell.coefficients, t);
        (state, cell.floor + guard(t, OUTSIDE))
    }

    /// The cell that serves a slot.
    #[inline(always)]
    fn cell(&self, slot: usize) -> &Fixed<S> {
        cell(&self.index, &self.cells, slot)
    }
}

/// Returns the cell that serves a slot, from the index and the cells of a table.
#[allow(unsafe_code, reason = "a bounds check would be a branch")]
#[inline(always)]
fn cell<'a, const S: usize>(index: &[u16], cells: &'a [Fixed<S>], slot: usize) -> &'a Fixed<S> {
    // SAFETY: the index has as many elements as the scale has slots, at least one, and
    // `Scale::find` gives a slot whatever the input is; its elements are numbers of cells, and
    // nothing changes either after `Table::from_pieces`.
    unsafe {
        let number = *index.get_unchecked(slot);
        cells.get_unchecked(usize::from(number))
    }
}

impl<const S: usize> fmt::Debug for Lookup<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Lookup")
            .field("cells", &self.cells.len())
            .finish_non_exhaustive()
    }
}
