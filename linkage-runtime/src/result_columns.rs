//! Columns of the results of a function.

use core::fmt;
use core::marker::PhantomData;
use core::ops::Range;

use linkage_core::Scalar;

use crate::columns::Columns;
use crate::result_row::ResultRow;

/// Many results `R`, one column for each of their `W` numbers. The columns of each generated
/// function dereference to these.
pub struct ResultColumns<T, R, const W: usize> {
    columns: Columns<T>,
    result: PhantomData<fn() -> R>,
}

impl<T, R, const W: usize> ResultColumns<T, R, W> {
    /// The columns, to be filled.
    pub(crate) fn columns_mut(&mut self) -> &mut Columns<T> {
        &mut self.columns
    }

    /// The number of positions.
    #[must_use]
    pub fn len(&self) -> usize {
        self.columns.len()
    }

    /// Returns true before the first sweep, and after one over no position.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.columns.is_empty()
    }

    /// One column.
    ///
    /// # Panics
    ///
    /// Panics if `index` is not below `W`.
    #[must_use]
    pub fn column(&self, index: usize) -> &[T] {
        self.columns.column(index)
    }
}

impl<T: Scalar, R: ResultRow<T, W>, const W: usize> ResultColumns<T, R, W> {
    /// All quantities at one position, counted from 0.
    ///
    /// # Panics
    ///
    /// Panics if there is no such position.
    #[must_use]
    pub fn get(&self, index: usize) -> R {
        R::from_row(core::array::from_fn(|column| {
            self.columns.get(index, column)
        }))
    }

    /// All positions in order.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = R> + ExactSizeIterator + '_ {
        let rows: Range<usize> = 0..self.columns.len();
        rows.map(|row| self.get(row))
    }
}

/// Empty columns; nothing is allocated before the first sweep.
impl<T, R, const W: usize> Default for ResultColumns<T, R, W> {
    fn default() -> Self {
        Self {
            columns: Columns::empty(W),
            result: PhantomData,
        }
    }
}

impl<T: Clone, R, const W: usize> Clone for ResultColumns<T, R, W> {
    fn clone(&self) -> Self {
        Self {
            columns: self.columns.clone(),
            result: PhantomData,
        }
    }
}

impl<T: PartialEq, R, const W: usize> PartialEq for ResultColumns<T, R, W> {
    fn eq(&self, other: &Self) -> bool {
        self.columns == other.columns
    }
}

impl<T: fmt::Debug, R, const W: usize> fmt::Debug for ResultColumns<T, R, W> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.columns.fmt(f)
    }
}
