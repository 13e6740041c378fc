//! The look-up of generated code: no branch, no call, no panic.

use super::cell::{Cell, Frame};
use super::polynomial::{TERMS, by_pairs};
use super::scale::{Scale, guard};
use super::shared::Shared;
use super::table::Table;
use crate::scalar::FUSED;
use core::fmt;

/// Beyond this place of a cell there is no state: half a cell outside the table.
pub(super) const OUTSIDE: f64 = 2.0;

/// A [`Table`] of `S` state numbers. Cheap to clone.
#[derive(Clone, PartialEq)]
pub struct Lookup<const S: usize> {
    scale: Scale,
    /// As long as the scale has slots; every element is the number of a cell.
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

impl<const S: usize> Lookup<S> {
    pub(super) fn new(table: &Table) -> Option<Self> {
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

    /// The state at `x`, with an error of 1e-9 or less inside the range, and the floor; both NaN far outside.
    #[must_use]
    #[inline(always)]
    pub fn at(&self, x: f64) -> ([f64; S], f64) {
        self.at_place::<{ FUSED }>(self.locate(x))
    }

    /// Where [`at`](Self::at) looks: the place in the range, and the bits of a slot's number.
    #[must_use]
    #[inline(always)]
    pub fn locate(&self, x: f64) -> [f64; 2] {
        let (place, slot) = self.scale.find(x);
        [place, f64::from_bits(slot as u64)]
    }

    /// The state at a place from [`locate`](Self::locate). With `FUSED` only on machines with fused multiply-add.
    #[must_use]
    #[inline(always)]
    pub fn at_place<const FUSED: bool>(&self, [place, slot]: [f64; 2]) -> ([f64; S], f64) {
        let cell = self.cell(slot.to_bits() as usize);
        let t = (place - cell.centre) * cell.inverse;
        let guard = guard(t, OUTSIDE);
        let c = &cell.coefficients;
        let mut state = [0.0; S];
        for (index, number) in state.iter_mut().enumerate() {
            *number = by_pairs::<FUSED>(|power| c[power][index], t) + guard;
        }
        (state, cell.floor + guard)
    }

    #[allow(unsafe_code, reason = "a bounds check would be a branch")]
    #[inline(always)]
    fn cell(&self, slot: usize) -> &Fixed<S> {
        // SAFETY: the index has as many elements as the scale has slots, at least one; they are numbers of cells, and nothing changes
        // either after `Table::from_pieces`.
        unsafe {
            let slot = slot.min(self.scale.slots() - 1);
            let number = *self.index.get_unchecked(slot);
            self.cells.get_unchecked(usize::from(number))
        }
    }
}

impl<const S: usize> fmt::Debug for Lookup<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Lookup")
            .field("cells", &self.cells.len())
            .finish_non_exhaustive()
    }
}
