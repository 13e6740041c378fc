//! Columns for the results of a sweep.

use alloc::vec::Vec;
use core::fmt;
use linkage_core::Scalar;

/// Bytes of a cache line.
const LINE: usize = 64;

/// A table in one contiguous buffer: columns of equal length, one per quantity, one row per
/// position.
///
/// The distance between columns is an odd number of cache lines, so that writing many columns at
/// once does not make them compete for the same place in the cache.
///
/// ```
/// use linkage_runtime::Columns;
///
/// let mut columns = Columns::<f64>::new(2, 3);
/// columns.set_row(0, [1.0, 10.0]);
/// columns.column_mut(1)[2] = 30.0;
/// assert_eq!(columns.get(0, 1), 10.0);
/// assert_eq!(columns.column(1)[2], 30.0);
/// assert!(columns.get(1, 0).is_nan());
/// ```
#[derive(Clone)]
pub struct Columns<T> {
    data: Vec<T>,
    /// Begin of the first column: at a cache line, unless this is a clone.
    start: usize,
    width: usize,
    len: usize,
    distance: usize,
}

impl<T: Scalar> Columns<T> {
    /// `width` columns of `len` values, all NaN.
    #[must_use]
    pub fn new(width: usize, len: usize) -> Self {
        let mut columns = Self::empty(width);
        columns.resize(len);
        columns
    }

    /// Changes the length; allocates only if the capacity is too small.
    ///
    /// With the same length nothing happens; otherwise all values become NaN.
    pub fn resize(&mut self, len: usize) {
        if len == self.len {
            return;
        }
        self.len = len;
        self.distance = distance(len, size_of::<T>());
        let unit = line(size_of::<T>());
        self.data.clear();
        self.data
            .resize(self.width * self.distance + unit - 1, T::from_f64(f64::NAN));
        let start = self.data.as_ptr().align_offset(LINE);
        self.start = if start < unit { start } else { 0 };
    }

    /// Writes a row.
    pub(crate) fn set<const W: usize>(&mut self, row: usize, numbers: [T; W]) {
        for (column, number) in numbers.into_iter().enumerate() {
            self.data[self.start + column * self.distance + row] = number;
        }
    }

    /// All columns, to write to: there are `W`.
    pub(crate) fn all_mut<const W: usize>(&mut self) -> [&mut [T]; W] {
        self.all_with_room(0)
    }

    /// All columns with `rows` rows each, if these are more and fit before the next column. Values
    /// after the last row are never read.
    pub(crate) fn all_with_room<const W: usize>(&mut self, rows: usize) -> [&mut [T]; W] {
        let len = self.len.max(rows.min(self.distance));
        let mut columns = self.data[self.start..].chunks_mut(self.distance.max(1));
        let columns = core::array::from_fn(|_| columns.next().unwrap_or_default());
        columns.map(|column| &mut column[..len])
    }
}

impl<T> Columns<T> {
    /// `width` columns without rows; nothing is allocated.
    pub(crate) fn empty(width: usize) -> Self {
        Self {
            data: Vec::new(),
            start: 0,
            width,
            len: 0,
            distance: 0,
        }
    }

    /// Length of every column: the number of rows.
    #[must_use]
    #[inline]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Returns true if there are no rows.
    #[must_use]
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Number of columns.
    #[must_use]
    #[inline]
    pub fn width(&self) -> usize {
        self.width
    }

    /// One column.
    ///
    /// # Panics
    /// If `index` is not below [`width`](Self::width).
    #[must_use]
    #[inline]
    pub fn column(&self, index: usize) -> &[T] {
        assert!(index < self.width, "column {index} of {}", self.width);
        &self.data[self.start + index * self.distance..][..self.len]
    }

    /// One column, to write to.
    ///
    /// # Panics
    /// If `index` is not below [`width`](Self::width).
    #[must_use]
    #[inline]
    pub fn column_mut(&mut self, index: usize) -> &mut [T] {
        assert!(index < self.width, "column {index} of {}", self.width);
        &mut self.data[self.start + index * self.distance..][..self.len]
    }

    /// Writes a row: the first value into the first column and so on; values beyond the last column
    /// are ignored.
    ///
    /// # Panics
    /// If `row` is not below [`len`](Self::len).
    #[inline]
    pub fn set_row(&mut self, row: usize, values: impl IntoIterator<Item = T>) {
        assert!(row < self.len, "row {row} of {}", self.len);
        let cells = self.data[self.start..]
            .iter_mut()
            .skip(row)
            .step_by(self.distance);
        cells.zip(values).for_each(|(cell, value)| *cell = value);
    }
}

impl<T: Copy> Columns<T> {
    /// One value.
    ///
    /// # Panics
    /// If `row` is not below [`len`](Self::len) or `column` not below [`width`](Self::width).
    #[must_use]
    #[inline]
    pub fn get(&self, row: usize, column: usize) -> T {
        self.column(column)[row]
    }
}

/// Distance between columns, in elements of `size` bytes: an odd number of cache lines, or of
/// elements where these are larger.
fn distance(len: usize, size: usize) -> usize {
    let unit = line(size);
    (len.div_ceil(unit) | 1) * unit
}

/// Elements of `size` bytes in a cache line, at least 1.
fn line(size: usize) -> usize {
    (LINE / size.max(1)).max(1)
}

impl<T: PartialEq> PartialEq for Columns<T> {
    fn eq(&self, other: &Self) -> bool {
        self.width == other.width
            && self.len == other.len
            && (0..self.width).all(|index| self.column(index) == other.column(index))
    }
}

impl<T: fmt::Debug> fmt::Debug for Columns<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let columns = (0..self.width).map(|index| self.column(index));
        f.debug_list().entries(columns).finish()
    }
}
