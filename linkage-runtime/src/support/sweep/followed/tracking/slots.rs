//! The rows of all that are under way, column by column, as kernels read them.

use crate::support::sweep::arguments::Arguments;
use alloc::boxed::Box;

/// The number of mechanisms that are tracked at once: enough for vectors of rows, few enough for
/// the processor's nearest cache.
pub(super) const SLOTS: usize = 32;

/// One row in each slot. Dimensions are those that are wanted; kernels read those at a share of the
/// way.
pub(super) struct Slots<const P: usize, const R: usize> {
    from: [f64; P],
    columns: Box<[[f64; SLOTS]; R]>,
    /// The part of the way that is left.
    left: [f64; SLOTS],
    /// The first slots have a row.
    pub(super) taken: usize,
}

impl<const P: usize, const R: usize> Slots<P, R> {
    pub(super) fn new(from: [f64; P]) -> Self {
        Self {
            from,
            columns: Box::new([[0.0; SLOTS]; R]),
            left: [0.0; SLOTS],
            taken: 0,
        }
    }

    pub(super) fn put(&mut self, slot: usize, row: &[f64; R]) {
        for (column, value) in self.columns.iter_mut().zip(row) {
            column[slot] = *value;
        }
    }

    pub(super) fn copy(&mut self, from: usize, to: usize) {
        for column in self.columns.iter_mut() {
            column[to] = column[from];
        }
        self.left[to] = self.left[from];
    }

    /// Changes a column in the slots that are chosen.
    pub(super) fn take(&mut self, number: usize, found: &[f64], chosen: &[bool; SLOTS]) {
        let column = self.columns[number].iter_mut();
        for ((value, found), chosen) in column.zip(found).zip(chosen) {
            *value = if *chosen { *found } else { *value };
        }
    }

    /// One slot, to write to.
    pub(super) fn lane(&mut self, slot: usize) -> Lane<'_, R> {
        Lane {
            columns: &mut self.columns,
            left: &mut self.left[slot],
            slot,
        }
    }
}

impl<const P: usize, const R: usize> Arguments<f64, R> for Slots<P, R> {
    fn check(&self) -> usize {
        self.taken
    }

    #[inline(always)]
    fn block<const FUSED: bool, const V: usize, const B: usize>(
        &self,
        start: usize,
        rows: usize,
        block: &mut [[f64; B]; R],
    ) {
        let mut first = 0;
        while first < rows {
            let left = vector::<V>(&self.left, start + first);
            let columns = block.iter_mut().zip(self.columns.iter()).enumerate();
            for (number, (column, values)) in columns {
                let Some(column) = column[first..].first_chunk_mut::<V>() else {
                    return;
                };
                *column = vector(values, start + first);
                let Some(from) = self.from.get(number) else {
                    continue;
                };
                for (value, left) in column.iter_mut().zip(left) {
                    *value += left * (from - *value);
                }
            }
            first += V;
        }
    }
}

/// The slots of one block.
#[inline(always)]
fn vector<const V: usize>(column: &[f64; SLOTS], first: usize) -> [f64; V] {
    let rest = column.get(first..).and_then(|rest| rest.first_chunk());
    rest.copied().unwrap_or([0.0; V])
}

/// One slot.
pub(super) struct Lane<'a, const R: usize> {
    columns: &'a mut [[f64; SLOTS]; R],
    left: &'a mut f64,
    slot: usize,
}

impl<const R: usize> Lane<'_, R> {
    /// Goes to this share of the way.
    pub(super) fn go(&mut self, share: f64) {
        *self.left = 1.0 - share;
    }

    pub(super) fn get(&self, span: usize) -> f64 {
        self.columns[span][self.slot]
    }

    pub(super) fn set(&mut self, span: usize, value: f64) {
        self.columns[span][self.slot] = value;
    }
}
