//! The columns of a sweep as its loops write them.

use core::marker::PhantomData;

/// Columns that vectors of rows are written to.
///
/// Its rows are counted once for all columns, so that a loop compares the row of a vector once, and
/// not for each column: these comparisons and their jumps would be as many instructions as the
/// arithmetic of a function with many results, and no optimiser moves operations across them.
pub(super) struct Destination<'c, T, const W: usize> {
    /// The first row of each column.
    starts: [*mut T; W],
    rows: usize,
    columns: PhantomData<&'c mut [T]>,
}

impl<'c, T: Copy, const W: usize> Destination<'c, T, W> {
    /// As many rows as the shortest column has.
    #[inline(always)]
    pub(super) fn new(columns: [&'c mut [T]; W]) -> Self {
        let mut starts = [core::ptr::null_mut(); W];
        let mut rows = usize::MAX;
        for (start, column) in starts.iter_mut().zip(columns) {
            rows = rows.min(column.len());
            *start = column.as_mut_ptr();
        }
        Self {
            starts,
            rows: if W == 0 { 0 } else { rows },
            columns: PhantomData,
        }
    }

    /// The number of rows.
    #[inline(always)]
    pub(super) fn rows(&self) -> usize {
        self.rows
    }

    /// Writes lanes into column `k` from `row` on.
    ///
    /// # Panics
    ///
    /// Panics if the columns end before, or if there is no such column.
    #[inline(always)]
    #[allow(unsafe_code, reason = "one comparison for all columns")]
    pub(super) fn put<const V: usize>(&mut self, k: usize, row: usize, lanes: &[T; V]) {
        assert!(row <= self.rows && V <= self.rows - row, "row {row}");
        // SAFETY: every column has `rows` elements or more, which are borrowed for `'c`, and the
        // lanes end at or before the last of them.
        unsafe { self.starts[k].add(row).cast::<[T; V]>().write(*lanes) }
    }
}

#[cfg(test)]
mod tests {
    use super::Destination;
    use std::panic::{AssertUnwindSafe, catch_unwind};

    #[test]
    fn vectors_are_written_within_the_shortest_column_only() {
        let (mut first, mut second) = ([0.0; 7], [0.0; 5]);
        let mut columns = Destination::new([&mut first[..], &mut second[..]]);
        assert_eq!(columns.rows(), 5);
        columns.put(0, 0, &[1.0, 2.0]);
        columns.put(1, 3, &[3.0, 4.0]);
        for (k, row) in [(0, 4), (1, 4), (0, 6), (1, usize::MAX), (2, 0)] {
            let put = catch_unwind(AssertUnwindSafe(|| columns.put(k, row, &[9.0, 9.0])));
            assert!(put.is_err(), "column {k}, row {row}");
        }
        assert_eq!(first, [1.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!(second, [0.0, 0.0, 0.0, 3.0, 4.0]);
        assert_eq!(Destination::<f64, 0>::new([]).rows(), 0);
    }
}
